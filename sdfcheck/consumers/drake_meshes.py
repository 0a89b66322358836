"""Mesh files that Drake does not read in the role that they have."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from pathlib import PurePosixPath

from sdfcheck.consumers.drake_problems import UnsupportedMesh
from sdfcheck.formats.vendor.definitions import PASSED_OVER, REFUSED
from sdfcheck.source.element import Element, Value

_COLLISION = (".gltf", ".obj", ".vtk")
_RIGID = (".obj", ".vtk")
_DEFORMABLE = (".vtk",)
_SHOWN = (".gltf", ".obj")


def unsupported_meshes(meshes: Iterable[Element]) -> Iterator[UnsupportedMesh]:
    """``meshes`` are the elements ``mesh`` in the geometries of links."""
    for mesh in meshes:
        value = mesh.attribute("filename")
        if value is None and (uri := mesh.find("uri")) is not None:
            value = uri.own_value
        geometry = mesh.parent
        holder = None if geometry is None else geometry.parent
        if value is None or holder is None or "${" in value.text:
            continue
        suffix = PurePosixPath(value.text.strip()).suffix.lower()
        if suffix:
            yield from _judge(value, suffix, holder)


def _judge(value: Value, suffix: str, holder: Element) -> Iterator[UnsupportedMesh]:
    if holder.name == "visual":
        if suffix not in _SHOWN:
            yield UnsupportedMesh(value, "visual", _SHOWN, PASSED_OVER)
        return
    link = holder.parent
    properties = holder.find("drake:proximity_properties")
    role: str = "collision"
    formats: tuple[str, ...] = _COLLISION
    if link is not None and link.has("drake:deformable_properties"):
        role, formats = "deformable collision", _DEFORMABLE
    elif properties is not None and properties.has("drake:rigid_hydroelastic"):
        role, formats = "rigid hydroelastic collision", _RIGID
    if suffix not in formats:
        yield UnsupportedMesh(value, role, formats, REFUSED)

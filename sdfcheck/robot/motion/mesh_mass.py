"""Mass properties of closed meshes, measured by trimesh (the extra ``mesh``)."""

from __future__ import annotations

from typing import Any

import numpy as np

from sdfcheck.files.regular import oddity
from sdfcheck.files.uris import locate
from sdfcheck.formats.sdf.values import floats
from sdfcheck.robot.motion.mass_properties import MassProperties
from sdfcheck.source.element import Element


class MeshError(ValueError):
    """A mesh that cannot be measured."""


def mesh_body(mesh: Element, density: float) -> MassProperties:
    """A ``mesh`` element filled with a density (kg/m³), in the frame of its file.

    Raises MeshError where the file is missing, cannot be read or is not a closed surface, where
    only a part of it is meant, and where trimesh is not installed.
    """
    try:
        import trimesh
    except ImportError:
        raise MeshError("meshes need trimesh (install the extra `mesh`)") from None
    if mesh.has("submesh"):
        raise MeshError("the mass of a submesh cannot be computed")
    written = mesh.value("uri") or mesh.value("filename")
    uri = written.text.strip() if written is not None else ""
    path = locate(mesh.document, uri).path if uri else None
    if path is None:
        raise MeshError(f"there is no mesh `{uri}`")
    if why := oddity(path):
        raise MeshError(f"mesh `{uri}` is {why}")
    try:
        surface: Any = trimesh.load(path, force="mesh")
    except Exception as error:  # trimesh and its importers raise any kind
        raise MeshError(
            f"mesh `{uri}` cannot be read: {' '.join(str(error).split()) or type(error).__name__}"
        ) from None
    if not surface.is_watertight:
        raise MeshError(f"mesh `{uri}` is not closed")
    surface.apply_scale(_scale(mesh))
    surface.density = density
    if not surface.volume > 0:
        raise MeshError(f"mesh `{uri}` has its inside out")
    return MassProperties(
        float(surface.mass), np.array(surface.center_mass), np.array(surface.moment_inertia)
    )


def _scale(mesh: Element) -> tuple[float, ...]:
    scale = mesh.value("scale")
    numbers = floats(scale.text) if scale is not None and scale.text.strip() else (1.0, 1.0, 1.0)
    if numbers is None or len(numbers) != 3:
        raise MeshError("its scale is not 3 numbers")
    return numbers

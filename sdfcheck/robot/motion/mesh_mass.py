"""Mass properties of closed meshes."""

from __future__ import annotations

import numpy as np

from sdfcheck.bodies.solid import Unmeasured, solid_at
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
        solid = solid_at(path, _scale(mesh))
    except Unmeasured as error:
        raise MeshError(f"mesh `{uri}`: {error}") from None
    if not solid.is_closed:
        raise MeshError(f"mesh `{uri}` is not closed")
    if not solid.volume > 0:
        raise MeshError(f"mesh `{uri}` has its inside out")
    return MassProperties(density * solid.volume, np.array(solid.center), density * np.array(solid.moments))


def _scale(mesh: Element) -> tuple[float, ...]:
    scale = mesh.value("scale")
    numbers = floats(scale.text) if scale is not None and scale.text.strip() else (1.0, 1.0, 1.0)
    if numbers is None or len(numbers) != 3:
        raise MeshError("its scale is not 3 numbers")
    return numbers

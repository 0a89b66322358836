"""Mass properties of closed meshes."""

from __future__ import annotations

import numpy as np

from sdfcheck.bodies.solid import FORMATS, SIZE_LIMIT, Solid, Unmeasured, solid_of
from sdfcheck.files.library import library_of
from sdfcheck.files.regular import Unfit
from sdfcheck.files.uris import locate
from sdfcheck.formats.sdf.values import floats
from sdfcheck.robot.motion.mass_properties import MassProperties
from sdfcheck.source.document import Document
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
    solid = _solid(mesh.document, uri, _scale(mesh))
    if not solid.is_closed:
        raise MeshError(f"mesh `{uri}` is not closed")
    if not solid.volume > 0:
        raise MeshError(f"mesh `{uri}` has its inside out")
    return MassProperties(density * solid.volume, np.array(solid.center), density * np.array(solid.moments))


def _solid(document: Document, uri: str, scale: tuple[float, ...]) -> Solid:
    path = locate(document, uri).path if uri else None
    library = library_of(document)
    if path is None or library is None:
        raise MeshError(f"there is no mesh `{uri}`")
    folder, form = path.parent, path.suffix.lower().removeprefix(".")
    if form not in FORMATS:
        raise MeshError(f"mesh `{uri}` is in a format that is not measured")
    try:
        data = library.read(path, document, SIZE_LIMIT)
        return solid_of(data, form, scale, lambda name: library.read(folder / name, document, SIZE_LIMIT))
    except Unmeasured as error:
        separator = ":" if str(error).startswith("meshes") else ""
        raise MeshError(f"mesh `{uri}`{separator} {error}") from None
    except Unfit as error:
        raise MeshError(f"mesh `{uri}` is {error.strerror}") from None
    except OSError as error:
        raise MeshError(f"mesh `{uri}` is not read: {error.strerror}") from None


def _scale(mesh: Element) -> tuple[float, ...]:
    scale = mesh.value("scale")
    numbers = floats(scale.text) if scale is not None and scale.text.strip() else (1.0, 1.0, 1.0)
    if numbers is None or len(numbers) != 3:
        raise MeshError("its scale is not 3 numbers")
    return numbers

"""Mass, center of mass and inertia of links and robots."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping
from typing import TYPE_CHECKING

import numpy as np

from sdfcheck.bodies.solid import FORMATS, SIZE_LIMIT, Solid, Unmeasured, solid_of
from sdfcheck.files.library import library_of
from sdfcheck.files.regular import Unfit
from sdfcheck.files.uris import locate
from sdfcheck.formats.sdf.values import floats
from sdfcheck.robot.motion.origin import urdf_number
from sdfcheck.robot.motion.poses import Array, origin_of, written_pose
from sdfcheck.robot.values import MOMENTS
from sdfcheck.source.document import Document, Element
from sdfcheck.source.errors import DescriptionError
from sdfcheck.source.record import NamedTuple

if TYPE_CHECKING:
    from sdfcheck.robot.shapes import Geometry


class MassProperties(NamedTuple):
    """Mass (kg), center of mass (m) and inertia tensor (kg·m²) about it, in the axes of one frame."""

    mass: float
    center: Array
    """Shape (3,)."""
    moments: Array
    """About the center of mass, shape (3, 3)."""

    def seen_from(self, frame: Array) -> MassProperties:
        """The same body in an outer frame, in which this one's frame has the 4×4 pose ``frame``."""
        turn = frame[:3, :3]
        return MassProperties(self.mass, turn @ self.center + frame[:3, 3], turn @ self.moments @ turn.T)

    def scaled_to(self, mass: float) -> MassProperties:
        """The same body with another mass, evenly spread as before."""
        return MassProperties(mass, self.center, self.moments * (mass / self.mass))

    def joined_with(self, other: MassProperties) -> MassProperties:
        """Two bodies of one frame, rigidly joined."""
        mass = self.mass + other.mass
        if mass == 0:
            return MassProperties(0.0, self.center, self.moments + other.moments)
        center = (self.mass * self.center + other.mass * other.center) / mass
        moments = np.zeros((3, 3))
        for body in (self, other):
            offset = body.center - center
            shift = float(offset @ offset) * np.eye(3) - np.outer(offset, offset)
            moments += body.moments + body.mass * shift
        return MassProperties(mass, center, moments)


SMALL = MassProperties(1e-3, np.zeros(3), np.eye(3) * 1e-6)
"""A body too small to have an effect, for links that move and have no mass, which consumers refuse or drop."""


# Mass properties of closed meshes.


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


# Mass properties of links.


def default_mass() -> MassProperties:
    """The mass properties of a link of an SDF model without ``inertial``: 1 kg and unit moments."""
    return MassProperties(1.0, np.zeros(3), np.eye(3))


def of_sdf(inertial: Element, mass: float, moments: Mapping[str, float]) -> MassProperties:
    """The mass properties that an ``inertial`` of SDFormat writes, in the frame of its link.

    Raises DescriptionError where they cannot be worked out.
    """
    of_moments = tensor(*(moments[name] for name in MOMENTS))
    if not math.isfinite(mass) or not np.isfinite(of_moments).all():
        raise DescriptionError("the inertia is not finite", inertial)
    # A reference on an inertial's pose is ignored: the pose is in the link, whatever is written.
    pose = written_pose(inertial.find("pose"))
    return MassProperties(float(mass), np.zeros(3), of_moments).seen_from(pose)


def of_urdf(inertial: Element) -> MassProperties:
    """The mass properties that an ``inertial`` of URDF writes, in the frame of its link; raises DescriptionError."""
    mass, inertia = inertial.find("mass"), inertial.find("inertia")
    weight = urdf_number(mass, "value", 0.0) if mass is not None else 0.0
    moments = np.zeros((3, 3))
    if inertia is not None:
        moments = tensor(*(urdf_number(inertia, name, 0.0) for name in MOMENTS))
    return MassProperties(weight, np.zeros(3), moments).seen_from(origin_of(inertial))


def filled(geometry: Geometry, density: float, collision: Element) -> MassProperties:
    """The shape of a collision as a solid of a density (kg/m³), in its own frame.

    Raises DescriptionError for shapes that have no volume, and for meshes that cannot be measured.
    """
    solid = geometry.solid
    if solid is not None:
        mass = density * solid.volume
        return MassProperties(mass, np.array([0.0, 0.0, solid.center]), tensor(*solid.moments.times(mass)))
    if geometry.shape != "mesh" or geometry.shape_element is None:
        raise DescriptionError("its inertia cannot be computed: the collision is not a solid", collision)

    try:
        return mesh_body(geometry.shape_element, density)
    except MeshError as error:
        raise DescriptionError(f"its inertia cannot be computed: {error}", geometry.shape_element) from None


def joined(bodies: Iterable[MassProperties | None]) -> MassProperties | None:
    """Bodies of one frame, as far as they are known, rigidly joined; None if there are none."""
    total: MassProperties | None = None
    for body in bodies:
        if body is not None:
            total = body if total is None else total.joined_with(body)
    return total


def tensor(ixx: float, iyy: float, izz: float, ixy: float, ixz: float, iyz: float) -> Array:
    """The inertia tensor of six moments, shape (3, 3)."""
    return np.array([[ixx, ixy, ixz], [ixy, iyy, iyz], [ixz, iyz, izz]], dtype=float)

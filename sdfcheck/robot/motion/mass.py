"""Mass, center of mass and inertia of links and robots."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np

from sdfcheck.bodies.solid import FORMATS, SIZE_LIMIT, Solid, Unmeasured, solid_of
from sdfcheck.files.library import library_of
from sdfcheck.files.regular import Unfit
from sdfcheck.files.uris import locate
from sdfcheck.formats.sdf.values import floats
from sdfcheck.robot.motion import poses
from sdfcheck.robot.motion.origin import urdf_number
from sdfcheck.robot.motion.rotations import Array
from sdfcheck.robot.values import MOMENTS
from sdfcheck.source.document import Document, Element
from sdfcheck.source.errors import DescriptionError
from sdfcheck.source.record import NamedTuple

if TYPE_CHECKING:
    from sdfcheck.robot.graph import Model
    from sdfcheck.robot.parts.link import Inertial, Link
    from sdfcheck.robot.parts.shape import Collision


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


# Mass properties: of a link, of a model, of closed meshes.

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


# Mass properties: of a link, of a model, of everything.


def default_mass() -> MassProperties:
    """The mass properties of a link of an SDF model without ``inertial``: 1 kg and unit moments."""
    return MassProperties(1.0, np.zeros(3), np.eye(3))


def of_link(link: Link) -> MassProperties | None:
    """The mass properties of a link in its frame; None where the file gives none.

    Raises DescriptionError where they cannot be worked out.
    """
    inertial = link.inertial
    if not inertial.is_given:
        return None
    if link.is_urdf:
        return _of_urdf(inertial)
    if inertial.is_automatic:
        return automatic(link)
    moments = tensor(*(inertial.moments[name] for name in MOMENTS))
    if not math.isfinite(inertial.mass) or not np.isfinite(moments).all():
        raise DescriptionError("the inertia is not finite", inertial.element)
    # A reference on an inertial's pose is ignored: the pose is in the link, whatever is written.
    pose = poses.written_pose(inertial.find("pose"))
    return MassProperties(float(inertial.mass), np.zeros(3), moments).seen_from(pose)


def _of_urdf(inertial: Inertial) -> MassProperties:
    mass, inertia = inertial.find("mass"), inertial.inertia
    weight = urdf_number(mass, "value", 0.0) if mass is not None else 0.0
    moments = np.zeros((3, 3))
    if inertia is not None:
        moments = tensor(*(urdf_number(inertia, name, 0.0) for name in MOMENTS))
    return MassProperties(weight, np.zeros(3), moments).seen_from(poses.origin_of(inertial.element))


def automatic(link: Link) -> MassProperties:
    """The mass properties that ``auto="true"`` asks for: collisions filled evenly with their density.

    Raises DescriptionError for shapes that have no volume, and for meshes that cannot be measured.
    """
    inertial = link.inertial
    total: MassProperties | None = None
    for collision in link.collisions:
        density = collision.density if collision.density.is_given else inertial.density
        body = _filled(collision, float(density))
        body = body.seen_from(link.root.poses.of_part(collision.element, link))
        total = body if total is None else total.joined_with(body)
    if total is None:
        raise DescriptionError("its inertia cannot be computed: the link has no collision", link.element)
    wanted = inertial.mass
    if wanted.is_given and wanted > 0 and total.mass > 0:
        return MassProperties(float(wanted), total.center, total.moments * (float(wanted) / total.mass))
    return total


def _filled(collision: Collision, density: float) -> MassProperties:
    """A collision as a solid of a density (kg/m³), in its own frame."""
    geometry = collision.geometry
    solid = geometry.solid
    if solid is not None:
        mass = density * solid.volume
        return MassProperties(mass, np.array([0.0, 0.0, solid.center]), tensor(*solid.moments.times(mass)))
    if geometry.shape != "mesh" or geometry.shape_element is None:
        raise DescriptionError(
            "its inertia cannot be computed: the collision is not a solid", collision.element
        )

    try:
        return mesh_body(geometry.shape_element, density)
    except MeshError as error:
        raise DescriptionError(f"its inertia cannot be computed: {error}", geometry.shape_element) from None


def of_model(model: Model) -> MassProperties | None:
    """All links of a model and of the models in it, in its frame, all joints at zero; None without any mass."""
    total: MassProperties | None = None
    for link in model.all_links():
        body = of_link(link)
        if body is None and not link.is_urdf:
            body = default_mass()
        if body is not None:
            body = body.seen_from(model.root.poses.reached(model, link))
            total = body if total is None else total.joined_with(body)
    return total


def tensor(ixx: float, iyy: float, izz: float, ixy: float, ixz: float, iyz: float) -> Array:
    """The inertia tensor of six moments, shape (3, 3)."""
    return np.array([[ixx, ixy, ixz], [ixy, iyy, iyz], [ixz, iyz, izz]], dtype=float)

"""Mass properties: of a link, of a model, of everything."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np

from sdfcheck.robot.errors import DescriptionError
from sdfcheck.robot.motion import poses
from sdfcheck.robot.motion.mass_properties import MassProperties
from sdfcheck.robot.motion.origin import urdf_number
from sdfcheck.robot.motion.rotations import Array
from sdfcheck.robot.parts.inertial import MOMENTS

if TYPE_CHECKING:
    from sdfcheck.robot.model import Model
    from sdfcheck.robot.parts.inertial import Inertial
    from sdfcheck.robot.parts.link import Link
    from sdfcheck.robot.parts.shape import Collision


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
    from sdfcheck.robot.motion.mesh_mass import MeshError, mesh_body

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

"""Boxes around shapes, links and models, meshes included.

Without numpy, except for models and for poses relative to other frames: lint asks for them.
"""

from __future__ import annotations

import math
from collections.abc import Iterable
from typing import TYPE_CHECKING, Any

from sdfcheck.bodies.box import Box, around, of_points
from sdfcheck.robot.motion.origin import UNTURNED, Origin, numbers_of, origin_in, pose_in
from sdfcheck.robot.values import reference_of
from sdfcheck.source.errors import DescriptionError

if TYPE_CHECKING:
    from sdfcheck.robot.graph import Model, Part
    from sdfcheck.robot.motion.rotations import Array
    from sdfcheck.robot.parts.link import Link
    from sdfcheck.robot.parts.shape import Geometry, Shape
    from sdfcheck.source.document import Element


_MOST_FIXED = 100
"""Links fixed to one that are looked at."""


def of_shapes(shapes: Iterable[Shape]) -> Box | None:
    """The box around shapes in their link's frame; None without any of known size."""
    return around(shape.box for shape in shapes)


def of_shape(shape: Shape) -> Box | None:
    """The box in the link's frame around one shape's own box; None where size or place is not known."""
    own = shape.geometry.box
    if own is None:
        return None
    try:
        placed = placement_of(shape, shape.link)
    except DescriptionError:
        return None
    if placed.rotation is UNTURNED:
        return own.moved_by(placed.position)
    return of_points(placed.applied_to((x, y, z)) for x, y, z in own.corners())


def of_geometry(geometry: Geometry) -> Box | None:
    """The box around a geometry along its own axes; of what is round, around its own axes.

    None for planes, submeshes, meshes that are not there, and what cannot be read.
    """
    if geometry.shape == "mesh":
        return _of_mesh(geometry)
    if geometry.solid is None:
        return None
    radius, half = float(geometry.radius), float(geometry.length) / 2
    found: tuple[float, ...] | None = {
        "box": tuple(size / 2 for size in geometry.size),
        "sphere": (radius, radius, radius),
        "ellipsoid": tuple(geometry.radii),
        "cylinder": (radius, radius, half),
        "cone": (radius, radius, half),
        "capsule": (radius, radius, half + radius),
    }.get(geometry.shape)
    return None if found is None else Box(tuple(-length for length in found), found)


def _of_mesh(geometry: Geometry) -> Box | None:
    mesh, scale = geometry.mesh, geometry.scale
    if mesh is None or mesh.bounds is None or len(scale) != 3:
        return None
    found = mesh.bounds.scaled(scale)
    return found if found.diagonal < float("inf") else None


def with_fixed(link: Link) -> Box | None:
    """The box around a link and those that fixed joints of URDF tie to it, in its frame; None if one is unknown."""
    found = [link.extent]
    waiting = [(link, Origin())]
    while waiting:
        at, pose = waiting.pop()
        for joint in at.child_joints if link.is_urdf else ():
            child = joint.child_link
            if not joint.is_fixed or child is None or len(found) > _MOST_FIXED:
                continue
            try:
                placed = pose.followed_by(origin_in(joint.element))
            except DescriptionError:
                return None
            waiting.append((child, placed))
            if child.shapes:
                if child.extent is None:
                    return None
                found.append(of_points(placed.applied_to((x, y, z)) for x, y, z in child.extent.corners()))
    return around(found) if link.extent is not None else None


def distance_between(link: Link, other: Link) -> float:
    """How far the shapes of two links of URDF are apart at least (m), all joints at zero; 0 where that is not known.

    By the box around the one and that around the box of the other, in the frame of the first.
    """
    frame, pose = link.at_rest, other.at_rest
    if frame is None or pose is None or link.extent is None or other.extent is None:
        return 0.0
    corners = (frame.seen(pose.applied_to((x, y, z))) for x, y, z in other.extent.corners())
    return link.extent.distance_to(of_points(corners))


def placement_of(part: Part, link: Link) -> Origin:
    """The pose of a visual, collision or inertial in its link; raises DescriptionError."""
    if part.is_urdf:
        return origin_in(part.element)
    pose = part.find("pose") if part.is_given else None
    if not reference_of(pose) or part.kind == "inertial":
        return pose_in(pose)
    return origin_from(link.root.poses.of_part(part.element, link))


def origin_from(transform: Array) -> Origin:
    """A 4×4 transform in plain numbers."""
    (a, b, c, x), (d, e, f, y), (g, h, i, z), _ = transform.tolist()
    return Origin(((a, b, c), (d, e, f), (g, h, i)), (x, y, z))


def of_model(model: Model) -> Box | None:
    """The box in a model's frame around the boxes of all its links, all joints at zero; None without any.

    Raises PoseError.
    """
    corners: list[Any] = []
    for link in model.all_links():
        if (box := link.box) is not None:
            pose = origin_from(model.root.poses.reached(model, link))
            corners += (pose.applied_to((x, y, z)) for x, y, z in box.corners())
    return of_points(corners) if corners else None


def reach_of(model: Model) -> float:
    """The longest distance (m) between neighboring joints, or in SDFormat between links; 0 without any."""
    if not model.joints:
        return 0.0
    if model.is_urdf:
        written = (joint.element.find("origin") for joint in model.joints)
        places = [origin_position(origin) for origin in written if origin is not None]
        return max((math.hypot(*at) for at in places if at is not None), default=0.0)
    known = [at for link in model.links if (at := link.written_position) is not None]
    return max((math.dist(at, known[0]) for at in known), default=0.0) if len(known) > 1 else 0.0


def density_of(model: Model) -> float:
    """The mass of links by the volume of the boxes around their shapes (kg/m³); nan unless two of them have both."""
    mass = volume = 0.0
    count = 0
    for link in model.links:
        box = link.box if link.inertial.is_given else None
        if box is not None and link.inertial.mass.number > 0 and math.prod(box.size) > 0:
            mass += link.inertial.mass.number
            volume += math.prod(box.size)
            count += 1
    return mass / volume if count > 1 else math.nan


def origin_position(origin: Element) -> tuple[float, ...] | None:
    """The position (m) that an ``origin`` writes; None where it cannot be read."""
    try:
        return numbers_of(origin, "xyz", (0.0, 0.0, 0.0))
    except DescriptionError:
        return None


def as_array(box: Box | None) -> Array | None:
    """The lowest and highest x, y, z, shape (2, 3)."""
    import numpy as np

    return None if box is None else np.array([box.low, box.high])

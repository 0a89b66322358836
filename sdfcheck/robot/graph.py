"""The robot: models and worlds with their links, joints, sensors and all that knows of the others.

They are in one module as each of them names the others: a link its model, a model its links. It reads from what is
in a model to the model; :mod:`sdfcheck.robot.part` has what all of them are.
"""

from __future__ import annotations

import math
import re
from collections import Counter
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from contextlib import suppress
from itertools import combinations, permutations, product, takewhile
from typing import TYPE_CHECKING, Protocol, TypeVar, cast

from sdfcheck.files.library import digest_of, library_of
from sdfcheck.formats.schema import AttributeDefinition, Definition
from sdfcheck.formats.sdf.survey import version_of
from sdfcheck.formats.version import Version
from sdfcheck.robot import solids
from sdfcheck.robot.motion.origin import (
    UNTURNED,
    Origin,
    Triple,
    numbers_of,
    of_quaternion,
    origin_in,
    pose_in,
)
from sdfcheck.robot.naming.name import (
    DEFAULT,
    MODEL_FRAME,
    NODES,
    WORLD_FRAME,
    UnknownName,
    counts_on,
    mirrored,
    other_letter,
    without_sides,
)
from sdfcheck.robot.part import Frame, MergedFrame, Namespace, Node, Part, Setting, beside_of, pick
from sdfcheck.robot.resources import FileUse
from sdfcheck.robot.shapes import Geometry, Material, Surface, as_array
from sdfcheck.robot.solids import FITTING, INSIDE, LIGHT, NEAR, SOUND, Moments, Solid, quick_inertia
from sdfcheck.robot.values import (
    MOMENTS,
    Number,
    Vector,
    given_text,
    grouped,
    is_true,
    lazy,
    number,
    parts,
    reference_of,
    vector,
    word,
)
from sdfcheck.source.document import Document, Element, Value
from sdfcheck.source.errors import DescriptionError
from sdfcheck.source.record import NamedTuple
from sdfcheck.source.sniff import Kind
from sdfcheck.source.text import is_expression, pattern

if TYPE_CHECKING:
    from collections.abc import Collection

    from sdfcheck.bodies.box import Box
    from sdfcheck.bodies.solid import Skin
    from sdfcheck.formats.plugins import Naming, PluginFacts
    from sdfcheck.robot.controllers import (
        ControllerFile,
        ControllerNeed,
        Lacking,
        Misspelled,
        Mistyped,
        Parameter,
        WrittenDrive,
    )
    from sdfcheck.robot.includes.included import Included, Obstacle
    from sdfcheck.robot.motion.mass import MassProperties
    from sdfcheck.robot.motion.origin import Triple
    from sdfcheck.robot.motion.poses import Array, Pose
    from sdfcheck.source.text import Span


# Mass and inertia of links.


_BY_ROWS = ("ixx", "ixy", "ixz", "iyy", "iyz", "izz")
_DEFAULT_MOMENTS = (1.0, 1.0, 1.0, 0.0, 0.0, 0.0)


class Inertial(Part):
    """The mass properties of a link as they are written.

    In SDFormat what is missing is 1 kg and unit moments, in URDF nothing.
    """

    __slots__ = ()
    kind = "inertial"

    @property
    def link(self) -> Link:
        """The link."""
        return cast("Link", self.holder)

    @lazy
    def mass(self) -> Number:
        """kg."""
        if not self.is_urdf:
            return self._number("mass", 1.0)
        mass = self.find("mass")
        return Number.of(self._mass_value, mass if mass is not None else self.element, 0.0)

    @property
    def has_mass(self) -> bool:
        """Is the mass other than 0? In URDF a text that is not a number counts, for it is reported for itself."""
        if not self.is_urdf:
            return float(self.mass) != 0
        return self._mass_value is not None and self._mass_value.number != 0

    @lazy
    def _mass_value(self) -> Value | None:
        mass = self.find("mass")
        return mass.attribute("value") if mass is not None else None

    @lazy
    def inertia(self) -> Element | None:
        """The element ``inertia``."""
        return self.find("inertia")

    @property
    def moments_element(self) -> Element:
        """The element that holds the moments or would hold them."""
        return self.element if self.inertia is None else self.inertia

    @lazy
    def moments(self) -> dict[str, Number]:
        """ixx, iyy, izz, ixy, ixz, iyz (kg·m²) about the center of mass."""
        inertia = self.inertia
        holder = self.element if inertia is None else inertia
        found: dict[str, Number] = {}
        for name, default in zip(MOMENTS, _DEFAULT_MOMENTS, strict=True):
            value: Value | None = None
            if inertia is not None and self.is_urdf:
                value = inertia.attribute(name)
            elif inertia is not None and (child := inertia.find(name)) is not None:
                value = child.own_value
            found[name] = Number.of(value, holder, 0.0 if self.is_urdf else default)
        return found

    @lazy
    def is_legible(self) -> bool:
        """Are all moments finite numbers? In SDFormat some may be left out, but not misspelled."""
        moments, inertia = self.moments, self.inertia
        if not all(map(math.isfinite, [moment.number for moment in moments.values()])):
            return False
        left_out = [name for name, moment in moments.items() if not moment.is_given]
        if self.is_urdf or not left_out:
            return not left_out
        if inertia is None:
            return not self.misnamed("inertia")
        written = self.part(inertia)
        return not any(written.misnamed(name) or written.value(name) is not None for name in left_out)

    @property
    def missing_moments(self) -> tuple[str, ...]:
        """The names of the moments that an ``inertia`` of URDF does not write."""
        inertia = self.inertia
        if inertia is None or not self.is_urdf:
            return ()
        return tuple(name for name in _BY_ROWS if name not in inertia.attributes)

    @lazy
    def tensor(self) -> Moments:
        """The moments as simulators read them."""
        return Moments(*map(float, self.moments.values()))

    @lazy
    def principal(self) -> tuple[float, float, float]:
        """The principal moments (kg·m²), the smallest first."""
        return self.tensor.principal()

    @lazy
    def solid_trace(self) -> float:
        """The trace (kg·m²) that its mass has when it fills the solids of the link evenly; nan if there are none.

        Where there are meshes alone, each counts as the box around it.
        """
        center, mass = self.center, self.mass.number
        parts = self._solid_parts if center is not None else ()
        if center is None or not parts:
            return math.nan
        volume = sum(solid.volume for solid, _ in parts)
        trace = 0.0
        for solid, at in parts:
            distance = math.dist(at, center)
            trace += mass * solid.volume / volume * (solid.moments.trace + 2 * distance * distance)
        return trace

    @property
    def _solid_parts(self) -> list[tuple[Solid, tuple[float, ...]]]:
        """The solids of the link with their centers; without any, the boxes around its meshes."""
        link = self.link
        placed = [(shape.geometry.solid, shape.position) for shape in link.solids]
        found: list[tuple[Solid, tuple[float, ...]]]
        found = [(solid, at) for solid, at in placed if solid is not None and at is not None]
        if found or not link.has_mesh or link.extent is None:
            return found
        boxes = (shape.box for shape in link.collisions or link.visuals)
        return [(solids.box(*box.size), box.center) for box in boxes if box is not None and all(box.size)]

    @property
    def is_automatic(self) -> bool:
        """Does the simulator compute it from the collisions (``auto="true"``)?"""
        return not self.is_urdf and is_true(self._text("auto") or "")

    density = number("density", 1000.0, "kg/m³, for an automatic inertia.")

    @lazy
    def center(self) -> tuple[float, float, float] | None:
        """The center of mass in the link's frame (m); None where that is not plain to read."""
        return self.written_position

    @property
    def is_unremarkable(self) -> bool:
        """Are mass and moments surely those of a body, near to those of a solid of the link's shapes?

        Worked out quickly; False proves nothing.
        """
        return bool(self._sure_facts & SOUND)

    @property
    def fits_shapes(self) -> bool:
        """Are they also near to those of the link's primitive shapes, axis by axis? False proves nothing."""
        return bool(self._sure_facts & FITTING)

    @property
    def is_inside(self) -> bool:
        """Is the center of mass surely inside of a primitive shape? False proves nothing."""
        return bool(self._sure_facts & INSIDE)

    @property
    def is_light(self) -> bool:
        """Is the mass surely that of a material that fills its primitive shapes? False proves nothing."""
        return bool(self._sure_facts & LIGHT)

    @property
    def is_near(self) -> bool:
        """Are the moments surely at most twice those of a solid of its primitive shapes? False proves nothing."""
        return bool(self._sure_facts & NEAR)

    @lazy
    def _sure_facts(self) -> int:
        return quick_inertia(self.link.element) if self.is_given else 0


# Links.


class Link(Node):
    """A rigid body."""

    __slots__ = ()
    kind = "link"

    @property
    def model(self) -> Model:
        """The model that it is part of."""
        return cast("Model", self.holder)

    @property
    def is_static(self) -> bool:
        """Is it part of something that does not move?"""
        return bool(getattr(self.holder, "is_static", False))

    @property
    def may_be_static(self) -> bool:
        """Is it part of something that does not move, or of which that cannot be read?"""
        return bool(getattr(self.holder, "may_be_static", False))

    @lazy
    def inertial(self) -> Inertial:
        """Its mass and inertia; with ``is_given`` False where nothing is written."""
        return self._only("inertial", Inertial)

    @property
    def has_mass(self) -> bool:
        """Is its mass other than 0? In URDF a text that is not a number counts, for it is reported for itself."""
        return self.inertial.has_mass

    visuals: lazy[tuple[Visual, ...]] = parts("visual", "The visible shape of it.")
    collisions: lazy[tuple[Collision, ...]] = parts("collision", "The shape of it that touches other things.")

    @property
    def shapes(self) -> tuple[Shape, ...]:
        """Its visuals and collisions."""
        return (*self.visuals, *self.collisions)

    @lazy
    def solids(self) -> tuple[Shape, ...]:
        """The primitive shapes whose place in it is known: of its collisions, or of its visuals if it has none.

        None where xacro may add more.
        """
        if self.document.kind is Kind.XACRO or self.is_unfinished:
            return ()
        shapes: tuple[Shape, ...] = self.collisions or self.visuals
        return tuple(
            shape for shape in shapes if shape.geometry.solid is not None and shape.position is not None
        )

    @property
    def sensors(self) -> tuple[Sensor, ...]:
        """Its sensors; in URDF those of the ``<gazebo>`` blocks about it."""
        blocks = (sensor for block in self.gazebo_blocks for sensor in block.sensors)
        return (*(() if self.is_urdf else self._parts("sensor")), *blocks)

    @property
    def lights(self) -> tuple[Light, ...]:
        """Its lights; in URDF those of the ``<gazebo>`` blocks about it."""
        blocks = (light for block in self.gazebo_blocks for light in block.lights)
        return (*(() if self.is_urdf else self._parts("light")), *blocks)

    @property
    def plugins(self) -> tuple[Plugin, ...]:
        """The plugins of the ``<gazebo>`` blocks about it."""
        return tuple(plugin for block in self.gazebo_blocks for plugin in block.plugins)

    @property
    def gazebo_blocks(self) -> tuple[GazeboBlock, ...]:
        """The ``<gazebo>`` blocks about it, in URDF."""
        return tuple(self.model.blocks_by_reference.get(self.name, ())) if self.is_urdf else ()

    @lazy
    def box(self) -> Box | None:
        """The box around its collisions, or its visuals where it has none of known size (m), in plain numbers."""
        return _around(self.collisions) or _around(self.visuals)

    @property
    def bounds(self) -> Array | None:
        """The box around its collisions, or its visuals where it has none: lowest and highest x, y, z.

        In m, in its frame, shape (2, 3), meshes included; None where no shape has a known size.
        """
        return as_array(self.box)

    @lazy
    def visual_box(self) -> Box | None:
        """The box around its visuals (m); None unless the size of each of them is known."""
        return self._around_all(self.visuals)

    @lazy
    def collision_box(self) -> Box | None:
        """The box around its collisions (m); None unless the size of each of them is known."""
        return self._around_all(self.collisions)

    @lazy
    def extent(self) -> Box | None:
        """The box around its visuals and collisions (m); of either kind only if the size of each is known."""
        from sdfcheck.bodies.box import around

        return around((self.visual_box, self.collision_box))

    @lazy
    def fixed_extent(self) -> Box | None:
        """The same, with the links that fixed joints of URDF tie to it from below; None unless all are known."""
        return None if self.document.is_open else _with_fixed(self)

    @lazy
    def ball(self) -> tuple[Triple, float] | None:
        """The center and radius (m) of a ball around its shapes, in its robot of URDF at rest; None if not known."""
        pose, extent = self.at_rest, self.extent
        if pose is None or extent is None:
            return None
        x, y, z = extent.center
        return pose.applied_to((x, y, z)), extent.diagonal / 2

    def distance_to(self, other: Link) -> float:
        """How far the shapes of another link are from its own (m), at least, all joints at zero; 0 if not known.

        In URDF, by the box around the one and that around the box of the other, in the frame of this one.
        """
        frame, pose = self.at_rest, other.at_rest
        if frame is None or pose is None or self.extent is None or other.extent is None:
            return 0.0
        from sdfcheck.bodies.box import of_points

        corners = (frame.seen(pose.applied_to((x, y, z))) for x, y, z in other.extent.corners())
        return self.extent.distance_to(of_points(corners))

    @property
    def at_rest(self) -> Origin | None:
        """Its pose in its robot of URDF with all joints at zero, in plain numbers; None where that is not known."""
        return self.model.poses_at_rest.get(self)

    @lazy
    def skin(self) -> Skin | None:
        """The surface of its visuals, or else of its collisions, in its robot of URDF at rest; None if not known."""
        return _skin_of(self, self.visuals or self.collisions, self.at_rest)

    @lazy
    def filled(self) -> tuple[float, ...] | None:
        """The moments ixx, iyy, izz, ixy, ixz and iyz (m²) that 1 kg has when it fills its visuals evenly.

        Of its collisions if it has no visuals; about their center, along the axes of the link. None if not known.
        """
        shapes = self.visuals or self.collisions
        if all(shape.geometry.solid is not None for shape in shapes):
            return _filled(self, shapes)
        skin = _skin_of(self, shapes, Origin())
        return skin.filled if skin is not None else None

    def is_in(self, other: Link, share: float, poses: Mapping[Link, Origin] | None = None) -> bool:
        """Is more than that share of the surface of its collisions in those of another one, or the other way around?

        In their robot of URDF, at rest or with these poses.
        """
        known = self.model.poses_at_rest if poses is None else poses
        mine, theirs = (_skin_of(link, link.collisions, known.get(link)) for link in (self, other))
        if mine is None or theirs is None:
            return False
        return mine.share_in(theirs, share) > share or theirs.share_in(mine, share) > share

    @lazy
    def look(self) -> tuple[object, ...]:
        """Its meshes and where they are in it; the same for links that are made of the same part."""
        return tuple(
            (shape.geometry.uri, tuple(shape.geometry.scale), shape.position, shape.along)
            for shape in self.shapes
            if shape.geometry.shape == "mesh"
        )

    @lazy
    def rigid_group(self) -> tuple[Link, ...]:
        """The link and those that fixed joints tie to it."""
        found, waiting = {self: None}, [self]
        while waiting:
            at = waiting.pop()
            fixed = (joint for joint in (*at.parent_joints, *at.child_joints) if joint.is_fixed)
            for other in (end for joint in fixed for end in (joint.parent_link, joint.child_link)):
                if other is not None and other not in found:
                    found[other] = None
                    waiting.append(other)
        return tuple(found)

    def _around_all(self, shapes: tuple[Shape, ...]) -> Box | None:
        """The box around shapes that are all known; None where xacro may add more."""
        if self.document.kind is Kind.XACRO or self.is_unfinished:
            return None
        return _around(shapes) if all(shape.box is not None for shape in shapes) else None

    @lazy
    def has_mesh(self) -> bool:
        """Has it a shape whose mesh file is there?"""
        if not self.document.source.contains("<mesh") and not self.document.source.contains(":mesh"):
            return False
        return any(shape.geometry.mesh is not None for shape in self.shapes)

    @lazy
    def size_to_reach(self) -> float:
        """Its greatest length to the longest distance between joints of its model; nan where one is not known."""
        reach = self.model.reach if self.holder is not None and self.holder.kind == "model" else 0.0
        box = self.box if reach else None
        return max(box.size) / reach if box is not None else math.nan

    @property
    def counterparts(self) -> tuple[Link, ...]:
        """The other links of its model whose names differ only by the side: those of the other wheels or legs."""
        key = without_sides(self.name)
        links = self.model.links_of_each_side.get(key, ()) if key != self.name else ()
        return tuple(link for link in links if link is not self)

    # How it hangs together with others

    @property
    def parent_joints(self) -> tuple[Joint, ...]:
        """The joints whose child it is; more than one is a mistake, or closes a loop."""
        return tuple(self.holder.tree.parents.get(self, ())) if isinstance(self.holder, Model) else ()

    @property
    def child_joints(self) -> tuple[Joint, ...]:
        """The joints whose parent it is."""
        return tuple(self.holder.tree.children.get(self, ())) if isinstance(self.holder, Model) else ()

    def below(self) -> Iterator[Link]:
        """The link and all links that hang on it, each once."""
        return self.model.tree.below(self)

    @property
    def mass_properties(self) -> MassProperties | None:
        """Mass (kg), center of mass (m) and inertia (kg·m²) in its frame; None where the format gives none.

        An inertia that the simulator computes (``auto="true"``) is computed. Raises
        DescriptionError for numbers that cannot be read and shapes that cannot be measured.
        """
        inertial = self.inertial
        if not inertial.is_given:
            return None
        from sdfcheck.robot.motion.mass import of_sdf, of_urdf

        if self.is_urdf:
            return of_urdf(inertial.element)
        if inertial.is_automatic:
            return self.automatic_mass()
        return of_sdf(inertial.element, inertial.mass, inertial.moments)

    def automatic_mass(self) -> MassProperties:
        """The mass properties that ``auto="true"`` asks for: collisions filled evenly with their density.

        Raises DescriptionError for shapes that have no volume, and for meshes that cannot be measured.
        """
        from sdfcheck.robot.motion.mass import filled, joined

        inertial = self.inertial
        poses = self.root.poses
        bodies: list[MassProperties] = []
        for collision in self.collisions:
            density = collision.density if collision.density.is_given else inertial.density
            body = filled(collision.geometry, float(density), collision.element)
            bodies.append(body.seen_from(poses.of_part(collision.element, self)))
        total = joined(bodies)
        if total is None:
            raise DescriptionError("its inertia cannot be computed: the link has no collision", self.element)
        wanted = inertial.mass
        return total.scaled_to(float(wanted)) if wanted.is_given and wanted > 0 and total.mass > 0 else total

    @property
    def urdf_base(self) -> tuple[Node | None, Element | None]:
        for joint in self.parent_joints:
            return joint.parent, joint.element
        return super().urdf_base


def _around(shapes: Iterable[Shape]) -> Box | None:
    """The box around shapes in their link's frame; None without any of known size."""
    from sdfcheck.bodies.box import around

    return around(shape.box for shape in shapes)


_MOST_FIXED = 100
"""Links fixed to one that are looked at."""


def _with_fixed(link: Link) -> Box | None:
    """The box around a link and those that fixed joints of URDF tie to it, in its frame; None if one is unknown."""
    from sdfcheck.bodies.box import around, of_points

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


def _skin_of(link: Link, shapes: Sequence[Shape], frame: Origin | None) -> Skin | None:
    """The surface of shapes of a link that has this pose; None if not known."""
    from sdfcheck.robot.motion.mechanism import placed

    if frame is None or link.document.kind is Kind.XACRO or link.is_unfinished:
        return None
    try:
        return placed(
            (shape.geometry.skin, frame.followed_by(_placement_in(shape, link))) for shape in shapes
        )
    except DescriptionError:
        return None


def _filled(link: Link, shapes: Sequence[Shape]) -> Moments | None:
    """The moments of 1 kg that fills plain shapes of a link evenly, about their center; None if not known."""
    if link.document.kind is Kind.XACRO or link.is_unfinished:
        return None
    parts = []
    try:
        for shape in shapes:
            if (solid := shape.geometry.solid) is not None:
                pose = _placement_in(shape, link)
                parts.append((solid.volume, pose.applied_to((0.0, 0.0, solid.center)), pose, solid.moments))
    except DescriptionError:
        return None
    volume = math.fsum(part[0] for part in parts)
    if not 0 < volume < math.inf:
        return None
    center = [math.fsum(part[0] * part[1][axis] for part in parts) / volume for axis in range(3)]
    found = Moments(0.0, 0.0, 0.0)
    for own, place, pose, moments in parts:
        x, y, z = (at - middle for at, middle in zip(place, center, strict=True))
        found = found.plus(pose.turned_moments(moments).moved(1.0, x, y, z).times(own / volume))
    return found


def _placement_in(part: Part, link: Link) -> Origin:
    """The pose of a visual or collision in its link; raises DescriptionError."""
    if part.is_urdf:
        return origin_in(part.element)
    pose = part.find("pose") if part.is_given else None
    if not reference_of(pose):
        return pose_in(pose)
    from sdfcheck.robot.motion.poses import origin_from

    return origin_from(link.root.poses.of_part(part.element, link))


# Shapes and materials: what is seen of a link, and what it touches others with.


class Shape(Part):
    """A visual or a collision of a link."""

    __slots__ = ()

    @property
    def link(self) -> Link:
        """The link that it belongs to."""
        return cast("Link", self.holder)

    @lazy
    def geometry(self) -> Geometry:
        """Its shape."""
        return self._only("geometry", Geometry)

    @property
    def plugins(self) -> tuple[Plugin, ...]:
        return () if self.is_urdf else tuple(self._parts("plugin"))

    @property
    def position(self) -> tuple[float, float, float] | None:
        """Where its origin is in the link's frame (m); None where its pose alone does not determine that."""
        return self.written_position

    @property
    def along(self) -> tuple[float, float, float] | None:
        """The direction of its z axis in its link's frame; None where that cannot be worked out."""
        try:
            return _placement_in(self, self.link).turned((0.0, 0.0, 1.0))
        except DescriptionError:
            return None

    @lazy
    def box(self) -> Box | None:
        """The box around it in its link's frame (m), in plain numbers; None where size or place is not known."""
        own = self.geometry.box
        if own is None:
            return None
        try:
            placed = _placement_in(self, self.link)
        except DescriptionError:
            return None
        if placed.rotation is UNTURNED:
            return own.moved_by(placed.position)
        from sdfcheck.bodies.box import of_points

        return of_points(placed.applied_to((x, y, z)) for x, y, z in own.corners())

    @property
    def bounds(self) -> Array | None:
        """The box around it in its link's frame: lowest and highest x, y, z (m), shape (2, 3).

        Of round shapes and of meshes the box around their own axes counts. None where size or place is not
        known: of planes, submeshes, and meshes that are not found or cannot be read.
        """
        return as_array(self.box)

    def pose(self, relative_to: str | None = None) -> Pose:
        """Its pose in the link's frame, or relative to what a reference names; raises PoseError."""
        return self.root.poses.of_part_in(self.element if self.is_given else None, self.link, relative_to)


class Visual(Shape):
    """The visible shape of a link."""

    __slots__ = ()
    kind = "visual"

    @lazy
    def material(self) -> Material:
        """Its material; in URDF the first of its name that says what it looks like, as the others do not count."""
        own = self.own_material
        model = self.within(Model) if self.is_urdf and own.name else None
        if model is None:
            return own
        found = model.material_names.defined.get(own.name, own)
        return found if found.has_look else own

    @lazy
    def own_material(self) -> Material:
        """Its material as it is written in it, maybe only a name."""
        return self._only("material", Material)


class Collision(Shape):
    """The shape of a link that touches other things."""

    __slots__ = ()
    kind = "collision"

    @lazy
    def surface(self) -> Surface:
        """How it slides and bounces, in SDFormat."""
        return self._only("surface", Surface)

    density = number("density", 1000.0, "kg/m³, for an automatic inertia.")


# Boxes around shapes, links and models, meshes included.
#
# Without numpy, except for models and for poses relative to other frames: lint asks for them.


def _reach_of(model: Model) -> float:
    """The longest distance (m) between neighboring joints, or in SDFormat between links; 0 without any."""
    if not model.joints:
        return 0.0
    if model.is_urdf:
        written = (joint.element.find("origin") for joint in model.joints)
        places = [_origin_position(origin) for origin in written if origin is not None]
        return max((math.hypot(*at) for at in places if at is not None), default=0.0)
    known = [at for link in model.links if (at := link.written_position) is not None]
    return max((math.dist(at, known[0]) for at in known), default=0.0) if len(known) > 1 else 0.0


def _density_of(model: Model) -> float:
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


def _origin_position(origin: Element) -> tuple[float, ...] | None:
    """The position (m) that an ``origin`` writes; None where it cannot be read."""
    try:
        return numbers_of(origin, "xyz", (0.0, 0.0, 0.0))
    except DescriptionError:
        return None


# Axes of joints: directions, limits, dynamics, and joints that follow others.


ENDLESS = 1e15
"""Limits from here on mean none: before 1.10 the format writes 1e16 for infinity."""
_FIVE, _SEVEN = Version(1, 5), Version(1, 7)


class _AxisPart(Part):
    """Something that belongs to an axis: in URDF it is written in the joint."""

    __slots__ = ()

    @property
    def joint(self) -> Joint:
        """The joint."""
        at = self.holder
        while at is not None and at.kind != "joint":
            at = at.holder
        assert at is not None, "axes are made in joints only"
        return cast("Joint", at)

    @property
    def axis(self) -> Axis:
        """The axis that it belongs to."""
        return self.holder if isinstance(self.holder, Axis) else self.joint.axis


class Axis(Part):
    """A direction that a joint turns about or moves along."""

    __slots__ = ()
    kind = "axis"

    @property
    def joint(self) -> Joint:
        """The joint that it belongs to."""
        return cast("Joint", self.holder)

    @property
    def name(self) -> str:
        """``axis`` or ``axis2``."""
        return self.element.name if self.is_given else "axis"

    @property
    def xyz(self) -> Vector:
        """The direction as written, of any length."""
        return self._vector("xyz", (1.0, 0.0, 0.0) if self.is_urdf else (0.0, 0.0, 1.0))

    @lazy
    def length(self) -> float:
        """The length of the direction as written; nan where that is not three finite numbers."""
        xyz = self.xyz
        length = math.hypot(*xyz) if len(xyz) == 3 else math.nan
        return length if length < math.inf else math.nan

    @property
    def expressed_in(self) -> str:
        """The name of the frame in which the direction is written; empty: that of the joint.

        Up to 1.4, and in 1.5 and 1.6 with ``use_parent_model_frame``, it is that of the model. Source: libsdformat 17.
        """
        xyz = self.find("xyz") if not self.is_urdf else None
        written = xyz.attributes.get("expressed_in", "").strip() if xyz is not None else ""
        if written or self.is_urdf or (version := version_of(self.document)) >= _SEVEN:
            return written
        flag = self.find("use_parent_model_frame")
        return MODEL_FRAME if version < _FIVE or (flag is not None and is_true(flag.content)) else ""

    @property
    def _owner(self) -> Part:
        return self.joint if self.is_urdf else self

    @lazy
    def limit(self) -> Limit:
        """How far, how fast and how strongly the joint moves."""
        return self._owner._only("limit", Limit)

    @lazy
    def dynamics(self) -> Dynamics:
        """Damping, friction and spring."""
        return self._owner._only("dynamics", Dynamics)

    @lazy
    def mimic(self) -> Mimic | None:
        """Which joint the axis follows; None if it follows none."""
        found = self._owner._only("mimic", Mimic)
        return found if found.is_given else None


class Limit(_AxisPart):
    """The limits of an axis, in rad or m, N or N·m, rad/s or m/s."""

    __slots__ = ()
    kind = "limit"

    @lazy
    def lower(self) -> Number:
        """The lowest position; without limit -inf, in URDF 0 where only the rest is written."""
        return self._number("lower", 0.0 if self.is_urdf and self.is_given else -math.inf)

    @lazy
    def upper(self) -> Number:
        """The highest position; without limit inf, in URDF 0 where only the rest is written."""
        return self._number("upper", 0.0 if self.is_urdf and self.is_given else math.inf)

    effort = number(
        "effort", math.inf, "The greatest force or torque; in SDFormat a negative one means unlimited."
    )
    velocity = number("velocity", math.inf, "The greatest speed; in SDFormat a negative one means unlimited.")
    stiffness = number("stiffness", 1e8, "The stiffness of the stops, in SDFormat.")
    dissipation = number("dissipation", 1.0, "The dissipation of the stops, in SDFormat.")

    @property
    def range(self) -> tuple[float, float]:
        """The lowest and the highest position as simulators take them: infinite where there is no limit."""
        if self.is_urdf and self.joint.type not in {"revolute", "prismatic"}:
            return -math.inf, math.inf
        return _endless(self.lower), _endless(self.upper)

    @property
    def greatest_effort(self) -> float:
        """The effort as simulators take it: infinite where there is no limit."""
        return _unlimited(self.effort)

    @property
    def greatest_velocity(self) -> float:
        """The velocity as simulators take it: infinite where there is no limit."""
        return _unlimited(self.velocity)


class Dynamics(_AxisPart):
    """The resistance to motion along an axis."""

    __slots__ = ()
    kind = "dynamics"

    damping = number("damping", 0.0, "N·m·s/rad or N·s/m.")
    friction = number("friction", 0.0, "N·m or N.")
    spring_reference = number(
        "spring_reference", 0.0, "The position at which the spring is at rest, in SDFormat."
    )
    spring_stiffness = number("spring_stiffness", 0.0, "N·m/rad or N/m, in SDFormat.")


class Mimic(_AxisPart):
    """An axis that follows another: position = multiplier · (position of the leader - reference) + offset."""

    __slots__ = ()
    kind = "mimic"

    @property
    def leader_value(self) -> Value | None:
        """The name of the joint that it follows, with its place; None where there is no name."""
        value = self.attribute("joint")
        return value if value is not None and value.text.strip() else None

    @property
    def leader_name(self) -> str:
        """The name of the joint that it follows."""
        return self.leader_value.text.strip() if self.leader_value is not None else ""

    @property
    def leader(self) -> Joint | None:
        """The joint that it follows; None if the name is not that of a joint."""
        model = self.joint.model
        if self.is_urdf:  # where joints and links have names of their own
            name = self.leader_value.text if self.leader_value is not None else ""
            return model.joints_by_name.get(name) if model is not None and name else None
        found = self.joint.look_up(self.leader_name) if self.leader_name else None
        return cast("Joint", found) if found is not None and found.kind == "joint" else None

    @property
    def leader_guess(self) -> str | None:
        """The joint that it was probably meant to follow, where the name is not that of a joint."""
        joint, model = self.joint, self.joint.model
        if not self.is_urdf or model is None:
            return joint.scope.guess(self.leader_name, but=(joint.name,), kind="joint").meant
        from sdfcheck.formats.near_names import nearest

        candidates = (name for name in model.joints_by_name if name != joint.name)
        return nearest(self.leader_name, candidates, self.document)

    @property
    def leads_into_ring(self) -> bool:
        """Do its leaders follow each other without end?"""
        seen: set[Mimic] = set()
        at: Mimic | None = self
        while at is not None and at not in seen:
            seen.add(at)
            at = at.next
        return at is not None

    @property
    def is_without_axis(self) -> bool:
        """Does its leader lack the axis that it follows?"""
        leader = self.leader
        if leader is None or self.is_urdf:
            return False
        return self.leader_axis not in {"axis", "axis2"} or not leader.has(self.leader_axis)

    @property
    def next(self) -> Mimic | None:
        """The mimic of the axis that it follows: that axis follows another one, in turn."""
        leader = self.leader
        if leader is None or self.is_without_axis:
            return None
        return leader.axis2.mimic if self.leader_axis == "axis2" else leader.axis.mimic

    @property
    def leader_axis(self) -> str:
        """The axis of the leader that it follows: ``axis`` or ``axis2``."""
        return (self._text("axis") or "").strip() or "axis"

    multiplier = number("multiplier", 1.0)
    offset = number("offset", 0.0)
    reference = number(
        "reference", 0.0, "In SDFormat: the position of the leader at which this one is at the offset."
    )


def _endless(value: float) -> float:
    return math.copysign(math.inf, value) if abs(value) >= ENDLESS else float(value)


def _unlimited(value: float) -> float:
    return math.inf if value < 0 or value >= ENDLESS else float(value)


# Joints.


UNCONVERTED = frozenset({"floating", "planar"})
"""The types of URDF that SDFormat does not have: libsdformat drops such joints."""

MOVING_IN_URDF = frozenset({"revolute", "continuous", "prismatic"}) | UNCONVERTED

PRESERVING = ("preserveFixedJoint", "disableFixedJointLumping")
"""The settings in ``<gazebo>`` that keep a fixed joint."""

AXES = {
    "revolute": 1,
    "continuous": 1,
    "prismatic": 1,
    "screw": 1,
    "gearbox": 2,
    "revolute2": 2,
    "universal": 2,
    "ball": 0,
    "fixed": 0,
}
"""Type in SDFormat → the number of axes that the joint moves about or along."""


class Reach(NamedTuple):
    """The largest share of a part that is in the parent of its joint, in the joint's range; and the other way."""

    within: float
    opposite: float


_SAME = 0.05
"""Of the range: limits are as far to both sides if they differ less."""


class Joint(Node):
    """A joint between two links; in URDF also Drake's ``drake:joint``."""

    __slots__ = ()
    kind = "joint"

    @lazy
    def type(self) -> str:
        """The type as simulators compare it: in SDFormat small letters, without spaces; empty if there is none."""
        text = self._text("type") or ""
        return text if self.is_urdf else text.strip().lower()

    type_value = given_text("type", "The type with its place.")

    @property
    def scope(self) -> Scope:
        return cast("Scope", super().scope)

    @property
    def is_fixed(self) -> bool:
        """Does it not let its child move?"""
        return self.type == "fixed"

    @property
    def is_unconverted(self) -> bool:
        """In URDF: does libsdformat drop it, as SDFormat does not have its type?"""
        return self.is_urdf and self.type in UNCONVERTED

    @property
    def is_replaced(self) -> bool:
        """In URDF: do ``<gazebo>`` blocks give Gazebo a joint or frame of its name?"""
        extended = self.model.extended if self.model is not None else None
        others = (*extended.children("joint"), *extended.children("frame")) if extended is not None else ()
        return any(other.get("name") == self.name for other in others)

    @property
    def is_preserved(self) -> bool:
        """Does a ``<gazebo>`` block make libsdformat keep it although it is fixed?"""
        return any(block.is_on(name) for block in self.gazebo_blocks for name in PRESERVING)

    @property
    def is_lumped(self) -> bool:
        """In URDF: does libsdformat merge its child into its parent?"""
        return self.is_urdf and self.is_fixed and self.parent_name != "world" and not self.is_preserved

    @property
    def is_for_drake_only(self) -> bool:
        """Is it a ``drake:joint``, which nobody but Drake sees?"""
        return self.element.name == "drake:joint"

    @property
    def model(self) -> Model | None:
        """The model that it is in; None in a world."""
        return cast("Model", self.holder) if self.holder is not None and self.holder.kind == "model" else None

    # Ends

    @lazy
    def parent_value(self) -> Value | None:
        """The name of its parent with its place; None where there is no name."""
        return self._end("parent")

    @lazy
    def child_value(self) -> Value | None:
        """The name of its child with its place; None where there is no name."""
        return self._end("child")

    @property
    def parent_name(self) -> str:
        """The name of its parent as written."""
        return self.parent_value.text if self.parent_value is not None else ""

    @property
    def child_name(self) -> str:
        """The name of its child as written."""
        return self.child_value.text if self.child_value is not None else ""

    @lazy
    def parent(self) -> Node | None:
        """The link, frame, model or world that its parent names; None if that is nothing known."""
        if not self.is_urdf and self.parent_name == "world":
            return self.root.outermost(self)
        return self._named(self.parent_name)

    @lazy
    def child(self) -> Node | None:
        """The link, frame or model that its child names; None if that is nothing known."""
        return self._named(self.child_name)

    @property
    def parent_link(self) -> Link | None:
        """The link that its parent moves with; None for the world, and where that is unknown."""
        return _link(self.parent)

    @property
    def child_link(self) -> Link | None:
        """The link that its child moves with; None where that is unknown."""
        return _link(self.child)

    def _end(self, role: str) -> Value | None:
        prefix = "drake:" if self.is_for_drake_only and not self.is_urdf else ""
        element = self.find(prefix + role)
        if element is None:
            return None
        value = element.attribute("link") if self.is_urdf else element.own_value
        return value if value is not None and value.text else None

    def _named(self, name: str) -> Node | None:
        if self.is_urdf:
            found = self.look_up(name) if name and not is_expression(name) else None
            return found if found is not None and found.kind == "link" else None
        found = self.look_up(name) if name else None
        return None if found is self else found

    @property
    def attachment(self) -> Node | None:
        return self.child

    @property
    def base_name(self) -> str:
        return self.written_base or self.child_name

    @property
    def urdf_base(self) -> tuple[Node | None, Element | None]:
        return self.child, None

    # Motion

    @lazy
    def axis(self) -> Axis:
        """Its first axis; with defaults where none is written."""
        return self._only("axis", Axis)

    @lazy
    def axis2(self) -> Axis:
        """Its second axis, in SDFormat; with defaults where none is written."""
        return self._only("axis2", Axis)

    @property
    def axes(self) -> tuple[Axis, ...]:
        """The axes that it moves about or along, given or not."""
        count = self.axis_count
        return (self.axis, self.axis2)[:count]

    @property
    def axis_count(self) -> int:
        """The number of axes that its type has."""
        if self.is_urdf:
            return 0 if self.type in {"fixed", "floating"} else 1
        return AXES.get(self.type, 0)

    @property
    def counterparts(self) -> tuple[Joint, ...]:
        """The other joints of its model whose names differ only by the side: those of the other wheels or legs."""
        key = without_sides(self.name)
        if key == self.name or self.model is None:
            return ()
        return tuple(joint for joint in self.model.joints_of_each_side.get(key, ()) if joint is not self)

    @property
    def twins(self) -> tuple[Joint, ...]:
        """The other joints of its type that carry the same meshes, at the same places in their links.

        All are on one parent or each on its own; of two grippers, the fingers of each may be mirrored. The many
        equal parts of a chain are not.
        """
        key = _twin_key(self)
        all_ = self.model.twins.get(key, ()) if self.model is not None and key is not None else ()
        if len(all_) > _MOST_TWINS or len({joint.parent_link for joint in all_}) not in {1, len(all_)}:
            return ()
        return tuple(joint for joint in all_ if joint is not self)

    @property
    def mirror(self) -> Joint | None:
        """The joint whose name says left where its own says right; None without one."""
        if self.model is None:
            return None
        joints, name = self.model.joints_by_name, mirrored(self.name)
        name = name if name != self.name else other_letter(name, joints)
        return joints.get(name) if name != self.name and not counts_on(self.name, name, joints) else None

    @property
    def reach(self) -> Reach | None:
        """How far it moves its part into its parent within its limits; None where it goes as far to both sides."""
        return self.model.reaches.get(self) if self.model is not None else None

    @property
    def is_one_sided(self) -> bool:
        """Does it turn or slide farther to one side than to the other?"""
        lower, upper = self.axis.limit.range
        return self.type in {"revolute", "prismatic"} and (
            -math.inf < lower < upper < math.inf and abs(lower + upper) >= _SAME * (upper - lower)
        )

    @property
    def driver(self) -> Part | None:
        """One that moves it on command: its joint in ``ros2_control``, a transmission, or a plugin of Gazebo."""
        return self.model.drivers.get(self) if self.model is not None else None

    @property
    def moves(self) -> bool:
        """Is it of a type of URDF that lets its child move?"""
        return self.type in MOVING_IN_URDF if self.is_urdf else self.type != "fixed"

    def is_in_namesake(self, link: str) -> bool:
        """Is a link that its robot of xacro has not in another file of the project, in a robot of the same name?"""
        from sdfcheck.xacro.static.project import links_of_namesakes

        return self.document.is_expanded and link in self.document.view(links_of_namesakes)

    @lazy
    def at_rest(self) -> Origin | None:
        """Its pose in its model with all joints at zero, in plain numbers; None where that is not known."""
        try:
            return _at_rest(self)
        except DescriptionError:
            return None

    @property
    def wheel_radius(self) -> float:
        """The radius (m) of the one round shape of the link that it turns; nan where that has another number."""
        link = self.child_link
        shapes = (link.collisions or link.visuals) if link is not None else ()
        geometry = shapes[0].geometry if len(shapes) == 1 else None
        if geometry is None or geometry.solid is None or geometry.shape not in {"cylinder", "sphere"}:
            return math.nan
        return float(geometry.radius)

    @property
    def direction(self) -> Triple | None:
        """The direction of its first axis in its model, of length 1, with all joints at zero; None if not known."""
        xyz = self.axis.xyz
        length = math.hypot(*xyz)
        frame = self.axis.expressed_in
        if len(xyz) != 3 or not 0 < length < math.inf or frame not in {"", MODEL_FRAME}:
            return None
        x, y, z = (number / length for number in xyz)
        if frame:
            return (x, y, z)
        return None if self.at_rest is None else self.at_rest.turned((x, y, z))

    screw_thread_pitch = number("screw_thread_pitch", 1.0, "Of a screw: m of travel per turn.")
    thread_pitch = number(
        "thread_pitch", 1.0, "Of a screw, as older versions write it: radians of turn per m, left-handed."
    )
    gearbox_ratio = number("gearbox_ratio", 1.0, "Of a gearbox: turns of the parent per turn of the child.")

    @property
    def sensors(self) -> tuple[Sensor, ...]:
        """Its sensors; in URDF those of the ``<gazebo>`` blocks about it."""
        blocks = (sensor for block in self.gazebo_blocks for sensor in block.sensors)
        return (*(() if self.is_urdf else self._parts("sensor")), *blocks)

    @property
    def keeps_forces(self) -> bool:
        """Does Gazebo Classic work out the forces in it, for itself or for a sensor on it?"""
        if any(sensor.type == "force_torque" for sensor in self.sensors):
            return True
        if self.is_urdf:
            return any(block.is_on("provideFeedback") for block in self.gazebo_blocks)
        physics = list(self.children("physics"))
        holders = (self.element, *physics, *(ode for each in physics for ode in each.children("ode")))
        return any(
            is_true(each.content) for holder in holders for each in holder.children("provide_feedback")
        )

    @property
    def gazebo_blocks(self) -> tuple[GazeboBlock, ...]:
        """The ``<gazebo>`` blocks about it, in URDF."""
        model = self.model
        if not self.is_urdf or model is None:
            return ()
        return tuple(model.blocks_by_reference.get(self.name, ()))


def _said_by_surfaces(
    model: Model, asked: Mapping[Joint, float], ask: Callable[[], Sequence[Sequence[float]]]
) -> Sequence[Sequence[float]]:
    """A row for each joint, from surfaces; kept for as long as joints and shapes are the same."""
    library = library_of(model.document)
    if not asked or library is None:
        return ask() if asked else ()
    joints = [
        (joint.type, joint.child, joint.parent, joint.axis.limit.range, joint.direction, joint.at_rest)
        for joint in model.joints
    ]
    links = [
        (link.name, link.at_rest, list(map(_surface, link.visuals or link.collisions)))
        for link in model.links
    ]
    name = digest_of(repr((joints, links, [(joint.name, bound) for joint, bound in asked.items()])))
    folder = str(model.document.path.parent)
    kept = library.shelves.find(folder, name, _SURFACES, "")
    if kept is None or len(kept) != len(asked):
        kept = list(map(list, ask()))
        library.shelves.keep(folder, name, _SURFACES, ["", *kept], _MOST_ANSWERS)
    return kept


_SURFACES, _MOST_ANSWERS = "-surfaces", 400


def _surface(shape: Shape) -> tuple[object, ...]:
    """All that its surface depends on."""
    geometry = shape.geometry
    try:
        place: object = _placement_in(shape, shape.link)
    except DescriptionError:
        place = None
    mesh = geometry.mesh if geometry.shape == "mesh" else None
    return geometry.shape, geometry.uri, "" if mesh is None else mesh.stamp, geometry.measures, place


def _gap(joint: Joint, least: float) -> float:
    from sdfcheck.robot.motion.mechanism import distance

    child, parent, model = joint.child_link, joint.parent_link, joint.model
    if child is None or parent is None or model is None:
        return 0.0
    below = dict.fromkeys((child, *child.below()))
    rest = (parent, *(link for link in model.links if link not in below and link is not parent))
    carried, others = ([link.skin for link in links if link.shapes] for links in (below, rest))
    mine, theirs = ([skin for skin in skins if skin is not None] for skins in (carried, others))
    is_known = parent not in below and len(mine) + len(theirs) == len(carried) + len(others)
    return distance(mine, theirs, least) if is_known else 0.0


def _reach(joint: Joint) -> tuple[float, float] | None:
    child, parent = joint.child_link, joint.parent_link
    if child is None or parent is None or joint.at_rest is None or joint.direction is None:
        return None
    from sdfcheck.robot.motion.mechanism import joined, reach

    part, base = (joined(each.skin for each in link.rigid_group if each.shapes) for link in (child, parent))
    if part is None or base is None:
        return None
    limits = joint.axis.limit.range
    return reach(part, base, joint.type, joint.at_rest.position, joint.direction, limits)


def _link(node: Node | None) -> Link | None:
    carrier = node.carrier if node is not None else None
    return cast("Link", carrier) if carrier is not None and carrier.kind == "link" else None


# The numbers of URDF, and the poses that it writes as ``origin``.
#
# Without numpy: lint merges links with it, and numpy takes longer to load than most files to lint.


_DEEPEST = 200
"""Joints above one that are followed."""
_STEEP = 0.7
"""Of a length, upwards: about 45°."""
_MOST_TWINS = 50
"""Fingers, legs and wheels of one kind are fewer."""
_MOST_SKINS = 500
"""Links of which each is compared with all others by their surfaces."""


def _at_rest(joint: Joint) -> Origin | None:
    """Where a joint is in its model, all joints at zero; None where it hangs on nothing. Raises DescriptionError."""
    if joint.child_link is None or joint.model is None:
        return None
    if not joint.is_urdf:
        return _at_rest_in_sdf(joint)
    parent = joint.parent_link
    frame = Origin() if parent is None else joint.model.poses_at_rest.get(parent)
    return None if frame is None else frame.followed_by(origin_in(joint.element))


def _twin_key(joint: Joint) -> tuple[object, ...] | None:
    link = joint.child_link
    return (joint.type, link.look) if joint.moves and link is not None and link.look else None


def _links_at(model: Model, places: Mapping[str, float]) -> dict[Link, Origin]:
    """The poses of the links of a robot of URDF in its root, as far as known; joints without a place are at zero."""
    tree = model.tree
    found: dict[Link, Origin] = {}
    waiting = [(root, Origin()) for root in tree.roots]
    while waiting:
        link, pose = waiting.pop()
        found[link] = pose
        for joint in tree.children.get(link, ()):
            child = joint.child_link
            if child is not None and tree.parents[child][0] is joint:
                with suppress(DescriptionError):
                    at = pose.followed_by(origin_in(joint.element))
                    place = places.get(joint.name, 0.0)
                    waiting.append((child, at.followed_by(_moved(joint, place)) if place else at))
    return found


def _moved(joint: Joint, place: float) -> Origin:
    """How a joint of URDF with one axis moves its child by a place (rad or m)."""
    xyz = joint.axis.xyz
    length = math.hypot(*xyz)
    if len(xyz) != 3 or not 0 < length < math.inf:
        return Origin()
    x, y, z = (number / length for number in xyz)
    if joint.type == "prismatic":
        return Origin(position=(x * place, y * place, z * place))
    sine = math.sin(place / 2)
    return Origin(of_quaternion(x * sine, y * sine, z * sine, math.cos(place / 2)))


def _at_rest_in_sdf(node: Node) -> Origin | None:
    """The same in SDFormat, as far as it is relative to what is in the same model."""
    found, at = Origin(), node
    for _ in range(_DEEPEST):
        found = pose_in(at.pose_element).followed_by(found)
        base = at.base
        if base is None or base is node.scope:
            return found if base is not None or not at.base_name else None
        if base.scope is not node.scope or base.kind == "model":
            return None
        at = base
    return None


# How the links of one model hang together by its joints.


class Tree:
    """The links of a model and the joints between two different ones of them.

    Links and joints are those of the model itself, in the order of the file; of several
    links of one name the first counts. In URDF one whose name is yet to be expanded is left out.
    """

    def __init__(self, model: Model) -> None:
        self.model = model
        self.links: dict[str, Link] = {}
        """Name → link."""
        is_name: Callable[[str], bool] = _is_name_in_urdf if model.is_urdf else bool
        for link in model.links:
            if is_name(link.name):
                self.links.setdefault(link.name, link)
        self.joints: tuple[Joint, ...] = model.joints
        """All joints, those that tie nothing as well."""
        self.children: dict[Link, list[Joint]] = {}
        """Link → the joints that lead on from it."""
        self.parents: dict[Link, list[Joint]] = {}
        """Link → the joints that lead to it: more than one is a mistake, or closes a loop."""
        for joint in self.joints:
            if (ends := self.ends(joint)) is not None:
                self.children.setdefault(ends[0], []).append(joint)
                self.parents.setdefault(ends[1], []).append(joint)

    def ends(self, joint: Joint) -> tuple[Link, Link] | None:
        """The links at the ends of a joint, if they are two."""
        parent, child = joint.parent_link, joint.child_link
        return None if parent is None or child is None or parent is child else (parent, child)

    @property
    def roots(self) -> list[Link]:
        """The links to which no joint leads, in the order of the file."""
        return [link for link in self.links.values() if link not in self.parents]

    @lazy
    def has_root(self) -> bool:
        """Is a link the child of no joint, not even of one that ties it to itself?"""
        children = {joint.child_name for joint in self.joints}
        return any(name not in children for name in self.links)

    @lazy
    def is_whole(self) -> bool:
        """Does each joint tie two links, and do all links hang together?"""
        return len(self.groups) <= 1 and all(self.ends(joint) is not None for joint in self.joints)

    def below(self, *links: Link) -> Iterator[Link]:
        """The links and all links below them, each once, even where joints lead round in a circle."""
        seen = set(links)
        waiting = list(reversed(links))
        while waiting:
            at = waiting.pop()
            yield at
            for joint in reversed(self.children.get(at, [])):
                child = joint.child_link
                if child is not None and child not in seen:
                    seen.add(child)
                    waiting.append(child)

    @lazy
    def main_roots(self) -> list[Link]:
        """The roots in the largest group: more than one where a link has several parents."""
        main = set(self.groups[0]) if self.links else ()
        return [link for link in self.roots if link in main]

    def top(self, group: list[Link]) -> Link:
        """The root of a group, or its first link where joints lead round in a circle."""
        return next((link for link in group if link not in self.parents), group[0])

    @lazy
    def loose_groups(self) -> list[list[Link]]:
        """The groups except the largest, unless mistakes in as many joints explain them."""
        others = self.groups[1:]
        if not others:
            return []
        broken = sum(self.ends(joint) is None for joint in self.joints) + len(self.loops())
        if len(others) <= broken:
            return []
        meant = set(self._meant_children())
        return [group for group in others if not meant.intersection(group)]

    def _meant_children(self) -> Iterator[Link]:
        """The links to which joints lead, or would if their ends were spelled right."""
        from sdfcheck.formats.near_names import suggest_in

        for joint in self.joints:
            name = joint.child_name
            if self.ends(joint) is not None or not name:
                continue
            meant = name if name in self.links else suggest_in(self.model.document, name, self.links)
            if meant is not None:
                yield self.links[meant]

    @lazy
    def groups(self) -> list[list[Link]]:
        """The links, grouped by what joints tie together: the largest group first, then by place."""
        tied: dict[Link, list[Link]] = {}
        for joints in self.children.values():
            for joint in joints:
                if (ends := self.ends(joint)) is not None:
                    tied.setdefault(ends[0], []).append(ends[1])
                    tied.setdefault(ends[1], []).append(ends[0])
        groups: list[list[Link]] = []
        seen: set[Link] = set()
        for link in self.links.values():
            if link in seen:
                continue
            seen.add(link)
            group = [link]
            for member in group:
                fresh = [other for other in dict.fromkeys(tied.get(member, ())) if other not in seen]
                seen.update(fresh)
                group += fresh
            groups.append(group)
        return sorted(groups, key=len, reverse=True)

    def loops(self) -> list[list[Joint]]:
        """Joints that lead round in a circle, going up from each link by the first joint that leads to it.

        Each begins with its first joint in the order of the file.
        """
        return loops(self.parents, self.joints)


def parents_in(joints: Iterable[Joint]) -> dict[Link, list[Joint]]:
    """Link → the joints that carry it: those whose parent moves with something else, or is the world.

    The links may be of several models. A gearbox carries nothing: it couples what others carry.
    """
    found: dict[Link, list[Joint]] = {}
    for joint in joints:
        child, parent = joint.child_link, joint.parent
        if child is None or parent is None or joint.type == "gearbox":
            continue
        if (carrier := parent.carrier) is not None and carrier is not child:
            found.setdefault(child, []).append(joint)
    return found


def loops(parents: Mapping[Link, Sequence[Joint]], joints: Iterable[Joint]) -> list[list[Joint]]:
    """The same for any links and the joints that lead to them, given in the order of the file."""
    found: list[list[Joint]] = []
    done: set[Link] = set()
    order = {joint: number for number, joint in enumerate(joints)}
    for start in parents:
        path: list[Joint] = []
        on_path: dict[Link, int] = {}
        link: Link | None = start
        while link is not None and link not in done and link not in on_path and link in parents:
            on_path[link] = len(path)
            path.append(parents[link][0])
            link = path[-1].parent_link
        if link is not None and link in on_path:
            ring = path[on_path[link] :][::-1]
            first = min(range(len(ring)), key=lambda number: order[ring[number]])
            found.append(ring[first:] + ring[:first])
        done.update(on_path)
    return found


def _is_name_in_urdf(name: str) -> bool:
    return bool(name) and not is_expression(name)


# Lights.


class Light(Part):
    """A light of a world or link, or one that is a whole file."""

    __slots__ = ()
    kind = "light"

    type = word("type", "point", "``point``, ``spot`` or ``directional``.")

    direction = vector("direction", (0.0, 0.0, -1.0), "Where it shines to.")

    diffuse = vector("diffuse", (1.0, 1.0, 1.0, 1.0), "Red, green, blue, alpha.")

    specular = vector("specular", (0.1, 0.1, 0.1, 1.0), "Red, green, blue, alpha.")

    intensity = number("intensity", 1.0, "A factor.")

    def pose(self, relative_to: str | None = None) -> Pose:
        """Its pose in what it is in, or relative to what a reference names there; raises PoseError."""
        element = self.element if self.is_given else None
        return self.root.poses.of_part_in(element, self.within(Node), relative_to)


# Sensors.


SETTINGS = {
    "camera": "camera",
    "depth": "camera",
    "depth_camera": "camera",
    "multicamera": "camera",
    "rgbd": "camera",
    "rgbd_camera": "camera",
    "thermal": "camera",
    "thermal_camera": "camera",
    "segmentation": "camera",
    "segmentation_camera": "camera",
    "boundingbox": "camera",
    "boundingbox_camera": "camera",
    "wideanglecamera": "camera",
    "ray": "ray",
    "gpu_ray": "ray",
    "lidar": "lidar",
    "gpu_lidar": "lidar",
    "gps": "gps",
    "navsat": "navsat",
}
"""Type → the element that holds its settings, where they are not called alike."""


class Contact(Part):
    """The collisions that a contact sensor, or a sound, listens to."""

    __slots__ = ()
    kind = "contact"

    @property
    def link(self) -> Link | None:
        """The link whose collisions it names."""
        holder = self.holder.holder if self.holder is not None else None
        return holder if isinstance(holder, Link) else None

    @property
    def collision_names(self) -> tuple[Value, ...]:
        """The names of collisions that it writes, with their places."""
        return tuple(name.own_value for name in self.children("collision") if name.content)

    @property
    def unresolved(self) -> tuple[UnknownName, ...]:
        """The names that no collision of the link has. Scoped ones are spelled in ways that differ by simulator."""
        if self.link is None:
            return ()
        names = tuple(
            collision.attributes.get("name", "").strip() for collision in self.link.children("collision")
        )
        return tuple(
            UnknownName(value, "collision", self.link.element, names)
            for value in self.collision_names
            if value.text.strip() not in (DEFAULT, *names) and "::" not in value.text
        )


class Sensor(Part):
    """A sensor of a link or joint; in URDF files it is in a ``<gazebo>`` block."""

    __slots__ = ()
    kind = "sensor"

    type = word("type", "", "The type as written, without spaces around it.")

    type_value = given_text("type", "The type with its place.")

    @property
    def link(self) -> Link | None:
        """The link that it is on; None if it is on a joint, or on nothing known."""
        owner = self.owner
        return owner if isinstance(owner, Link) else None

    @property
    def owner(self) -> Link | Joint | None:
        """The link or joint that it is on; None for one in a ``<gazebo>`` block that names neither."""

        found = self.holder.subject if isinstance(self.holder, GazeboBlock) else self.holder
        return found if isinstance(found, Link | Joint) else None

    update_rate = number("update_rate", 0.0, "Hz; 0: as often as the simulation steps.")

    @property
    def topic(self) -> str:
        """The topic that it publishes on; empty where the simulator chooses one."""
        topic = self.find("topic")
        text = topic.content if topic is not None else ""
        return "" if text == DEFAULT else text

    @property
    def always_on(self) -> bool:
        """Does it run whether or not somebody listens?"""
        element = self.find("always_on")
        return element is not None and is_true(element.content)

    @property
    def settings_names(self) -> tuple[str, ...]:
        """The elements that may configure a sensor of its type; empty for a type that is not known."""
        from sdfcheck.formats.sdf.sensors import SETTINGS as NAMES

        return NAMES.get(self.type, ())

    @property
    def given_settings(self) -> tuple[Element, ...]:
        """Its elements that configure sensors, of whatever type."""
        from sdfcheck.formats.sdf.sensors import ALL_SETTINGS

        return tuple(child for child in self.children() if child.name in ALL_SETTINGS)

    @property
    def settings(self) -> Setting | None:
        """The part of its type: ``camera``, ``lidar``, ``imu`` …; None without one."""
        names = (SETTINGS.get(self.type, self.type), "lidar", "ray", "camera", "gps", "navsat")
        element = next((found for name in names if name and (found := self.find(name)) is not None), None)
        part = None if element is None else self.part(element)
        return part if isinstance(part, Setting) else None

    plugins: lazy[tuple[Plugin, ...]] = parts("plugin", "Its plugins.")

    def pose(self, relative_to: str | None = None) -> Pose:
        """Its pose in the frame of its link or joint, or relative to what a reference names; raises PoseError."""
        return self.root.poses.of_part_in(self.element if self.is_given else None, self.owner, relative_to)

    @property
    def view(self) -> Triple | None:
        """The direction in which it looks, in its robot of URDF at rest; None where that is not known."""
        pose, frame = self.find("pose"), self.link.at_rest if self.link is not None else None
        if frame is None or reference_of(pose):
            return None
        try:
            return frame.followed_by(pose_in(pose)).turned((1.0, 0.0, 0.0))
        except DescriptionError:
            return None


# Names of joints and links that the parameters of plugins write.
#
# Systems look among the joints and links directly in their model, and know no ``::`` but for some.


_TEMPLATE = pattern(r"[${}%@]")


_USUAL = {
    "bodyName": "link",
    "linkName": "link",
    "link_name": "link",
    "jointName": "joint",
    "joint_name": "joint",
    "mimicJoint": "joint",
    "arm/palm_link": "link",
    "arm/gripper_link": "link",
}
"""Parameter of a plugin that is not known → the kind of thing that it names."""
_ALWAYS = frozenset({"", "world", "/world", "map", "/map", "canonical", "__default__"})


class _Listed(Value):
    """One name of a list with commas."""

    __slots__ = ()

    @property
    def span(self) -> Span:
        whole = super().span
        found = re.search(rf"(?<![^\s,]){re.escape(self.text)}(?![^\s,])", whole.text)
        if found is None:
            return whole
        return whole.source.span(whole.start + found.start(), whole.start + found.end())


class PluginReference(NamedTuple):
    """A name that a parameter writes, of a joint or link as ``kind`` says; ``node`` is what has the name."""

    value: Value
    kind: str
    model: Model
    node: Node | None

    @property
    def joint(self) -> Joint | None:
        """The joint that has the name."""
        return cast("Joint", self.node) if self.node is not None and self.node.kind == "joint" else None

    @property
    def is_unresolved(self) -> bool:
        """Does it reach no joint or link of its kind, or a joint that libsdformat merges away?

        Names of another robot that includes the same file are left out.
        """
        if self.node is None:
            element = self.value.element
            others = self.model.document.names_of_others(_NAMED_PART, element)
            return self.value.text.strip() not in others
        return self.node.kind != self.kind or _is_lumped(self.node)


def references(plugin: Plugin, namings: Iterable[Naming]) -> Iterator[PluginReference]:
    """The names of joints and links that are written; what may be in a file that could not be read is left out."""
    model = _model(plugin)
    if model is None or not model.is_complete or not any(n.kind == "link" for n in model.nodes.values()):
        return
    for naming in namings:
        for value in _written(plugin.element, naming):
            name = value.text.strip()
            if name in _ALWAYS or _TEMPLATE.search(name):
                continue
            name = name.removeprefix(f"{model.name}::")
            if "::" in name and (not naming.is_scoped or plugin.known is None or model.may_hold(name)):
                continue
            yield PluginReference(value, naming.kind, model, model.resolve(name))


def _model(plugin: Plugin) -> Model | None:
    """The model that a plugin is in: in URDF the robot with what Gazebo adds."""
    holder = plugin.holder
    if holder is not None and holder.kind == "gazebo":
        found = plugin.root.scope_of(plugin.element)
        return found if isinstance(found, Model) else None
    return holder if isinstance(holder, Model) else None


def _written(element: Element, naming: Naming) -> Iterator[Value]:
    path, _, attribute = naming.path.partition("@")
    found = [element]
    for step in path.split("/"):
        found = [child for parent in found for child in parent.children(step)]
    for child in found:
        value = child.attribute(attribute) if attribute else child.own_value
        if value is None:
            continue
        names = value.text.split(",") if naming.is_list and "," in value.text else ()
        yield from (_Listed(value.element, value.attribute, name.strip()) for name in names if name.strip())
        if not names:
            yield value


def _is_lumped(node: Node) -> bool:
    """Does libsdformat merge a joint away? Names of links it rewrites in some parameters."""

    return isinstance(node, Joint) and node.is_lumped


# Plugins.


_MOST_PLUGINS = 200
_CARRIERS = frozenset(("world", "model", "sensor", "visual", "actor"))
_WHOLE_FILES = frozenset({"gazebo-classic", "gazebo_ros1", "gazebo_ros2"})
"""Generations that look for the file of a plugin as it is written, while gz-sim adds ``lib`` and ``.so``."""


class Plugin(Part):
    """A plugin, of a world, model, sensor, visual or ``<gazebo>`` block; its parameters are its own."""

    __slots__ = ()
    kind = "plugin"

    filename = word("filename", "", "The library as written, without spaces around it.")

    filename_value = given_text("filename", "The library with its place.")

    @property
    def parameters(self) -> Iterator[Element]:
        """Its parameters."""
        return self.children()

    @property
    def file_of_controllers(self) -> Element | None:
        """The parameter that names the file of its controllers, the first; None without one."""
        return next(self.children("parameters"), None)

    @lazy
    def controllers(self) -> ControllerFile:
        """The controllers of its file of parameters."""
        from sdfcheck.robot.controllers import ControllerFile, controllers_in

        value = self.file_of_controllers.own_value if self.file_of_controllers is not None else None
        if value is None or "$" in _FOUND.sub("", value.span.text):  # an argument gives another file
            return ControllerFile()
        return controllers_in(self.document, value.text.strip())

    @lazy
    def missing_parameters_file(self) -> tuple[Value, str] | None:
        """A file of parameters in a package of the project that is not there, with one of its name that is, or empty.

        None also where a build makes the file.
        """
        for element in self.children("parameters") if "ros2_control" in self.filename else ():
            value = element.own_value
            if _FOUND.match(value.span.text.strip()) and "$" not in _FOUND.sub("", value.span.text):
                from sdfcheck.files.uris import substitute

                if (near := substitute(self.document, value.text.strip())) is not None:
                    return value, near
        return None

    @lazy
    def lost_namespace(self) -> Value | None:
        """The namespace of its controllers, where its file of parameters is for controllers without one."""
        space = next((each for ros in self.children("ros") for each in ros.children("namespace")), None)
        if space is None or "$" in space.own_value.span.text or not space.content.strip(" /\n"):
            return None
        return space.own_value if self.controllers.manager is not None else None

    @lazy
    def known(self) -> PluginFacts | None:
        """The facts about its library, in the generation that may load it and shares most parameters with it."""
        given = {parameter.name for parameter in self.parameters} if len(self._possible) > 1 else set()
        return max(self._possible, key=lambda facts: len(given & facts.parameters), default=None)

    @lazy
    def _generations(self) -> tuple[PluginFacts, ...]:
        if not self.filename:
            return ()
        from sdfcheck.formats.plugins import known

        return known(self.filename)

    @lazy
    def _possible(self) -> tuple[PluginFacts, ...]:
        """The facts about its library in the generations that may load it: in a package of ROS 2 no older one."""
        found = self._generations
        if len(found) < 2:
            return found
        newer = tuple(facts for facts in found if facts.generation != "gazebo_ros1")
        return newer if self.document.view(_is_of_ros_2) else found

    @lazy
    def generation(self) -> str:
        """The generation that loads it, by file and parameters: ``gz``, ``ros1``, ``ros2``, ``classic``; or empty."""
        from sdfcheck.formats.plugins import known

        reads = {facts.generation: facts.parameters for facts in known(self.filename)}
        if not reads or not all(name.startswith("gazebo_ros") for name in reads):
            return "gz" if reads and reads.keys() <= {"gz-sim", "gz_ros2_control"} else ""
        if reads.keys() == {"gazebo_ros1"}:
            return "ros1"
        older = reads.get("gazebo_ros1")
        newer = reads.get("gazebo_ros2", frozenset()) - older if older is not None else frozenset()
        is_newer = "gazebo_ros2_control" in reads or self.has("ros")
        return "ros2" if is_newer or any(each.name in newer for each in self.parameters) else "classic"

    @lazy
    def references(self) -> tuple[PluginReference, ...]:
        """The parameters that name a joint or link of its model."""
        facts = self.known
        namings = facts.namings if facts is not None else ()
        if facts is None or ("bodyName" in facts.required and not namings):
            given = {child.name for child in self.parameters}
            usual = {path: kind for path, kind in _USUAL.items() if path.partition("/")[0] in given}
            if not usual:
                return ()
            from sdfcheck.formats.plugins import Naming

            namings = tuple(Naming(path, kind, True, False) for path, kind in usual.items())
            if "mimicJoint" in usual:
                namings += (Naming("joint", "joint", True, False),)
        return tuple(references(self, namings)) if namings else ()

    @property
    def unresolved(self) -> tuple[PluginReference, ...]:
        """The parameters that name a joint or link which its model does not have."""
        return tuple(each for each in self.references if each.is_unresolved)

    @property
    def scoped(self) -> tuple[PluginReference, ...]:
        """The parameters that name something with ``::``, of a system of gz-sim that compares plain names alone."""
        facts, model = self.known, _model(self)
        if facts is None or facts.generation != "gz-sim" or model is None:
            return ()
        return tuple(
            PluginReference(value, naming.kind, model, model.resolve(name.removeprefix(f"{model.name}::")))
            for naming in facts.namings
            if not naming.is_scoped
            for value in _written(self.element, naming)
            if "::" in (name := value.text.strip()) and not _TEMPLATE.search(name)
        )

    @property
    def is_misplaced(self) -> bool:
        """Is it in an element in which its library does not run, or runs under a wrong name?"""
        parent, places = self.element.parent, self.known.places if self.known is not None else ()
        if not places or parent is None:
            return False
        place = "model" if parent.name in {"gazebo", "include"} else parent.name
        is_about_robot = parent.name != "gazebo" or not parent.attributes.get("reference")
        return place in _CARRIERS and place not in places and is_about_robot

    @property
    def refused_values(self) -> Iterator[tuple[Value, str]]:
        """The values that its library refuses, each with what is allowed."""
        from sdfcheck.formats.plugins import Naming, allows

        for path, allowed in self.known.values if self.known is not None else ():
            for value in _written(self.element, Naming(path, "", False, False)):
                text = value.text.strip()
                if text and not _TEMPLATE.search(text) and not allows(allowed, text):
                    yield value, allowed

    @property
    def siblings(self) -> tuple[Plugin, ...]:
        """The plugins beside it, itself included; those of all blocks about the same thing in URDF.

        Of very many it is alone: each is compared with all others.
        """
        beside = self.root.plugins_beside.get(beside_of(self.element), ())
        if self.holder is None or not 0 < len(beside) <= _MOST_PLUGINS:
            return (self,)
        return tuple(part for child in beside if isinstance(part := self.root.part_of(child), Plugin))

    @lazy
    def drive(self) -> Drive | None:
        """The drive that it makes, where it names the wheels on each side, and they are known."""
        name = self.filename.lower()
        if "drive" not in name and "steering" not in name:
            return None

        return drive_of(self)

    @lazy
    def drives(self) -> tuple[Drive, ...]:
        """The drive that it makes, or those of the controllers of its file of parameters."""
        own, model = self.drive, _driven_model(self)
        if own is not None or model is None or "ros2_control" not in self.filename:
            return () if own is None else (own,)
        written = (_written_drive(model, self.file_of_controllers, each) for each in self.controllers.drives)
        return tuple(filter(None, written))

    @lazy
    def stance(self) -> Stance | None:
        """How the robot that it drives stands on a floor; None where that is not known."""
        model = self.drive.left.joint.model if self.drive is not None else None
        return _stance(model, self.drive) if model is not None and self.drive is not None else None

    @lazy
    def meant_file(self) -> str | None:
        """The file of a system of Gazebo, or of a part of its window, that was probably meant by one that is not."""
        name = self.filename
        if self.known is not None:
            whole = f"lib{self.known.file}.so"
            is_part = name != whole and name in whole and self.known.generation in _WHOLE_FILES
            return whole if is_part else None
        if "$" in name:
            return None
        from sdfcheck.formats.plugins import file_of_class, gui_files, known_files, ros_files, stem

        if "::" in name:
            return file_of_class(name)
        if "gz-sim" in name or "ignition-gazebo" in name:
            return self.nearest(stem(name), known_files())
        if stem(name).startswith("gazebo_ros_"):
            near = self.nearest(stem(name), ros_files())
            return None if near is None else f"lib{near}.so"
        parent = self.element.parent
        if name and parent is not None and parent.name == "gui":
            return self.nearest(stem(name), gui_files())
        return None

    @lazy
    def misspelled_parameters(self) -> tuple[tuple[Element, str], ...]:
        """The parameters that no generation of it reads, with those that they were probably meant to be."""
        return tuple((each, meant) for each, meant in self._meant if not self._is_read_elsewhere(each))

    @lazy
    def outdated_parameters(self) -> tuple[tuple[Element, str | None], ...]:
        """The parameters that it had in ROS 1, in a package of ROS 2, with their names there; None for topics.

        Without those of 0, which there as well is what it takes where nothing is given, and without topics where a
        remapping gives them.
        """
        facts = self.known
        if len(self._possible) == len(self._generations) or facts is None or not facts.parameters:
            return ()
        older = [(each, meant) for each, meant in self._meant if self._is_read_elsewhere(each)]
        found = [(each, meant) for each, meant in older if each.content.strip() not in {"0", "0.0"}]
        named = {each for each, _ in older}
        topics = [each for each in self.parameters if "topic" in each.name.lower() and each.content.strip()]
        left = [each for each in topics if each not in named and not facts.reads(each.name)]
        if any(each.name == "remapping" for part in self.parameters for each in (part, *part.children())):
            left = []
        return (*found, *((each, None) for each in left if self._is_read_elsewhere(each)))

    def _is_read_elsewhere(self, parameter: Element) -> bool:
        return any(facts.reads(parameter.name) for facts in self._generations)

    @lazy
    def _meant(self) -> tuple[tuple[Element, str], ...]:
        """The parameters that it does not read, with those that they were probably meant to be."""
        facts = self.known
        if facts is None or not facts.parameters:
            return ()
        given = [parameter for parameter in self.parameters if ":" not in parameter.name]
        names = {parameter.name for parameter in given}
        unread = [parameter for parameter in given if not facts.reads(parameter.name)]
        if not unread:
            return ()
        free = [name for name in facts.parameters if name not in names]
        letters = {_letters(name): name for name in free}
        from sdfcheck.formats.near_names import without_a_word

        found = (
            (
                each,
                facts.in_other_case(each.name)
                or letters.get(_letters(each.name))
                or (None if self._is_read_elsewhere(each) else self.nearest(each.name, free))
                or without_a_word(each.name, free),
            )
            for each in unread
        )
        return tuple((each, meant) for each, meant in found if meant is not None)

    @lazy
    def foreign_parameters(self) -> tuple[tuple[Element, str], ...]:
        """The parameters that it does not read, but its counterpart in another generation, each with that.

        Of a drive that names no joint of its own also those by which another drive does.
        """
        facts = self.known
        if facts is None or not facts.parameters:
            return ()
        from sdfcheck.formats.plugins import counterparts, other_drives

        meant = {parameter for parameter, _ in self._meant}
        unread = [each for each in self.parameters if each not in meant and not facts.reads(each.name)]
        if not unread:
            return ()
        readers = [
            (other.file, other.reads) for other in counterparts(self.filename) if other.file != facts.file
        ]
        if facts.namings and facts.file.endswith("_drive") and all(self.lacks(n.path) for n in facts.namings):
            readers += [(other.file, other.has_naming) for other in other_drives(facts.file)]
        return tuple(
            (each, file)
            for each in unread
            if (file := next((file for file, reads in readers if reads(each.name)), "")) != ""
        )

    @lazy
    def missing_parameters(self) -> tuple[str, ...]:
        """The parameters without which it does not run, and that are not there, not even misspelled."""
        facts = self.known
        if facts is None or not facts.required or self.is_template or self._is_of_several_generations:
            return ()
        meant = {name for _, name in self._meant}
        return tuple(name for name in sorted(facts.required - meant) if self.lacks(name))

    @lazy
    def repeated_parameters(self) -> tuple[tuple[Element, Element], ...]:
        """The parameters of which it reads the first only, and that are given again with another value."""
        facts = self.known
        if facts is None:
            return ()
        first: dict[str, Element] = {}
        found = []
        for parameter in self.parameters:
            earlier = first.setdefault(parameter.name, parameter)
            is_one = parameter.name in facts.parameters - facts.repeatable and not parameter.nodes
            if earlier is not parameter and is_one and earlier.content != parameter.content:
                found.append((earlier, parameter))
        return tuple(found)

    @property
    def _is_of_several_generations(self) -> bool:
        """Do its parameters fit several generations of its library equally well?"""
        given = {parameter.name for parameter in self.parameters}
        shared = sorted(len(given & facts.parameters) for facts in self._possible)
        return len(shared) > 1 and shared[-1] == shared[-2]

    @property
    def is_template(self) -> bool:
        """Will something else write more of it, such as xacro?"""
        return any("xacro:" in child.name or "$" in child.content for child in self.parameters)


def _is_of_ros_2(document: Document) -> bool:
    from sdfcheck.files.packages import is_of_ros_2

    return is_of_ros_2(document.path)


def _letters(name: str) -> str:
    """A name without the way in which its words are joined: ``robotBaseFrame`` and ``robot_base_frame`` are alike."""
    return name.replace("_", "").lower()


# Drives: what the parameters of a plugin say, and where the wheels are.


_SIDES = (
    ("left_joint", "leftJoint", "front_left_joint", "back_left_joint", "leftFrontJoint", "leftRearJoint"),
    (
        "right_joint",
        "rightJoint",
        "front_right_joint",
        "back_right_joint",
        "rightFrontJoint",
        "rightRearJoint",
    ),
    ("left_steering_joint",),
    ("right_steering_joint",),
)
_SEPARATION = ("wheel_separation", "wheelSeparation")
_RADIUS = ("wheel_radius", "wheelRadius")
_BASE = ("wheel_base", "wheelbase")
_DIAMETER = ("wheel_diameter", "wheelDiameter")
_AHEAD = pattern("(?i)front")
_BEHIND = pattern("(?i)back|rear")
_NEAR = 0.005
"""m: wheels that are nearer are at one place."""
_ALONG = 0.9
"""The cosine of what is along an axis."""


class Wheel(NamedTuple):
    """A wheel of a drive, or what steers one, in the frame of the model."""

    name: Element | Parameter
    """The parameter that names the joint."""
    joint: Joint
    position: tuple[float, ...]
    axis: tuple[float, ...]
    """Of length 1."""
    radius: float
    """m, of its round shape; nan where there is none."""

    @property
    def middle(self) -> tuple[float, ...] | None:
        """The middle of the box around its shapes; None where that is not known."""
        link = self.joint.child_link
        if link is None or link.box is None:
            return None
        frame = self.joint.at_rest if link.is_urdf else _at_rest_in_sdf(link)
        if frame is None:
            return None
        x, y, z = link.box.center
        return frame.applied_to((x, y, z))

    def ahead_of(self, other: Wheel, direction: tuple[float, ...]) -> float:
        """How far it is from another wheel, along a direction (m)."""
        pairs = zip(self.position, other.position, direction, strict=True)
        return sum((own - others) * along for own, others, along in pairs)


class Drive(NamedTuple):
    """A drive with the same number of wheels on each side."""

    lefts: tuple[Wheel, ...]
    rights: tuple[Wheel, ...]
    steering: tuple[Wheel, ...]
    """The steering joints on the left and on the right, or nothing."""
    separation: Element | Parameter | None
    radius: Element | Parameter | None
    """The parameter of the radius or the diameter."""
    base: Element | None
    """The parameter of the distance of the axles."""
    has_sides: bool
    """Is left the left side? Where ``legacyMode`` is true, the drive of ROS Kinetic has the sides exchanged."""
    title: str
    file: Element | None = None
    """The parameter that names the file in which the others are, if they are in one."""

    def place(self, parameter: Element | Parameter) -> Value | Element | None:
        """Where the description says a parameter, or names the file in which it is."""
        return parameter.own_value if isinstance(parameter, Element) else self.file

    def labels(self, parameter: Element | Parameter) -> dict[object, str]:
        """The place of a parameter in its file, if it is in one."""
        return {} if isinstance(parameter, Element) else {parameter.span: "written here"}

    def called(self, parameter: Element | Parameter) -> str:
        """The name of a parameter, and that of its file."""
        name = f"`{parameter.name}`"
        return name if isinstance(parameter, Element) else f"{name} of `{parameter.span.source.path.name}`"

    @property
    def left(self) -> Wheel:
        """The first wheel on the left."""
        return self.lefts[0]

    @property
    def right(self) -> Wheel:
        """The first wheel on the right."""
        return self.rights[0]

    @property
    def wheels(self) -> tuple[Wheel, ...]:
        """Those of both sides."""
        return (*self.lefts, *self.rights)

    @property
    def distance(self) -> float:
        """How far to the left of the first right wheel the first left one is, along its axis (m)."""
        return self.left.ahead_of(self.right, self.left.axis)

    @property
    def distance_of_middles(self) -> float:
        """The same between the middles of their shapes; nan where these are not known."""
        left, right = self.left.middle, self.right.middle
        if left is None or right is None:
            return math.nan
        return self.left._replace(position=left).ahead_of(self.right._replace(position=right), self.left.axis)

    @property
    def axle_distance(self) -> float:
        """How far the wheels on the left are apart, across their axis (m); nan where there is one."""
        if len(self.lefts) != 2:
            return math.nan
        apart = [a - b for a, b in zip(self.left.position, self.lefts[1].position, strict=True)]
        along = self.left.ahead_of(self.lefts[1], self.left.axis)
        return math.sqrt(max(0.0, math.hypot(*apart) ** 2 - along**2))

    @property
    def misplaced(self) -> tuple[Wheel, Wheel, str] | None:
        """A wheel on the wrong side or end, one that shows it, and where the first is from there."""
        axis = self.left.axis
        if any(sum(a * b for a, b in zip(axis, wheel.axis, strict=True)) <= 0.5 for wheel in self.wheels):
            return None
        forwards = (axis[1], -axis[0], 0.0)
        if not self.has_sides:
            return None
        pairs = [(*pair, axis, "to the right of") for pair in product(self.lefts, self.rights)]
        pairs += [(*pair, axis, "to the right of") for pair in product(self.steering[:1], self.steering[1:])]
        pairs += [
            (*pair, forwards, "behind")
            for pair in permutations(self.wheels, 2)
            if _AHEAD.search(pair[0].name.name) and _BEHIND.search(pair[1].name.name)
        ]
        found = ((one, other, way) for one, other, along, way in pairs if other.ahead_of(one, along) > _NEAR)
        return next(found, None)

    @property
    def is_backward(self) -> bool:
        """Do the axes of all wheels point to the right, while the left wheels are on the left of a robot along x?"""
        is_turned = self.has_sides and all(wheel.axis[1] < -0.9 for wheel in self.wheels)
        return is_turned and all(
            left.position[1] > right.position[1] + _NEAR for left, right in product(self.lefts, self.rights)
        )

    @property
    def is_sideways(self) -> bool:
        """Are the wheels of both sides apart along x, and roll along y, in the frame of the model?"""
        is_apart = abs(self.distance) > _ALONG * math.dist(self.left.position, self.right.position)
        return is_apart and all(abs(wheel.axis[0]) > _ALONG for wheel in self.wheels)

    @property
    def written_radius(self) -> float:
        """The radius that the plugin takes (m); nan if none is written."""
        number = self.radius.own_value.number if self.radius is not None else math.nan
        return number / 2 if self.radius is not None and self.radius.name in _DIAMETER else number


# How a robot on wheels stands on a floor: on three points, around its center of mass, below which no other is.


class Footing(NamedTuple):
    """The lowest point of a part, how far it is above the wheels (m), and whether it is in a collision."""

    link: Link
    shape: Shape
    height: float
    is_solid: bool


class Stance(NamedTuple):
    """How a robot stands: its tilt (rad), how far its drive is above the floor (m), and what is near the floor.

    The lean is how far its center of mass is from the line through the wheels of one pair, seen from above (m).
    """

    tilt: float
    lift: float
    lean: float
    footings: tuple[Footing, ...]
    """Of the links that no drive turns and that come as near to the floor as half the radius of a wheel."""


_NEAR_FLOOR = 0.5
"""Of the radius of a wheel."""
_ROUND = 0.1
_MOST_POINTS, _LOWEST_POINTS = 400, 24
"""So many points at most has a robot that is looked at, and so many of them it may stand on."""
_TOUCHES = 1e-4
"""m"""


def _stance(model: Model, drive: Drive) -> Stance | None:
    wheels = {wheel.joint.child_link for wheel in drive.wheels}
    carriers = {joint.child_link: joint for joint in model.joints}
    try:
        solid, seen = (_footings(model, kind) for kind in ("collision", "visual"))
        center = _center(model)
    except DescriptionError:
        return None
    lowest = {
        link: min((point[2] for point, shape in solid if shape.link is link), default=math.inf)
        for link in wheels
    }
    if center is None or model.models or len(solid) > _MOST_POINTS:
        return None
    if not all(_is_upright(wheel, lowest) for wheel in drive.wheels):
        return None
    level = min(lowest.values())
    reach = level + _NEAR_FLOOR * drive.left.radius
    found: dict[tuple[Link, bool], Footing] = {}
    for points, is_solid in ((solid, True), (seen, False)):
        for point, shape in points:
            best = found.get((shape.link, is_solid))
            if shape.link not in wheels and point[2] < min(reach, best.height + level if best else math.inf):
                found[shape.link, is_solid] = Footing(shape.link, shape, point[2] - level, is_solid)
    low = {shape.link for point, shape in solid if point[2] < reach}
    plane = _floor([point for point, _ in solid], center)
    if plane is None or not all(_is_stiff(link, carriers) for link in low):
        return None
    along, beside, height = plane
    lift = min(z - along * x - beside * y - height for (x, y, z), shape in solid if shape.link in wheels)
    return Stance(math.atan(math.hypot(along, beside)), lift, _lean(drive, center), tuple(found.values()))


def _lean(drive: Drive, center: tuple[float, float]) -> float:
    (x, y, _), (x1, y1, _) = drive.lefts[0].position, drive.rights[0].position
    along, beside = x1 - x, y1 - y
    length = math.hypot(along, beside)
    return abs(along * (center[1] - y) - beside * (center[0] - x)) / length if length else 0.0


def _center(model: Model) -> tuple[float, float] | None:
    """Where the center of mass of a model is, seen from above; None without mass."""
    total, sums = 0.0, [0.0, 0.0]
    for link in model.links:
        frame, mass, center = _frame_at_rest(link), link.inertial.mass.number, link.inertial.center
        if frame is not None and center is not None and 0 < mass < math.inf:
            x, y, _ = frame.applied_to(center)
            total, sums = total + mass, [sums[0] + mass * x, sums[1] + mass * y]
    return (sums[0] / total, sums[1] / total) if total else None


def _frame_at_rest(link: Link) -> Origin | None:
    return link.at_rest if link.is_urdf else _at_rest_in_sdf(link)


def _is_upright(wheel: Wheel, lowest: Mapping[Link | None, float]) -> bool:
    """Is the lowest point of a wheel as far below its axle as its radius says?"""
    below = wheel.position[2] - lowest[wheel.joint.child_link]
    return abs(below - wheel.radius) < _ROUND * wheel.radius


def _lowest(model: Model) -> tuple[Shape, float] | None:
    pose = model.pose_element
    if model.models or model.placement_frame or reference_of(pose):
        return None
    points = _footings(model, "collision", pose_in(pose))
    return min(((shape, point[2]) for point, shape in points), key=lambda each: each[1], default=None)


def _footings(model: Model, kind: str, placed: Origin | None = None) -> list[tuple[Triple, Shape]]:
    """The points on which the shapes of a model may rest, in its frame; raises DescriptionError if some are unknown.

    Of a model that is placed, in the frame in which it is, the points that are known.
    """
    found: list[tuple[Triple, Shape]] = []
    for link in model.links:
        frame = _frame_at_rest(link)
        frame = frame if placed is None or frame is None else placed.followed_by(frame)
        for shape in link.collisions if kind == "collision" else link.visuals:
            pose = None if frame is None else frame.followed_by(_placement_in(shape, link))
            points = () if pose is None else shape.geometry.footing(pose.seen_along((0.0, 0.0, -1.0)))
            if pose is not None and points:
                found += ((pose.applied_to(point), shape) for point in points)
            elif kind == "collision" and placed is None:
                raise DescriptionError(f"where the collision of {link.name} ends is not known", shape.element)
    return found


def _is_stiff(link: Link, carriers: Mapping[Link | None, Joint]) -> bool:
    """Is what carries a link stiff, but for its own axle and casters that turn about the vertical?"""
    at: Link | None = link
    moving: list[Joint] = []
    while at in carriers and len(moving) < _DEEPEST:
        joint = carriers[at]
        moving += [joint] * (joint.type != "fixed")
        at = joint.parent_link
    upright = (abs(joint.direction[2]) if joint.direction is not None else 0.0 for joint in moving[1:])
    return all(joint.type != "prismatic" for joint in moving) and all(part > 0.99 for part in upright)


def _floor(points: list[Triple], center: tuple[float, float]) -> tuple[float, float, float] | None:
    """The plane (slope along x and y, height) through three points, above none, that is highest at a place."""
    best, highest = None, -math.inf
    points = sorted(points, key=lambda point: point[2])  # a plane that is above one is above a low one
    for (x, y, z), (x1, y1, z1), (x2, y2, z2) in combinations(points[:_LOWEST_POINTS], 3):
        (ax, ay, az), (bx, by, bz) = (x1 - x, y1 - y, z1 - z), (x2 - x, y2 - y, z2 - z)
        area = ax * by - ay * bx
        if abs(area) < _TOUCHES**2:
            continue
        along, beside = (az * by - ay * bz) / area, (ax * bz - az * bx) / area
        height = z - along * x - beside * y
        there = along * center[0] + beside * center[1] + height
        if there > highest and all(along * px + beside * py + height <= pz + 1e-6 for px, py, pz in points):
            best, highest = (along, beside, height), there
    return best


def drive_of(plugin: Plugin) -> Drive | None:
    """The drive that a plugin makes; None for other plugins, and where a wheel is not known."""
    model = _driven_model(plugin)
    given: dict[str, list[Element]] = {}
    for parameter in plugin.parameters:
        given.setdefault(parameter.name, []).append(parameter)
    facts = plugin.known
    for name in (*_RADIUS, *_DIAMETER, *_SEPARATION, *_BASE):
        if facts is not None and facts.parameters and not facts.reads(name):
            given.pop(name, None)
    named = [[each for name in names for each in given.get(name, ())] for names in _SIDES]
    if model is None or not 0 < len(named[0]) == len(named[1]) or len(named[2]) != len(named[3]):
        return None
    lefts, rights, *steering = (tuple(filter(None, (_wheel(model, n) for n in names))) for names in named)
    joints = {wheel.joint for wheel in (*lefts, *rights)}
    if len(joints) < 2 * len(named[0]):
        return None
    radius, separation = _only(given, (*_RADIUS, *_DIAMETER)), _only(given, _SEPARATION)
    turned = tuple(wheel for side in steering for wheel in side)
    has_sides = (plugin.get("legacyMode") or "").strip() not in {"true", "1"}
    steered = turned if len(turned) == 2 else ()
    title = f"drive `{plugin.name}`"
    return Drive(lefts, rights, steered, separation, radius, _only(given, _BASE), has_sides, title)


def _written_drive(model: Model, file: Element | None, written: WrittenDrive) -> Drive | None:
    """The drive of a controller; None where a wheel is not known."""
    lefts, rights = (
        tuple(filter(None, (_wheel(model, name) for name in names)))
        for names in (written.lefts, written.rights)
    )
    if len({wheel.joint for wheel in (*lefts, *rights)}) < 2 * len(written.lefts):
        return None
    title = f"controller `{written.controller}`"
    return Drive(lefts, rights, (), written.separation, written.radius, None, True, title, file)


def _only(given: dict[str, list[Element]], names: tuple[str, ...]) -> Element | None:
    found = [element for name in names for element in given.get(name, ())]
    return found[0] if len(found) == 1 else None


def _driven_model(plugin: Plugin) -> Model | None:
    # That of an include is not in the file of its root.
    scope = plugin.holder if isinstance(plugin.holder, Model) else plugin.root.scope_of(plugin.element)
    return scope if isinstance(scope, Model) else None


def _wheel(model: Model, name: Element | Parameter) -> Wheel | None:
    joint = model.joints_by_name.get(name.content.strip())
    if joint is None or joint.axis_count != 1 or joint.at_rest is None or joint.direction is None:
        return None
    return Wheel(name, joint, joint.at_rest.position, joint.direction, joint.wheel_radius)


# Actuation of the joints of a URDF robot.


class JointNames(Part):
    """Something that names joints."""

    __slots__ = ()

    @property
    def model(self) -> Model:
        """The robot."""
        holder = self.holder
        while holder is not None and holder.kind != "model":
            holder = holder.holder
        return cast("Model", holder)

    @property
    def joint_elements(self) -> tuple[Element, ...]:
        """Its ``joint`` elements."""
        return tuple(self.children("joint"))

    @property
    def joint_names(self) -> tuple[Value, ...]:
        """The names of joints that it writes, with their places."""
        values = (joint.attribute("name") for joint in self.joint_elements)
        return tuple(value for value in values if value is not None and value.text)

    @property
    def unresolved(self) -> tuple[Value, ...]:
        """The names that no joint of the robot has; what is yet to be expanded is left out."""
        known = self.model.driven
        return tuple(v for v in self.joint_names if v.text not in known and not is_expression(v.text))


class Transmission(JointNames):
    """A transmission between joints and actuators."""

    __slots__ = ()
    kind = "transmission"

    @property
    def type_value(self) -> Value | None:
        """Its type with its place: a child element, or an attribute."""
        child = self.find("type")
        return child.own_value if child is not None else self.attribute("type")

    @property
    def is_of_ros_2(self) -> bool:
        """Is its package one of ROS 2, where nothing reads what is for ros_control?"""
        return self.document.view(_is_of_ros_2)

    @property
    def actuators(self) -> tuple[Element, ...]:
        """Its ``actuator`` elements."""
        return tuple(self.children("actuator"))

    @property
    def reductions(self) -> tuple[Value, ...]:
        """The values of ``mechanicalReduction`` in it and its actuators, with the places."""
        holders = (self.element, *self.actuators)
        return tuple(
            found.own_value for holder in holders for found in holder.children("mechanicalReduction")
        )


# Joints, sensors and other signals of ``<ros2_control>`` blocks, and their interfaces.


LIMITED = frozenset(("position", "velocity", "effort", "acceleration", "jerk"))
"""The interfaces of joints whose minimum and maximum are limits."""


class ControlComponent(Part):
    """A joint, a sensor or other signals (``gpio``) of a ``ros2_control`` block, with their interfaces."""

    __slots__ = ()
    kind = "component"

    @property
    def what(self) -> str:
        """``joint``, ``sensor`` or ``gpio``."""
        return self.element.name

    @property
    def block(self) -> Ros2Control:
        """The block that it is in."""
        return cast("Ros2Control", self.holder)

    @property
    def model(self) -> Model:
        """The robot."""
        return self.block.model

    @lazy
    def joint(self) -> Joint | None:
        """The joint of the robot that it drives or reads; None without one."""
        return self.model.joints_by_name.get(self.name) if self.what == "joint" and self.name else None

    @property
    def claims(self) -> Sequence[ControllerNeed]:
        """The interfaces of a joint that the controllers claim whose file the simulator's plugin names."""
        return self.model.claims.get(self.name, ()) if self.what == "joint" else ()

    @lazy
    def sensor(self) -> Sensor | None:
        """The simulated sensor of its name."""
        if self.what != "sensor" or not self.name:
            return None
        blocks = self.model.gazebo_blocks
        return next((s for block in blocks for s in block.sensors if s.name == self.name), None)

    @lazy
    def interfaces(self) -> tuple[ControlInterface, ...]:
        """Its interfaces, in the order of the file."""
        names = ("command_interface", "state_interface")
        return tuple(
            cast("ControlInterface", self.part(child)) for child in self.children() if child.name in names
        )

    @property
    def commands(self) -> tuple[ControlInterface, ...]:
        """The interfaces that take commands."""
        return tuple(each for each in self.interfaces if each.is_command)

    @property
    def earlier(self) -> ControlComponent | None:
        """The joint before it in the block that has its name."""
        if self.what != "joint" or not self.name or is_expression(self.name):
            return None
        first = self.block.joints[self.name]
        return None if first is self else first

    @property
    def rivals(self) -> Iterator[tuple[ControlInterface, ControlInterface]]:
        """Its interfaces that a joint of the same name in an earlier block has, too, with those."""
        named = self.block.model.control_joints.get(self.name, ()) if not is_expression(self.name) else ()
        before = takewhile(lambda joint: joint.block is not self.block, named)
        others = [each for joint in before for each in joint.interfaces]
        for own in self.interfaces if others else ():
            for other in others:
                if own.is_readable and own.name == other.name and own.is_command == other.is_command:
                    yield own, other
                    break

    @property
    def mimic_parameters(self) -> tuple[Element, ...]:
        """The parameters that say which joint it follows, as releases before jazzy read them."""
        return tuple(each for each in self.children("param") if each.attributes.get("name") == "mimic")

    mimic_value = given_text("mimic", "Whether it follows another joint, where that is written here.")

    @property
    def mimic(self) -> Mimic | None:
        """How it follows another joint, in the robot and not switched off here."""
        value = self.mimic_value
        if self.joint is None or (value is not None and value.text.strip().lower() == "false"):
            return None
        return self.joint.axis.mimic


class ControlInterface(Part):
    """An interface of a joint, sensor or other signals: one number to command or to read."""

    __slots__ = ()
    kind = "interface"

    @property
    def is_command(self) -> bool:
        """Does it take commands?"""
        return bool(self.element.name == "command_interface")

    @property
    def component(self) -> ControlComponent:
        """Its holder."""
        return cast("ControlComponent", self.holder)

    @property
    def is_readable(self) -> bool:
        """Has it a name, and not one that is yet to be expanded?"""
        return bool(self.name) and not is_expression(self.name)

    @property
    def is_limited(self) -> bool:
        """Do ``min`` and ``max`` limit it?"""
        return self.is_command and self.component.what == "joint" and self.name in LIMITED

    @property
    def twin(self) -> ControlInterface | None:
        """The interface of the same kind and name before it in its component."""
        if not self.is_readable:
            return None
        for other in self.component.interfaces:
            if other is self:
                return None
            if other.name == self.name and other.is_command == self.is_command:
                return other
        return None

    @lazy
    def minimum(self) -> Number:
        """The lowest value, in the unit of the interface; -inf where none is given."""
        return self._parameter("min", -math.inf)

    @lazy
    def maximum(self) -> Number:
        """The highest value, in the unit of the interface; inf where none is given."""
        return self._parameter("max", math.inf)

    @lazy
    def initial(self) -> Number:
        """The value to begin with; nan where none is given."""
        return self._parameter("initial_value", math.nan)

    data_type = word("data_type", "double", "The type of its values: ``double``, ``bool`` …")

    @property
    def malformed(self) -> tuple[tuple[str, Number], ...]:
        """Its minimum, maximum and initial value, as far as they are not numbers and should be."""
        found = [("min", self.minimum), ("max", self.maximum)] if self.is_limited else []
        if not self.is_command and self.data_type != "bool":
            found.append(("initial_value", self.initial))
        return tuple(
            (name, each)
            for name, each in found
            if each.text and not is_expression(each.text) and not _is_number(each)
        )

    @property
    def widened(self) -> Iterator[tuple[str, Number, Number]]:
        """Its minimum and maximum, as far as a stricter limit of the joint counts, with that limit."""
        joint = self.component.joint
        if joint is None or not self.is_limited:
            return
        limit = joint.axis.limit
        if self.name == "position" and limit.is_given and joint.type in {"revolute", "prismatic"}:
            if self.minimum.is_given and self.minimum.number < limit.lower.number and limit.lower.is_given:
                yield "min", self.minimum, limit.lower
            if self.maximum.is_given and self.maximum.number > limit.upper.number and limit.upper.is_given:
                yield "max", self.maximum, limit.upper
        elif self.name in {"velocity", "effort"}:
            bound = limit.velocity if self.name == "velocity" else limit.effort
            for name, number in (("min", self.minimum), ("max", self.maximum)):
                if bound.is_given and number.is_given and abs(number.number) > abs(bound.number):
                    yield name, number, bound

    def parameter(self, name: str) -> Element | None:
        """The last ``param`` of a name: it counts."""
        found = [each for each in self.children("param") if each.attributes.get("name", "").strip() == name]
        return found[-1] if found else None

    def _parameter(self, name: str, default: float) -> Number:
        element = self.parameter(name)
        if element is None:
            return Number.of(None, self.element, default)
        return Number.of(element.own_value, element, default)


def _is_number(number: Number) -> bool:
    """Is a text exactly one finite number?"""
    return math.isfinite(number.number) and "_" not in number.text


# ``<ros2_control>`` blocks: the hardware behind the joints, sensors and other signals of a robot.
#
# Source: the component parser of ros2_control, humble to rolling.


COMPONENTS = frozenset(("joint", "sensor", "gpio"))

GAZEBO_SYSTEMS = frozenset(
    ("gazebo_ros2_control/GazeboSystem", "gz_ros2_control/GazeboSimSystem", "ign_ros2_control/IgnitionSystem")
)
"""The plugins whose hardware is a joint of a simulator."""


_COUNTS = frozenset(("size", "thread_priority"))
"""The attributes that are whole numbers from 1 on."""


class Ros2Control(JointNames):
    """A ``ros2_control`` block: one piece of hardware."""

    __slots__ = ()
    kind = "ros2_control"

    @property
    def type(self) -> str:
        """``system``, ``actuator`` or ``sensor``."""
        return self._text("type") or ""

    type_value = given_text("type", "Its type with its place.")

    @property
    def hardware(self) -> Element | None:
        """The element ``hardware``."""
        return self.find("hardware")

    @property
    def plugin_value(self) -> Value | None:
        """The name of the plugin that drives the hardware, with its place; None where no element holds one."""
        element = self.hardware.find("plugin") if self.hardware is not None else None
        return None if element is None else element.own_value

    @property
    def is_simulated(self) -> bool:
        """Is its hardware a simulator's?"""
        plugin = self.plugin_value
        return plugin is not None and plugin.text in GAZEBO_SYSTEMS

    @lazy
    def components(self) -> tuple[ControlComponent, ...]:
        """Its joints, sensors and other signals, in the order of the file."""
        return tuple(
            cast("ControlComponent", self.part(child))
            for child in self.children()
            if child.name in COMPONENTS
        )

    @lazy
    def joints(self) -> dict[str, ControlComponent]:
        """Name → its joint, of several the first."""
        found: dict[str, ControlComponent] = {}
        for component in self.components:
            if component.what == "joint":
                found.setdefault(component.name, component)
        return found

    @lazy
    def known(self) -> tuple[tuple[Element, Definition], ...]:
        """The elements that ros2_control reads, itself first, each with what is allowed in it."""
        from sdfcheck.formats.urdf.schema import control

        return tuple(control().known(self.element))

    @property
    def lacking(self) -> Iterator[tuple[Element, str]]:
        """The attributes that its elements need and do not have."""
        for element, definition in self.known:
            for name in definition.required_attributes:
                if element.attribute(name) is None:
                    yield element, name

    @property
    def unsound(self) -> Iterator[tuple[Value, AttributeDefinition]]:
        """The attributes that are not of their kind, each with what it should be."""
        for element, definition in self.known:
            for name, attribute in definition.attributes.items():
                value = element.attribute(name)
                if value is not None and not _is_sound(value, attribute):
                    yield value, attribute

    @property
    def foreign(self) -> Iterator[tuple[Element, Element, Definition]]:
        """The elements that ros2_control does not know, each with the one that it is in."""
        for element, definition in self.known:
            for child in element.children():
                if child.name not in definition.children:
                    yield child, element, definition

    @property
    def without_plugin(self) -> Iterator[Element]:
        """Itself if it has no hardware, and its hardware and transmissions without a plugin."""
        if self.hardware is None:
            yield self.element
        for holder in self.children():
            if holder.name in {"hardware", "transmission"}:
                plugin = holder.find("plugin")
                if plugin is None or not plugin.content:
                    yield holder if plugin is None else plugin

    transmissions: lazy[tuple[ControlTransmission, ...]] = parts("transmission", "Its transmissions.")

    @property
    def first_of_name(self) -> Ros2Control | None:
        """The block before it that has its name."""
        if not self.name or is_expression(self.name):
            return None
        first = self.model.control_by_name.get(self.name, self)
        return None if first is self else first


class ControlTransmission(JointNames):
    """A transmission in a ``ros2_control`` block: its plugin is the hardware's business."""

    __slots__ = ()
    kind = "transmission"

    @property
    def block(self) -> Ros2Control:
        """The block that it is in."""
        return cast("Ros2Control", self.holder)

    @property
    def model(self) -> Model:
        return self.block.model

    @property
    def unresolved(self) -> tuple[Value, ...]:
        """The names that no joint of the block has."""
        known = self.block.joints
        return tuple(v for v in self.joint_names if v.text not in known and not is_expression(v.text))


def _is_sound(value: Value, attribute: AttributeDefinition) -> bool:
    """Is a value of the kind that ros2_control expects, or made by an expression?"""
    text = value.text.strip()
    if is_expression(text) or attribute.name == "type":
        return True
    if attribute.type == "bool":
        return text.lower() in {"true", "false"}
    if attribute.listed:
        return text in attribute.listed
    return attribute.name not in _COUNTS or (text.isdecimal() and int(text) > 0)


# How a world is simulated: physics profiles, states, actors, grippers.


class Physics(Part):
    """A physics profile of a world."""

    __slots__ = ()
    kind = "physics"

    type = word("type", "", "The engine: ``ode``, ``bullet``, ``dart`` …")

    @property
    def is_default(self) -> bool:
        """Is it the profile that is used?"""
        return is_true(self._text("default") or "")

    max_step_size = number("max_step_size", 0.001, "s.")
    real_time_factor = number("real_time_factor", 1.0, "Simulated seconds per second.")


class State(Part):
    """The state to which a world is restored."""

    __slots__ = ()
    kind = "state"

    @property
    def world(self) -> Scope | None:
        """The world that it is a state of."""
        return self.holder if isinstance(self.holder, Scope) and self.holder.kind == "world" else None

    world_value = given_text("world_name", "The name of the world that it writes, with its place.")

    @lazy
    def unresolved(self) -> tuple[UnknownName, ...]:
        """The name of a world that is another one, or else the names that no model of the world has."""
        world, value = self.world, self.world_value
        if world is None or not world.is_complete:
            return ()
        if value is not None and value.text.strip() not in {"", DEFAULT, world.name}:
            return (UnknownName(value, "world", self.root.element, (world.name,)),)
        models = tuple(name for name, node in world.nodes.items() if node.kind == "model")
        states = (state for kind in ("model", "model_state") for state in self.children(kind))
        names = (state.attribute("name") for state in states)
        return tuple(
            UnknownName(name, "model", world.element, models)
            for name in names
            if name is not None and "::" not in name.text and name.text not in models
        )


class Actor(Part):
    """A figure that moves along a trajectory."""

    __slots__ = ()
    kind = "actor"

    plugins: lazy[tuple[Plugin, ...]] = parts("plugin", "Its plugins.")

    @property
    def animations(self) -> tuple[Element, ...]:
        """Its animations."""
        return tuple(self.children("animation"))

    @property
    def trajectories(self) -> tuple[Element, ...]:
        """The trajectories of its script."""
        script = self.find("script")
        return tuple(script.children("trajectory")) if script is not None else ()


class Gripper(Part):
    """A gripper of a model."""

    __slots__ = ()
    kind = "gripper"

    @property
    def link_names(self) -> tuple[Value, ...]:
        """The names of links that it writes, with their places."""
        names = (name for kind in ("gripper_link", "palm_link") for name in self.children(kind))
        return tuple(name.own_value for name in names if name.content)

    @lazy
    def unresolved(self) -> tuple[UnknownName, ...]:
        """The names that are not those of links."""
        scope = self.holder
        if not isinstance(scope, Scope):
            return ()
        names = [value for value in self.link_names if not _is_link(scope, value.text)]
        links = tuple(link.name for link in scope.links) if names else ()
        return tuple(UnknownName(value, "link", scope.element, links) for value in names)


def _is_link(scope: Scope, name: str) -> bool:
    """Is it the name of a link, or may it be one? An element with an empty part is reported as that."""
    if name == DEFAULT or "" in name.split("::"):
        return True
    found = scope.resolve(name)
    return scope.may_hold(name) if found is None else found.kind == "link"


# The names by which the joints of a world or model refer to nothing, and those of them that others explain.


Unresolved = dict[str, list["Value"]]
"""Name → the ends of joints that use it."""


def unresolved_ends(scope: Scope) -> Unresolved:
    """The names that name nothing in a scope of SDFormat, with the ends of its joints that use them.

    Left out are names that are malformed or might be in a file that could not be read,
    and joints whose ends are one name, or whose child is the world.
    """
    found: Unresolved = {}
    for element in scope.children("joint"):
        joint = cast("Joint", scope.part(element))
        if joint.kind != "joint" or joint.child_name in {"world", joint.parent_name}:
            continue
        for value, node in ((joint.parent_value, joint.parent), (joint.child_value, joint.child)):
            if value is None or node is not None or "" in value.text.split("::"):
                continue
            if not scope.may_hold(value.text):
                found.setdefault(value.text, []).append(value)
    return found


def lost_names(scope: Scope, unresolved: Collection[str]) -> frozenset[str]:
    """The unresolved names that belong to parts of the scope with the name of another, where that is reported.

    There are not more of them than such parts, and parts without a name.
    """
    nameless = len(scope.nameless)
    if len(unresolved) <= nameless:
        return frozenset()
    parts = [child for child in scope.children() if child.name in NODES]
    names = [name for part in parts if (name := part.attributes.get("name", "").strip())]
    doubled = len(names) - len(set(names))
    if not doubled:
        return frozenset()
    from sdfcheck.formats.near_names import suggest_in

    # A name like another may be misspelled, while a part with the name of another has lost any name.
    document = scope.document
    unlike = frozenset(name for name in unresolved if suggest_in(document, name, set(names)) is None)
    return unlike if len(unlike) <= nameless + doubled else frozenset()


MOST_ALIKE = 100
"""Of links with the same moments, so many are looked at together."""


class Scope(Namespace):
    """A model or a world.

    ``is_complete`` is False where an include could not be read, so that an unknown name
    proves nothing.
    """

    __slots__ = ()

    # Content

    @lazy
    def links(self) -> tuple[Link, ...]:
        """The links directly in it, in the order of the file."""
        return cast("tuple[Link, ...]", self._members("link"))

    @lazy
    def alike_inertials(self) -> Mapping[Element, list[Inertial]]:
        """The links directly in it → the masses of those with the same moments, in the order of the file.

        Of more than MOST_ALIKE the next ones are lists of their own.
        """
        found: dict[Element, list[Inertial]] = {}
        last: dict[object, list[Inertial]] = {}
        for link in self.links:
            moments = link.inertial.tensor
            if len(last.get(moments, ())) in {0, MOST_ALIKE}:
                last[moments] = []
            last[moments].append(link.inertial)
            found[link.element] = last[moments]
        return found

    @lazy
    def has_collisions(self) -> bool:
        """Does one of the links directly in it have a collision?"""
        return any(link.collisions for link in self.links)

    @lazy
    def joints(self) -> tuple[Joint, ...]:
        """The joints directly in it, in the order of the file."""
        return cast("tuple[Joint, ...]", self._members("joint"))

    @lazy
    def frames(self) -> tuple[Frame, ...]:
        """The frames that are written as ``frame``, and those of merged models."""
        return cast("tuple[Frame, ...]", self._members("frame"))

    @lazy
    def models(self) -> tuple[Model, ...]:
        """The models directly in it, included ones among them."""
        return cast("tuple[Model, ...]", self._members("model"))

    @lazy
    def unresolved(self) -> Unresolved:
        """The names by which its joints refer to nothing, with the ends of joints that use them."""
        return unresolved_ends(self)

    @lazy
    def lost_names(self) -> frozenset[str]:
        """Those of the unresolved names that are reported elsewhere: at parts that lost them to the name of another."""
        return lost_names(self, self.unresolved)

    @lazy
    def nameless(self) -> tuple[Span, ...]:
        """The places of parts of it that have no name of their own, or are misspelled, where that is reported."""
        found = [span for name in sorted(NODES) if (span := self.misnamed(name)) is not None]
        none = {""} if self.is_urdf else {"", WORLD_FRAME}
        for element in self.children():
            if element.name in NODES and element.attributes.get("name", "").strip() in none:
                name, part = element.attribute("name"), self.part(element)
                found.append(part.misnamed("name") or element.span if name is None else name.span)
        return tuple(found)

    def fault_of(self, name: str) -> Span | None:
        """Where it is reported that nothing has a name: at the part that may have lost it, else where it is first used.

        By the ends of joints before the joints that mimic one, then frames, control and plugins.
        """
        count = len(self.unresolved) + (name not in self.unresolved)
        if count <= len(self.nameless):
            return self.nameless[0]
        return self._uses.get(name)

    @lazy
    def _uses(self) -> dict[str, Span]:
        """Name → where the parts of this scope use it first."""
        found: dict[str, Span] = {name: ends[0].span for name, ends in self.unresolved.items()}
        for value in self._further_uses():
            found.setdefault(value.text.strip(), value.span)
        return found

    def _further_uses(self) -> Iterator[Value]:
        """The names that its parts write, beside the ends of joints: of leaders all, else those that nothing has."""
        mimics = (axis.mimic for joint in self.joints for axis in joint.axes)
        yield from (
            mimic.leader_value for mimic in mimics if mimic is not None and mimic.leader_value is not None
        )
        yield from self.root.unresolved_frames.get(self, ())

    # Parts by name

    def model(self, key: str | int) -> Model:
        """A model by name (``outer::inner`` reaches into models) or by index; raises NotFound."""
        return pick(self, "model", self.models, key)

    def joint(self, key: str | int) -> Joint:
        """A joint by name, also of an inner model (``arm::elbow``), or by index; raises NotFound."""
        return pick(self, "joint", self.joints, key)

    def brought_by(self, found: Included) -> Model | None:
        from sdfcheck.robot.includes.included import DEEPEST, MOST_MODELS

        chain, inside = self.chain, found.document
        is_readable = (
            found.model is not None and inside is not None and inside not in chain and len(chain) <= DEEPEST
        )
        if is_readable:
            self.root.included += 1
            is_readable = self.root.included <= MOST_MODELS
        if found.name is None and not is_readable:
            return None
        model = Model(self, found.model if is_readable else found.include, found.name or "")
        model.registry = {}
        model.include, model.is_readable = found.include, is_readable
        if is_readable and inside is not None:
            model.chain = (*chain, inside)
        return model


# The names by which the joints of a URDF robot call its links, and those that the links have.


class LinkNames:
    """Which mistake explains a name that joints use and no link has: that in the joint, or that in the link."""

    def __init__(self, model: Model) -> None:
        self.model = model
        self.links: dict[str, Link] = model.tree.links
        self.unknown: dict[str, list[Value]] = {}
        """The names that joints use and no link has, with the places; unexpanded expressions are left out."""
        for joint in model.joints:
            for value in (joint.parent_value, joint.child_value):
                if value is not None and value.text not in self.links and not is_expression(value.text):
                    self.unknown.setdefault(value.text, []).append(value)

    @property
    def explained(self) -> set[str]:
        """The unknown names for which links are at fault, so that they are reported there."""
        return {*self.lost, *self.misspelled} if self.unknown else set()

    @lazy
    def lost(self) -> frozenset[str]:
        """The unknown names that belong to links without a name, or with that of another link."""
        if not self.unknown:
            return frozenset()
        nameless = self._nameless
        if len(self.unknown) <= nameless:
            return frozenset(self.unknown)
        doubled = len(self.model.links) - len(self.links) - self._unnamed
        if not doubled:
            return frozenset()
        from sdfcheck.formats.near_names import suggest_in

        # A name like that of a link may be misspelled, while a link with the name of another has lost any name.
        document = self.model.document
        unlike = frozenset(name for name in self.unknown if suggest_in(document, name, self.links) is None)
        return unlike if len(unlike) <= nameless + doubled else frozenset()

    @lazy
    def misspelled(self) -> dict[str, Link]:
        """Unknown names on which several joint ends agree → the link, used by no joint, that they mean."""
        agreed = [name for name, values in self.unknown.items() if len(values) > 1]
        if not agreed:
            return {}
        from sdfcheck.formats.near_names import suggest_in

        used = {name for joint in self.model.joints for name in (joint.parent_name, joint.child_name)}
        free = [name for name in self.links if name not in used]
        document = self.model.document
        found = {name: meant for name in agreed if (meant := suggest_in(document, name, free)) is not None}
        times = Counter(found.values())
        return {name: self.links[meant] for name, meant in found.items() if times[meant] == 1}

    @property
    def _unnamed(self) -> int:
        return sum(not link.name.strip() or is_expression(link.name) for link in self.model.links)

    @property
    def _nameless(self) -> int:
        """How many links have no name, one that is yet to be expanded, or are not even called ``link``."""
        from sdfcheck.formats.near_names import suggest
        from sdfcheck.formats.urdf.schema import urdf

        known = urdf().children
        others = (child.name for child in self.model.children() if child.name not in known)
        return self._unnamed + sum(suggest(name, ("joint", "link")) == "link" for name in others)


# The materials of a URDF robot, in the order in which urdfdom reads them: those of the robot, then of each link.


class MaterialNames:
    """The materials that the names in a robot reach. Nobody reads those of collisions."""

    def __init__(self, model: Model) -> None:
        self.model = model
        self.defined: dict[str, Material] = {}
        """Name → the first definition: one of the robot, or of the first visual that says what it looks like."""
        self.redefined: list[tuple[Material, Material]] = []
        """Materials that look otherwise than the first of their name, with that one."""
        nameless = 0
        for material in model.materials:
            if name := material.element.text_of("name"):
                self.defined.setdefault(name, material)
            else:
                nameless += 1
        missing: dict[str, list[Material]] = {}
        for name, material in self._used():
            if material.has_look:
                first = self.defined.setdefault(name, material)
                if first.has_look and first.look != material.look:
                    self.redefined.append((material, first))
            elif name not in self.defined and not material.has_foreign_colors:
                missing.setdefault(name, []).append(material)
        # Where a material has lost its name, that is reported, not wherever it is missed.
        found = missing if len(missing) > nameless else {}
        self.undefined = {name: uses for name, uses in found.items() if not is_expression(name)}
        """Names of which nothing has said the look so far, not even in SDFormat → the materials that only name them."""

    def _used(self) -> Iterator[tuple[str, Material]]:
        for link in self.model.links:
            for visual in link.visuals:
                value = visual.own_material.name_value
                if value is not None and value.text:
                    yield value.text, visual.own_material


# Models: robots and everything else that has links.


Built_co = TypeVar("Built_co", covariant=True)
_BOOLEANS = frozenset({"true", "1", "false", "0"})


class Builder(Protocol[Built_co]):
    """A consumer of which it is known what it makes of a robot."""

    def build(self, robot: Model) -> Built_co:
        """The robot that it makes of one."""


_DRIVING = ("drive", "controller", "steering", "thruster")
"""Words in the names of libraries of Gazebo that move joints."""


_WITHIN_LIMITS = frozenset({"revolute", "prismatic"})
"""The types of joints that move within limits."""
_FOUND = pattern(r"\$\(find [^()]*\)")
_NAMED_JOINT = r"<joint\s[^<>]*?\bname\s*=\s*[\"']([^\"']*)[\"']"
"""A name where xacro has not expanded it."""


class Model(Scope):
    """A model of SDFormat, or the robot of a URDF file.

    One that an include brought has its ``include``; its ``element`` is then that of the
    included file, or the ``include`` itself where the file cannot be read.
    """

    __slots__ = ("include",)
    kind = "model"

    def __init__(self, holder: Part, element: Element | None, name: str | None = None) -> None:
        super().__init__(holder, element, name)
        self.include: Element | None = None
        """The ``include`` that brought it, if one did."""
        self.is_urdf = self.element.name == "robot"

    def _further_uses(self) -> Iterator[Value]:
        yield from super()._further_uses()
        for part in (*self.ros2_control, *self.transmissions):
            yield from part.unresolved
        yield from (each.value for plugin in self.plugins for each in plugin.unresolved if each.node is None)

    @lazy
    def control_plugins(self) -> tuple[Plugin, ...]:
        """The plugins that start the controllers of ``ros2_control`` in Gazebo."""
        return tuple(plugin for plugin in self.plugins if "ros2_control" in plugin.filename)

    @lazy
    def controller_needs(self) -> tuple[tuple[Plugin, ControllerNeed], ...]:
        """The joints and sensors that controllers ask for, each with the plugin that names their file."""
        return tuple((plugin, need) for plugin in self.control_plugins for need in plugin.controllers.needs)

    @property
    def mistyped(self) -> Iterator[tuple[Plugin, Mistyped]]:
        """The parameters of controllers that are of another type than they declare, each with the plugin as above."""
        return ((plugin, each) for plugin in self.control_plugins for each in plugin.controllers.mistyped)

    @property
    def misspelled_parameters(self) -> Iterator[tuple[Plugin, Misspelled]]:
        """The parameters that a controller does not read, each with the plugin as above, and what was meant."""
        return ((plugin, each) for plugin in self.control_plugins for each in plugin.controllers.misspelled)

    @property
    def lacking_parameters(self) -> Iterator[tuple[Plugin, Lacking]]:
        """The parameters that a controller cannot do without, each with the plugin as above."""
        return (
            (plugin, each)
            for plugin in self.control_plugins
            if len(list(plugin.children("parameters"))) == 1
            for each in plugin.controllers.lacking
        )

    @property
    def strange_controllers(self) -> Iterator[tuple[Plugin, Misspelled]]:
        """The controllers of a type that there is not, each with the plugin as above, and one that there is."""
        return ((plugin, each) for plugin in self.control_plugins for each in plugin.controllers.strange)

    @lazy
    def idle_broadcaster(self) -> str:
        """The controller that publishes the states of joints, if none of its ``ros2_control`` blocks has a state."""
        parts = [part for block in self.ros2_control for part in block.components]
        if not parts or any(not each.is_command for part in parts for each in part.interfaces):
            return ""
        return next(filter(None, (plugin.controllers.broadcaster for plugin in self.control_plugins)), "")

    @lazy
    def claims(self) -> dict[str, list[ControllerNeed]]:
        """Joint → its interfaces that controllers claim."""
        claimed = (need for _, need in self.controller_needs if need.interface)
        return grouped(claimed, lambda need: need.name)

    @property
    def place(self) -> Element:
        return self.element if self.include is None else self.include

    @property
    def is_complete(self) -> bool:
        is_open = self.document.is_open or self.document.kind is Kind.XACRO
        return self.is_readable and not is_open and super().is_complete

    def _fill(self, nodes: dict[str, Node]) -> None:
        if self.is_readable:
            super()._fill(nodes)

    # Content

    @lazy
    def plugins(self) -> tuple[Plugin, ...]:
        """The plugins of the model; in URDF those of its ``<gazebo>`` blocks without reference."""
        if self.is_urdf:
            blocks = (block for block in self.gazebo_blocks if not block.reference)
            return tuple(plugin for block in blocks for plugin in block.plugins)
        return tuple(self._parts("plugin"))

    @lazy
    def materials(self) -> tuple[Material, ...]:
        """The materials that a URDF robot defines for all its links."""
        return tuple(self._parts("material")) if self.is_urdf else ()

    @lazy
    def transmissions(self) -> tuple[Transmission, ...]:
        """The transmissions of a URDF robot."""
        return tuple(self._parts("transmission")) if self.is_urdf else ()

    @lazy
    def ros2_control(self) -> tuple[Ros2Control, ...]:
        """The ``ros2_control`` blocks of a URDF robot."""
        return tuple(self._parts("ros2_control")) if self.is_urdf else ()

    @lazy
    def has_simulated_hardware(self) -> bool:
        """Do some of its ``ros2_control`` blocks ask for the hardware of a simulator?"""
        return any(block.is_simulated for block in self.ros2_control)

    @lazy
    def mostly_has_speeds(self) -> bool:
        """Have most joints that move within limits a velocity above 0?"""
        moving = (joint for joint in self.joints if joint.moves and joint.type in _WITHIN_LIMITS)
        speeds = [joint.axis.limit.velocity for joint in moving]
        return 2 * sum(speed > 0 for speed in speeds) > len(speeds)

    @lazy
    def lost_references(self) -> frozenset[str]:
        """The references of ``<gazebo>`` blocks that name no link or joint."""
        return frozenset(block.reference for block in self.gazebo_blocks if block.is_unresolved)

    @lazy
    def control_joints(self) -> dict[str, list[ControlComponent]]:
        """The joints of all ``ros2_control`` blocks by their names; of two of one name in a block the first."""
        found: dict[str, list[ControlComponent]] = {}
        for block in self.ros2_control:
            for name, joint in block.joints.items():
                if name:
                    found.setdefault(name, []).append(joint)
        return found

    @property
    def unmet_needs(self) -> Iterator[tuple[Plugin, ControllerNeed]]:
        """The joints and sensors that controllers ask for and its ``ros2_control`` blocks do not have.

        A file of parameters may be for several robots: a controller without any joint of this one counts only if there
        is no other that has one, or if the name is nearly that of a joint that no other controller has; and a sensor
        only if there is another one.
        """
        if not self.ros2_control or self.document.is_open:
            return
        from sdfcheck.formats.near_names import nearest

        sensors = {
            each.name for block in self.ros2_control for each in block.components if each.what == "sensor"
        }
        known = {need.controller for _, need in self.controller_needs if need.name in self.control_joints}
        named = {need.name for _, need in self.controller_needs}
        left = [name for name in self.control_joints if name not in named]
        for plugin, need in self.controller_needs:
            if need.what == "sensor":
                if sensors and need.name not in sensors:
                    yield plugin, need
            elif need.interface or not self._lacks(need.name):
                continue
            elif need.controller in known or not known or nearest(need.name, left, self.document):
                yield plugin, need

    def _lacks(self, name: str) -> bool:
        """Has no block a joint of a name, whatever the arguments are?"""
        is_prefixed = self.document.is_expanded and name.endswith(tuple(filter(None, self.control_joints)))
        is_there = name in self.control_joints or is_prefixed
        return not is_there and not self.document.may_name(_NAMED_JOINT, name)

    @lazy
    def poses_at_rest(self) -> dict[Link, Origin]:
        """The poses of the links of a robot of URDF in its root, all joints at zero, in plain numbers."""
        return _links_at(self, {})

    def poses_with(self, places: Mapping[str, float]) -> dict[Link, Origin]:
        """The same with some joints elsewhere (rad or m)."""
        return _links_at(self, places)

    def gaps(self, least: Mapping[Joint, float]) -> dict[Joint, float]:
        """How far what joints carry is from the rest of the robot of URDF at rest (m); 0 if not more than is given.

        Robots with very many links are not looked at.
        """
        if len(self.links) > _MOST_SKINS:
            return dict.fromkeys(least, 0.0)
        rows = _said_by_surfaces(
            self, least, lambda: [(_gap(joint, bound),) for joint, bound in least.items()]
        )
        return {joint: row[0] for joint, row in zip(least, rows, strict=True)}

    @lazy
    def reaches(self) -> dict[Joint, Reach]:
        """How far its one-sided joints move their parts into their parents, where that is more than a little."""
        joints = dict.fromkeys((joint for joint in self.joints if joint.is_one_sided), 0.0)
        rows = _said_by_surfaces(self, joints, lambda: [_reach(joint) or () for joint in joints])
        return {joint: Reach(*row) for joint, row in zip(joints, rows, strict=True) if row}

    @lazy
    def links_of_each_side(self) -> dict[str, list[Link]]:
        """Its links by their names without sides."""
        return grouped(self.links, lambda link: without_sides(link.name))

    @lazy
    def joints_of_each_side(self) -> dict[str, list[Joint]]:
        """Its joints by their names without sides."""
        return grouped(self.joints, lambda joint: without_sides(joint.name))

    @lazy
    def twins(self) -> dict[object, list[Joint]]:
        """Its joints by what they carry; those that carry nothing that can be compared under None."""
        return grouped(self.joints, _twin_key)

    @lazy
    def drivers(self) -> dict[Joint, Part]:
        """The joints that something moves on command, each with the first that does."""
        found: dict[Joint, Part] = {}
        for joint, driver in self._drives():
            if joint is not None:
                found.setdefault(joint, driver)
        return found

    def _drives(self) -> Iterator[tuple[Joint | None, Part]]:
        for components in self.control_joints.values():
            yield from ((component.joint, component) for component in components if component.commands)
        for transmission in self.transmissions:
            names = transmission.joint_names
            yield from ((self.joints_by_name.get(name.text), transmission) for name in names)
        for element in self.root.elements.get("plugin", ()):
            plugin = cast("Plugin", self.root.part_of(element))
            if plugin.kind == "plugin" and any(word in plugin.filename.lower() for word in _DRIVING):
                joints = (each.joint for each in plugin.references)
                yield from ((joint, plugin) for joint in joints if joint is not None and joint.model is self)

    @lazy
    def control_by_name(self) -> dict[str, Ros2Control]:
        """The ``ros2_control`` blocks of a URDF robot, by name; of two of one name the first."""
        found: dict[str, Ros2Control] = {}
        for block in self.ros2_control:
            found.setdefault(block.name, block)
        return found

    @lazy
    def gazebo_blocks(self) -> tuple[GazeboBlock, ...]:
        """The ``<gazebo>`` blocks of a URDF robot."""
        return tuple(self._parts("gazebo")) if self.is_urdf else ()

    @lazy
    def blocks_by_reference(self) -> dict[str, list[GazeboBlock]]:
        """The ``<gazebo>`` blocks by the link or joint that they are about; those about the robot under ``""``."""
        return grouped(self.gazebo_blocks, lambda block: block.reference)

    @lazy
    def extended(self) -> Model:
        """The same robot with what its ``<gazebo>`` blocks add, as Gazebo has it."""
        return ExtendedModel(self, self.element)

    # Properties

    @property
    def is_static(self) -> bool:
        """Does nothing in it move, because it or a model around it is static?"""
        outer = self.holder
        return self.stands_still or (isinstance(outer, Model) and outer.is_static)

    @property
    def may_be_static(self) -> bool:
        """Is it static, or does it say something about that which is neither true nor false?"""
        if self.is_static or (not self.is_urdf and self.misnamed("static")):
            return True
        value = self.static_value
        return value is not None and value.text.strip().lower() not in _BOOLEANS

    @property
    def is_included_as_static(self) -> bool:
        """Is it the model of a file that was reached by an include which makes it static?"""
        from sdfcheck.robot.includes.included import is_made_static

        return self.holder is self.root and is_made_static(self.document)

    @lazy
    def static_value(self) -> Value | None:
        """Where it says whether it is static."""
        given = self.include.find("static") if self.include is not None else None
        if given is None:
            given = self.find("static")
        return None if given is None else given.own_value

    @lazy
    def stands_still(self) -> bool:
        if self.is_urdf:
            blocks = self.blocks_by_reference.get("", ())
            return any(is_true(static.content) for block in blocks for static in block.children("static"))
        value = self.static_value
        return value is not None and is_true(value.text)

    @property
    def canonical_link_value(self) -> Value | None:
        """The reference to its canonical link, with its place; None if nothing is written."""
        value = self.attribute("canonical_link")
        return value if value is not None and value.text.strip() else None

    @property
    def canonical_link_name(self) -> str:
        """The name that ``canonical_link`` writes; empty if there is none."""
        value = self.canonical_link_value
        return "" if value is None else value.text.strip()

    @lazy
    def canonical_link(self) -> Link | None:
        """The link that the model moves with: the one that it names, or its first, nested models included."""
        node = self.attachment
        seen: set[Node] = set()
        while isinstance(node, Model) and node not in seen:
            seen.add(node)
            node = node.attachment
        return cast("Link", node) if node is not None and node.kind == "link" else None

    @property
    def attachment(self) -> Node | None:
        if not self.is_complete or self.canonical_link_name:
            return self.resolve(self.canonical_link_name) if self.is_complete else None
        first = next((node for node in self.nodes.values() if node.kind == "link"), None)
        if first is not None:
            return first
        return next((node for node in self.nodes.values() if node.kind == "model"), None)

    @property
    def pose_element(self) -> Element | None:
        own = self.include.find("pose") if self.include is not None else None
        return self.find("pose") if own is None and self.is_readable else own

    @property
    def placement_frame_value(self) -> Value | None:
        """The frame that its pose places, as the model itself writes it, with its place."""
        value = self.attribute("placement_frame")
        return value if value is not None and value.text.strip() else None

    @property
    def placement_frame(self) -> str:
        """The name of the frame of the model that its pose places; empty: its own frame."""
        given = self.include.find("placement_frame") if self.include is not None else None
        if given is not None and given.content:
            return given.content
        return (self._text("placement_frame") or "").strip()

    @property
    def lowest(self) -> tuple[Shape, float] | None:
        """The plain shape of its collisions that reaches lowest in what it is in, and that height (m), at its start.

        None where there is none, or its place is not known.
        """
        try:
            return _lowest(self)
        except DescriptionError:
            return None

    @property
    def is_on_its_side(self) -> bool:
        """Has it a drive, and does its pose in SDFormat turn the axes of the wheels upwards?"""
        plugins = (each for each in self.plugins if each.kind == "plugin")
        drive = next((each.drive for each in plugins if each.drive is not None), None)
        try:
            pose = _at_rest_in_sdf(self) if drive is not None and not self.is_urdf else None
        except DescriptionError:
            return False
        if drive is None or pose is None or abs(pose.rotation[2][2]) > _STEEP:
            return False
        x, y, z = drive.left.axis
        return abs(pose.turned((x, y, z))[2]) > _STEEP

    # How it hangs together

    @lazy
    def tree(self) -> Tree:
        """Its links and joints as a tree: roots, children, parents, loops."""
        return Tree(self)

    @lazy
    def joints_by_name(self) -> dict[str, Joint]:
        """Its joints by name, of several of a name the first; in URDF a link may have the same name."""
        found: dict[str, Joint] = {}
        for joint in self.joints:
            found.setdefault(joint.name, joint)
        return found

    @lazy
    def driven(self) -> dict[str, Joint]:
        """In URDF: the joints that something can drive by name, Drake's own (``drake:joint``) among them."""
        elements = (child for child in self.children() if child.name in {"joint", "drake:joint"})
        found: dict[str, Joint] = {}
        for joint in cast("Iterator[Joint]", map(self.part, elements)):
            found.setdefault(joint.name, joint)
        return found

    @lazy
    def unresolved(self) -> Unresolved:
        return self.link_names.unknown if self.is_urdf else super().unresolved

    @lazy
    def lost_names(self) -> frozenset[str]:
        return frozenset(self.link_names.explained) if self.is_urdf else super().lost_names

    @lazy
    def link_names(self) -> LinkNames:
        """In URDF: the names by which joints call links, and those that the links have."""
        return LinkNames(self)

    @lazy
    def material_names(self) -> MaterialNames:
        """In URDF: what the names of its materials reach."""
        return MaterialNames(self)

    def as_built_by(self, consumer: Builder[Built_co]) -> Built_co:
        """In URDF: the robot that a consumer makes of it."""
        if consumer not in self._built:
            self._built[consumer] = consumer.build(self)
        return cast("Built_co", self._built[consumer])

    @lazy
    def _built(self) -> dict[object, object]:
        return {}

    @property
    def mass_properties(self) -> MassProperties | None:
        """Mass, center of mass and inertia of all its links, in its frame; None if no link has any."""
        from sdfcheck.robot.motion.mass import default_mass, joined

        bodies: list[MassProperties] = []
        for link in self.all_links():
            body = link.mass_properties or (None if link.is_urdf else default_mass())
            if body is not None:
                bodies.append(body.seen_from(self.root.poses.reached(self, link)))
        return joined(bodies)

    @lazy
    def reach(self) -> float:
        """The longest distance (m) from a joint of the robot to the one that carries it; 0 where that is unknown.

        In SDFormat the longest distance of a link from the first one.
        """
        return _reach_of(self)

    @lazy
    def has_mesh(self) -> bool:
        """Has one of its links a shape whose mesh file is there?"""
        return any(link.has_mesh for link in self.links)

    @lazy
    def density(self) -> float:
        """The mass of its links by the volume of the boxes around their shapes (kg/m³); nan where few are known."""
        return _density_of(self)

    @property
    def is_out_of_scale(self) -> bool:
        """Is it, as a whole, lighter than air, or heavier than any material by far?"""
        if not self.joints or self.may_be_static or not self.has_mesh:
            return False
        if 0.05 < self.density < 1:  # of a small one, the masses may be placeholders
            boxes = (shape.geometry.box for link in self.links for shape in link.shapes)
            return any(box is not None and max(box.size) > 1 for box in boxes)
        return 0 < self.density < 0.05 or self.density > 1e6

    @property
    def bounds(self) -> Array | None:
        """The box around the bounds of all its links, all joints at zero: lowest and highest x, y, z.

        In m, in its frame, shape (2, 3); None where no shape has a known size. Raises PoseError.
        """
        from sdfcheck.bodies.box import of_points
        from sdfcheck.robot.motion.poses import origin_from

        corners: list[Triple] = []
        for link in self.all_links():
            if (box := link.box) is not None:
                pose = origin_from(self.root.poses.reached(self, link))
                corners += (pose.applied_to((x, y, z)) for x, y, z in box.corners())
        return as_array(of_points(corners) if corners else None)

    # Parts by name

    def link(self, key: str | int) -> Link:
        """A link by name, also of an inner model (``arm::hand``), or by index; raises NotFound."""
        return pick(self, "link", self.links, key)

    def all_links(self) -> Iterator[Link]:
        """The links of the model and of all models in it."""
        return (cast("Link", node) for _, node in self.all_nodes() if node.kind == "link")


# ``<gazebo>`` blocks: what a URDF file says to Gazebo, in SDFormat.


def text_of_setting(element: Element) -> str:
    """The text of a setting, or its ``value`` attribute, with one space between words."""
    return " ".join((element.content or element.attributes.get("value", "")).split())


_NAMED_PART = r"<(?:link|joint)\s[^<>]*?\bname\s*=\s*[\"']([^\"']*)[\"']"


class GazeboBlock(Part):
    """A ``<gazebo>`` block about a link, a joint, or (without ``reference``) the robot.

    Sensors, lights, plugins, joints and models in it are parts as in SDFormat.
    """

    __slots__ = ()
    kind = "gazebo"

    def __init__(self, holder: Part, element: Element | None) -> None:
        super().__init__(holder, element)
        self.is_urdf = False

    def misnamed(self, name: str) -> Span | None:
        from sdfcheck.formats.urdf.findings import misnamed

        return misnamed(self.element, name)

    @property
    def model(self) -> Model:
        """The robot."""
        return cast("Model", self.holder)

    @property
    def scope(self) -> Scope:
        """Where the names in it are looked up."""
        return self.model.extended

    @property
    def reference(self) -> str:
        """The name of the link or joint that it is about; empty for the robot."""
        return self._text("reference") or ""

    reference_value = given_text("reference", "The reference with its place.")

    @lazy
    def subject(self) -> Link | Joint | Model | None:
        """The part that it is about; None if the reference is not resolved."""
        return (
            cast("Link | Joint | None", self.model.resolve(self.reference)) if self.reference else self.model
        )

    @property
    def is_unresolved(self) -> bool:
        """Does its reference name no link or joint?

        Names with expressions are left out, names of missing links that joints use, and names of links and
        joints that xacro writes with other arguments, or in another robot that includes the same file.
        """
        name = self.reference
        if not name or self.link is not None or self.joint is not None:
            return False
        if is_expression(name) or name in self.model.link_names.unknown:
            return False
        if self.document.may_name(_NAMED_PART, name):
            return False
        return name not in self.document.names_of_others(_NAMED_PART, self.element)

    @property
    def link(self) -> Link | None:
        """The link that it is about; None if it is about something else."""
        subject = self.subject
        return cast("Link", subject) if subject is not None and subject.kind == "link" else None

    @property
    def joint(self) -> Joint | None:
        """The joint that it is about; None if it is about something else."""
        subject = self.subject
        return cast("Joint", subject) if subject is not None and subject.kind == "joint" else None

    sensors: lazy[tuple[Sensor, ...]] = parts("sensor")
    lights: lazy[tuple[Light, ...]] = parts("light")
    plugins: lazy[tuple[Plugin, ...]] = parts("plugin")
    joints: lazy[tuple[Joint, ...]] = parts("joint", "The joints of SDFormat that it adds.")
    models: lazy[tuple[Model, ...]] = parts("model", "The models that it adds.")

    def settings(self, name: str) -> Iterator[Value]:
        """The values of the settings of a name (``mu1``, ``material`` …): attribute ``value`` or text."""
        for child in self.children(name):
            yield child.attribute("value") or child.own_value

    @property
    def unread_settings(self) -> Iterator[tuple[Element, str]]:
        """The settings of libsdformat in it that are not for what it is about, and what they are for.

        That is link, joint or robot, or empty where only older releases read the setting.
        """
        if not self.reference:
            about = {"robot"}
        else:
            about = {kind for kind, part in (("link", self.link), ("joint", self.joint)) if part is not None}
        from sdfcheck.formats.urdf.schema import all_settings

        known = all_settings() if about else {}
        for child in self.children():
            setting = known.get(child.name)
            if setting is not None and setting.about not in about:
                yield child, setting.about

    @property
    def overridable(self) -> list[Element]:
        """The settings of libsdformat in it of which the last one counts, whichever block gives it."""
        from sdfcheck.formats.urdf.schema import settings

        known = {"gravity", "material", "static", *settings("link"), *settings("joint")}
        return [child for child in self.children() if child.name in known]

    def switched_on(self, name: str) -> list[Element]:
        """The settings of a name that are true."""
        from sdfcheck.formats.urdf.schema import TRUE

        return [value.element for value in self.settings(name) if value.text.strip().lower() in TRUE]

    def is_on(self, name: str) -> bool:
        """Is a setting of this name true?"""
        return bool(self.switched_on(name))


# The content of a ``<gazebo>`` block of a URDF robot.


def extension_parts(block: Element) -> Iterator[Element]:
    """The elements in a ``<gazebo>`` block; what is in plugins is theirs."""
    for child in block.children():
        yield child
        if child.name != "plugin":
            yield from extension_parts(child)


def with_extensions(index: Mapping[str, list[Element]]) -> Mapping[str, list[Element]]:
    """Name → elements, with those in the ``<gazebo>`` blocks that are among them."""
    found = {name: list(elements) for name, elements in index.items()}
    for element in (part for block in index["gazebo"] for part in extension_parts(block)):
        found.setdefault(element.name, []).append(element)
    return found


# A URDF robot as Gazebo has it: with the links, joints and models that its ``<gazebo>`` blocks add.


class ExtendedModel(Model):
    """The scope in which the SDFormat of ``<gazebo>`` blocks looks names up.

    Links and joints that libsdformat merges away leave frames of their names.
    """

    __slots__ = ("robot",)

    def __init__(self, holder: Part, element: Element | None, name: str | None = None) -> None:
        super().__init__(holder.root, element, name or holder.name)
        self.robot = cast("Model", holder)
        self.is_urdf = False

    def part(self, element: Element) -> Part:
        return self.root.part_of(element)

    def children(self, name: str | None = None) -> Iterator[Element]:
        """The parts that the blocks about the robot add to it."""
        for block in self.robot.blocks_by_reference.get("", ()):
            yield from block.children(name)

    def _fill(self, nodes: dict[str, Node]) -> None:
        nodes.update(self.robot.nodes)
        for child in self.children():
            if child.name == "include":
                self._unread = True
            elif child.name in NODES and (name := child.attributes.get("name", "").strip()):
                part = self.part(child)
                if part.kind == "model" and isinstance(part, Node):
                    nodes[name] = part  # of two things with this name the one with names in it
                elif isinstance(part, Node):
                    nodes.setdefault(name, part)


# Worlds.


_GROUND = pattern(r"(^|/)ground[_ ]plane(/\d+)?/?$", re.IGNORECASE)
"""The end of the addresses of Gazebo's ground."""


def _level(shape: Shape) -> float | None:
    """The height (m) of a plane in its world, if it is level and does not move."""
    model, normal = shape.link.model, shape.geometry.normal
    try:
        frame = _at_rest_in_sdf(shape.link)
        if frame is None or not model.is_static or len(normal) != 3 or reference_of(model.pose_element):
            return None
        placed = pose_in(model.pose_element).followed_by(frame).followed_by(_placement_in(shape, shape.link))
    except DescriptionError:
        return None
    x, y, z = normal
    is_level = placed.turned((x, y, z))[2] > _LEVEL * math.hypot(x, y, z)
    return placed.position[2] if is_level else None


_LEVEL = 0.9999


class World(Scope):
    """A world."""

    __slots__ = ()
    kind = "world"
    own_name = WORLD_FRAME

    physics: lazy[tuple[Physics, ...]] = parts("physics", "The physics profiles.")
    lights: lazy[tuple[Light, ...]] = parts("light", "The lights directly in it.")
    actors: lazy[tuple[Actor, ...]] = parts("actor", "The actors.")
    plugins: lazy[tuple[Plugin, ...]] = parts("plugin", "The plugins of the world itself.")

    gravity = vector("gravity", (0.0, 0.0, -9.8), "The acceleration of gravity (m/s²).")

    @lazy
    def floor(self) -> float | None:
        """The height (m) of its ground, a level plane that does not move; None without one, or of several."""
        heights = set()
        for element in self.root.elements.get("plane", ()):
            around = element.parent.parent if element.parent is not None else None
            shape = self.root.part_of(around) if around is not None and around.name == "collision" else None
            if isinstance(shape, Shape) and shape.within(World) is self:
                heights.add(_level(shape))
        for include in self.element.children("include"):
            uri = include.find("uri")
            if uri is not None and _GROUND.search(uri.content) and include.find("pose") is None:
                heights.add(0.0)
        return heights.pop() if len(heights) == 1 else None

    @property
    def has_unclear_system(self) -> bool:
        """Is a plugin of it misspelled, or the file of one, so that it may be any system?"""
        unclear = (plugin for plugin in self.plugins if not plugin.filename.strip() or plugin.meant_file)
        return next(unclear, None) is not None or self.misnamed("plugin") is not None

    @lazy
    def unserved_sensors(self) -> tuple[tuple[Sensor, tuple[str, ...]], ...]:
        """Its sensors that need a system of Gazebo which is not there, with those that would do.

        None where the world lists no system of gz-sim: Gazebo then brings its own.
        """
        elements = self.root.elements
        if not elements.get("sensor") or not elements.get("plugin"):
            return ()
        from sdfcheck.formats.plugins import GZ_SIM, served

        plugins: list[Plugin] = list(self.root.each("Plugin"))
        present = {plugin.known.file for plugin in plugins if plugin.known is not None}
        if not any(plugin.known is not None and plugin.known.generation == GZ_SIM for plugin in self.plugins):
            return ()
        if self.has_unclear_system:
            return ()
        needs = served()
        sensors: list[Sensor] = [s for s in self.root.each("Sensor") if s.within(World) is self]
        return tuple(
            (sensor, needs[sensor.type])
            for sensor in sensors
            if sensor.type in needs and present.isdisjoint(needs[sensor.type])
        )


# Includes: other files that become part of a model or world.


class Include(FileUse):
    """An ``include``."""

    __slots__ = ()
    kind = "include"

    @property
    def name(self) -> str:
        """The name that it gives to what it brings; empty where it gives none."""
        name = self.find("name")
        return name.content if name is not None else ""

    @lazy
    def uri_value(self) -> Value | None:
        """The uri with its place; None where there is none, or an element in it."""
        uri = self.find("uri")
        return uri.own_value if uri is not None and uri.content and not any(uri.children()) else None

    @lazy
    def found(self) -> Included:
        """Its target: file, document, model, or why there is not one."""
        from sdfcheck.robot.includes.included import included

        return included(self.document, self.element)

    # Where it leads

    @property
    def obstacle(self) -> Obstacle | None:
        """Why it brings nothing; None where it brings something, and for a text without other files around it."""
        return self.found.obstacle if self.document.library is not None else None

    @property
    def leads_nowhere(self) -> bool:
        """Is nothing where the uri leads, or nothing that is looked up?"""
        if self.obstacle is None or self._misspelling is not None:
            return False
        from sdfcheck.robot.includes.included import Obstacle

        return self.obstacle is Obstacle.NOT_FOUND

    @property
    def needs_config(self) -> bool:
        """Does it lead to a folder that has no ``model.config``?"""
        if self.obstacle is None or self._misspelling is not None:
            return False
        from sdfcheck.robot.includes.included import Obstacle

        return self.obstacle is Obstacle.NO_CONFIG

    @property
    def is_read_in_vain(self) -> bool:
        """Does it lead to a file that cannot be included? Broken XML or a wrong root is reported in that file."""
        if self.obstacle is None or self.found.file is None or self._misspelling is not None:
            return False
        from sdfcheck.robot.includes.included import Obstacle

        return self.obstacle not in {Obstacle.BROKEN, Obstacle.OUTSIDE}

    @property
    def is_searched_for(self) -> bool:
        """Does it name a model or package that is looked for on search paths? Nothing near by has been found, then.

        To libsdformat a bare word is the name of a model, too.
        """
        if self.location is None:
            return False
        is_word = not self.location.scheme and not {*self.uri} & {"/", "\\", "."}
        # The owner may be a folder that only has the name of the model.
        return is_word or (
            self.location.is_searched_for and self.location.owner in {None, self.location.path}
        )

    @property
    def is_misconfigured(self) -> bool:
        """Does it lead to a model folder that has a ``manifest.xml`` of old instead of a ``model.config``?"""
        config = self.found.config
        return config is not None and config.path.name == "manifest.xml"

    @lazy
    def ring(self) -> tuple[Value, ...]:
        """The uris that lead from it back to its file, outside in; empty if they do not."""
        if self.document.library is None or self.found.document is None:
            return ()
        from sdfcheck.robot.includes.included import ring

        return ring(self.document, self.element)

    # Content

    @property
    def placement_frame_value(self) -> Value | None:
        """The name of the frame of the model that its pose places, with its place; None if there is none."""
        placement = self.find("placement_frame")
        return placement.own_value if placement is not None and placement.content else None

    @lazy
    def node(self) -> Node | None:
        """The model that it brings whole, or the frame of one that it merges; None if neither."""
        if not isinstance(self.holder, Scope):
            return None
        return next((node for node in self.holder.nodes.values() if node.place is self.element), None)

    @property
    def model(self) -> Model | None:
        """The model that it brings whole; None if it brings none, or merges it."""
        return self.node if isinstance(self.node, Model) else None

    @property
    def content(self) -> Model | None:
        """The model that it brings, whole or merged."""
        return cast("Model", self.node.model) if isinstance(self.node, MergedFrame) else self.model

    @property
    def brought(self) -> Element | None:
        """The model, actor or light of the file that it leads to; None if there is none."""
        return self.found.model

    @property
    def is_merged(self) -> bool:
        """Do the parts of the model become parts of the one that includes it?"""
        return is_true(self._text("merge") or "")

    @property
    def merged_parts(self) -> tuple[tuple[str, str], ...]:
        """Kind and name of what moves from the model into the one that includes it, where it is merged."""
        if not self.is_merged or self.brought is None:
            return ()
        from sdfcheck.robot.includes.included import moved

        return tuple((kind, name) for kind, name, _ in moved(self.found))

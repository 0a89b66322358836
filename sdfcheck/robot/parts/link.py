"""Links, with their mass and inertia."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from functools import lru_cache
from typing import TYPE_CHECKING, cast

from sdfcheck.robot.graph import Node, Part
from sdfcheck.robot.parts import solids
from sdfcheck.robot.parts.solids import Moments, Solid
from sdfcheck.robot.values import MOMENTS, Number, is_true, lazy, number, parts
from sdfcheck.source.document import Element
from sdfcheck.source.sniff import Kind

if TYPE_CHECKING:
    from sdfcheck.bodies.box import Box
    from sdfcheck.robot.graph import Model
    from sdfcheck.robot.motion.mass import MassProperties
    from sdfcheck.robot.motion.origin import Origin
    from sdfcheck.robot.motion.rotations import Array
    from sdfcheck.robot.parts.gazebo import GazeboBlock
    from sdfcheck.robot.parts.joint import Joint
    from sdfcheck.robot.parts.plugin import Plugin
    from sdfcheck.robot.parts.sensor import Light, Sensor
    from sdfcheck.robot.parts.shape import Collision, Shape, Visual
    from sdfcheck.source.document import Value


# A quick look at a link's mass and inertia, for the many that are sound.
#
# It reads the numbers straight from the tree. An inertial that this look does not accept is looked at
# again, with places, by the rules about inertials.


_PLAUSIBLE = (0.01, 10.0)
"""Traces within these factors of a solid's are beyond suspicion."""
_REACH = 5.0
"""So are centers of mass this near to the origin, and links without shapes whose mass is not farther out (m)."""

SOUND = 1
"""The numbers are those of a body of about the size of the link's shapes."""
INSIDE = 2
"""The center of mass is inside of a shape."""
NEAR = 4
"""The moments are at most twice those of a solid of the shapes."""
FITTING = 8
"""They are so axis by axis, and the mass is that of a material."""
LIGHT = 16
"""The mass is that of a material."""
_DENSEST = 20_000.0
"""kg/m³: so is nothing that is heavier than any material."""
_EVEN = 1.2
"""Moments of a body within this factor of each other fit whatever way it is turned."""

_MOMENTS = ("ixx", "iyy", "izz", "ixy", "ixz", "iyz")
_ORIGIN = [0.0, 0.0, 0.0]

_MAKERS = {
    "box": lambda t: solids.box(*_three(t["size"])),
    "ellipsoid": lambda t: solids.ellipsoid(*_three(t["radii"])),
    "sphere": lambda t: solids.sphere(float(t["radius"])),
    "cylinder": lambda t: solids.cylinder(float(t["radius"]), float(t["length"])),
    "capsule": lambda t: solids.capsule(float(t["radius"]), float(t["length"])),
    "cone": lambda t: solids.cone(float(t["radius"]), float(t["length"])),
}


def soundness(link: Element) -> int:
    """The facts that are sure of a link's mass properties: the sum of the constants above."""
    inertial: Element | None = None
    collisions: list[Element] = []
    visuals: list[Element] = []
    for child in link.children():
        tag = child.name
        if tag == "collision":
            collisions.append(child)
        elif tag == "visual":
            visuals.append(child)
        elif tag == "inertial" and inertial is None:
            inertial = child
    try:
        mass, moments, center = _read(inertial)
        return _plausibility(mass, moments, center, collisions or visuals) if moments else 0
    except (KeyError, TypeError, ValueError, ZeroDivisionError):
        return 0


def _read(inertial: Element | None) -> tuple[float, tuple[float, ...], list[float]]:
    if inertial is None or "auto" in inertial.attributes:
        raise ValueError
    mass, center = "", _ORIGIN
    moments: list[str | None] = []
    for child in inertial.children():
        tag = child.name
        if tag == "mass":
            mass = child.text_of("value") or child.text or ""
        elif tag == "inertia":
            moments = list(map(_texts(child).get, _MOMENTS))
        elif tag in {"pose", "origin"}:
            center = _position(child)
        elif tag == "fluid_added_mass":
            raise ValueError
    return float(mass), _possible(mass, *moments), center


def _texts(element: Element) -> dict[str, str | None]:
    """The attributes of an element and the texts of its children, by name."""
    texts: dict[str, str | None] = dict(element.attributes)
    for child in element.children():
        texts[child.name] = child.text
    return texts


def _position(origin: Element) -> list[float]:
    if origin.name == "origin":
        return _three(origin.attributes.get("xyz", "0 0 0"))
    if origin.attributes:
        raise ValueError
    return _three(" ".join((origin.text or "0 0 0").split()[:3]))


def _three(text: str | None) -> list[float]:
    x, y, z = (text or "").split()
    return [float(x), float(y), float(z)]


@lru_cache(maxsize=1000)
def _possible(mass: str, *texts: str | None) -> tuple[float, ...]:
    """The moments of a body of this mass, in kg·m²; none if there is no such body."""
    if not (0 < float(mass) < math.inf and texts):
        return ()
    moments = tuple([float(text or 0) for text in texts])
    low, middle, high = solids.Moments(*moments).principal()
    return moments if low > 0 and low + middle >= high else ()


def _plausibility(mass: float, moments: tuple[float, ...], center: list[float], shapes: list[Element]) -> int:
    if math.hypot(*center) > _REACH:
        return 0
    placed = [found for shape in shapes if (found := _placed(shape)) is not None]
    if not placed:
        return SOUND | INSIDE | NEAR | FITTING | LIGHT if max(moments[:3]) <= _REACH * _REACH * mass else 0
    volume = total = 0.0
    is_inside = is_turned = False
    diagonal = [0.0, 0.0, 0.0]
    for solid, at, turned in placed:
        x, y, z = (a - b for a, b in zip(at, center, strict=True))
        distance = x * x + y * y + z * z
        volume += solid.volume
        total += solid.volume * (solid.moments.trace + 2 * distance)
        is_inside = is_inside or 2 * distance <= solid.moments.trace
        is_turned = is_turned or turned
        for axis, offset in enumerate((x, y, z)):
            diagonal[axis] += solid.volume * (solid.moments[axis] + distance - offset * offset)
    low, high = _PLAUSIBLE
    ratio = sum(moments[:3]) * volume / (mass * total)
    facts = (
        (SOUND if low <= ratio <= high else 0)
        | (NEAR if low <= ratio <= 2 else 0)
        | (INSIDE if is_inside else 0)
    )
    if mass > _DENSEST * volume:
        return facts
    facts |= LIGHT
    if is_turned:
        return facts | FITTING if max(moments[:3]) < _EVEN * min(moments[:3]) else facts
    ratios = (moment * volume / (mass * each) for moment, each in zip(moments[:3], diagonal, strict=True))
    fits = _are_alike(moments, diagonal) and all(1 / 2 < each < 2 for each in ratios)
    return facts | FITTING if fits else facts


def _are_alike(moments: Sequence[float], others: Sequence[float]) -> bool:
    """Are three moments ordered by size as the others are?"""
    a, b, c = moments[:3]
    x, y, z = others[:3]
    return (a - b) * (x - y) >= 0 and (b - c) * (y - z) >= 0 and (a - c) * (x - z) >= 0


def _placed(shape: Element) -> tuple[solids.Solid, list[float], bool] | None:
    """The solid of a visual or collision, its center, and whether it is turned; None without a solid."""
    at, is_turned, geometry = _ORIGIN, False, None
    for child in shape.children():
        tag = child.name
        if tag == "geometry":
            geometry = child
        elif tag in {"pose", "origin"}:
            at = _position(child)
            words = (
                (child.text_of("rpy") or "").split() if tag == "origin" else (child.text or "").split()[3:]
            )
            is_turned = any(map(float, words))
    solid = _solid_of(geometry)
    return None if solid is None else (solid, at, is_turned)


def _solid_of(geometry: Element | None) -> solids.Solid | None:
    if geometry is not None:
        for shape in geometry.children():
            if shape.name in _MAKERS:
                return _solid(shape.name, *_texts(shape).items())
            return None
    return None


@lru_cache(maxsize=1000)
def _solid(shape: str, *texts: tuple[str, str | None]) -> solids.Solid:
    """The solid of a shape; worlds repeat themselves."""
    return _MAKERS[shape]({name: text or "" for name, text in texts})


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
        inertia = self.inertia
        if not all(math.isfinite(moment.number) for moment in self.moments.values()):
            return False
        if self.is_urdf:
            return all(moment.is_given for moment in self.moments.values())
        if inertia is None:
            return not self.misspells("inertia")
        written = self.part(inertia)
        return not any(
            written.misspells(name) or (written.value(name) is not None and not moment.is_given)
            for name, moment in self.moments.items()
        )

    @property
    def missing_moments(self) -> tuple[str, ...]:
        """The names of the moments that an ``inertia`` of URDF does not write."""
        inertia = self.inertia
        if inertia is None or not self.is_urdf:
            return ()
        part = self.part(inertia)
        return tuple(name for name in _BY_ROWS if name not in inertia.attributes and part.lacks(name))

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
        return bool(self._soundness & SOUND)

    @property
    def fits_shapes(self) -> bool:
        """Are they also near to those of the link's primitive shapes, axis by axis? False proves nothing."""
        return bool(self._soundness & FITTING)

    @property
    def is_inside(self) -> bool:
        """Is the center of mass surely inside of a primitive shape? False proves nothing."""
        return bool(self._soundness & INSIDE)

    @property
    def is_light(self) -> bool:
        """Is the mass surely that of a material that fills its primitive shapes? False proves nothing."""
        return bool(self._soundness & LIGHT)

    @property
    def is_near(self) -> bool:
        """Are the moments surely at most twice those of a solid of its primitive shapes? False proves nothing."""
        return bool(self._soundness & NEAR)

    @lazy
    def _soundness(self) -> int:
        return soundness(self.link.element) if self.is_given else 0


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
        from sdfcheck.robot.motion.bounds import of_shapes

        return of_shapes(self.collisions) or of_shapes(self.visuals)

    @property
    def bounds(self) -> Array | None:
        """The box around its collisions, or its visuals where it has none: lowest and highest x, y, z.

        In m, in its frame, shape (2, 3), meshes included; None where no shape has a known size.
        """
        from sdfcheck.robot.motion.bounds import as_array

        return as_array(self.box)

    @lazy
    def visual_box(self) -> Box | None:
        """The box around its visuals (m); None unless the size of each of them is known."""
        return self._around(self.visuals)

    @lazy
    def collision_box(self) -> Box | None:
        """The box around its collisions (m); None unless the size of each of them is known."""
        return self._around(self.collisions)

    @lazy
    def extent(self) -> Box | None:
        """The box around its visuals and collisions (m); of either kind only if the size of each is known."""
        from sdfcheck.bodies.box import around

        return around((self.visual_box, self.collision_box))

    @lazy
    def fixed_extent(self) -> Box | None:
        """The same, with the links that fixed joints of URDF tie to it from below; None unless all are known."""
        from sdfcheck.robot.motion.bounds import with_fixed

        if self.document.is_open:
            return None
        return with_fixed(self)

    def distance_to(self, other: Link) -> float:
        """How far the shapes of another link are from its own (m), at least, all joints at zero; 0 if not known."""
        from sdfcheck.robot.motion.bounds import distance_between

        return distance_between(self, other)

    @property
    def at_rest(self) -> Origin | None:
        """Its pose in its robot of URDF with all joints at zero, in plain numbers; None where that is not known."""
        return self.model.poses_at_rest.get(self)

    def _around(self, shapes: tuple[Shape, ...]) -> Box | None:
        """The box around shapes that are all known; None where xacro may add more."""
        if self.document.kind is Kind.XACRO or self.is_unfinished:
            return None
        from sdfcheck.robot.motion.bounds import of_shapes

        return of_shapes(shapes) if all(shape.box is not None for shape in shapes) else None

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
        from sdfcheck.robot.naming.name import without_sides

        key = without_sides(self.name)
        if key == self.name:
            return ()
        links = self.model.links
        return tuple(link for link in links if link is not self and without_sides(link.name) == key)

    # How it hangs together with others

    @property
    def parent_joints(self) -> tuple[Joint, ...]:
        """The joints whose child it is; more than one is a mistake, or closes a loop."""
        return tuple(self.model.tree.parents.get(self, ()))

    @property
    def child_joints(self) -> tuple[Joint, ...]:
        """The joints whose parent it is."""
        return tuple(self.model.tree.children.get(self, ()))

    def below(self) -> Iterator[Link]:
        """The link and all links that hang on it, each once."""
        return self.model.tree.below(self)

    @property
    def mass_properties(self) -> MassProperties | None:
        """Mass (kg), center of mass (m) and inertia (kg·m²) in its frame; None where the format gives none.

        An inertia that the simulator computes (``auto="true"``) is computed. Raises
        DescriptionError for numbers that cannot be read and shapes that cannot be measured.
        """
        from sdfcheck.robot.motion.mass import of_link

        return of_link(self)

"""Mass and inertia of links."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, cast

from sdfcheck.robot.part import Part
from sdfcheck.robot.parts import solids
from sdfcheck.robot.parts.solids import Moments, Solid
from sdfcheck.robot.sound_inertia import FITTING, INSIDE, LIGHT, NEAR, SOUND, soundness
from sdfcheck.robot.values import Number, is_true, lazy, number

if TYPE_CHECKING:
    from sdfcheck.robot.parts.link import Link
    from sdfcheck.source.element import Element, Value

MOMENTS = ("ixx", "iyy", "izz", "ixy", "ixz", "iyz")
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

    @property
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

    @property
    def _mass_value(self) -> Value | None:
        mass = self.find("mass")
        return mass.attribute("value") if mass is not None else None

    @property
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
        return position(self)

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


def position(part: Part) -> tuple[float, float, float] | None:
    """The position that a part's ``pose`` or ``origin`` writes; None if that alone does not say it."""
    if part.is_urdf:
        origin = part.find("origin")
        return _three(origin.text_of("xyz", "0 0 0") if origin is not None else "0 0 0")
    pose = part.find("pose")
    if pose is None or not pose.content:
        return 0.0, 0.0, 0.0
    if pose.text_of("relative_to", "").strip():
        return None
    return _three(pose.content)


def _three(text: str) -> tuple[float, float, float] | None:
    try:
        x, y, z = (float(word) for word in text.split()[:3])
    except ValueError:
        return None
    return x, y, z

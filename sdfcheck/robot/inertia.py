"""Masses and moments that no body can have, or that hardly fit the body that is drawn.

The hard conditions are those of libsdformat 17 (gz-math's MassMatrix3): positive
definite, and no principal moment above the sum of the other two. The soft ones compare
with homogeneous solids of the link's own primitive shapes; only traces are compared,
which no rotation changes.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator

from sdfcheck.formats.sdf.survey import survey
from sdfcheck.robot.inertials import COMPONENTS, Inertial, Shape, read_inertial, shapes
from sdfcheck.robot.scopes import scopes
from sdfcheck.robot.solids import Moments
from sdfcheck.robot.sound_inertia import is_sound
from sdfcheck.source.document import Document
from sdfcheck.source.element import Element, Value
from sdfcheck.source.record import Record

FACTOR = 100.0
"""More than this off a solid of the same mass and shape is no modelling choice any more."""

_UNIT = Moments(1.0, 1.0, 1.0)
_NO_SOLID = frozenset({"plane", "heightmap", "polyline", "image", "empty"})


class NonPositiveMass(Record):
    """A mass below zero, or (``is_zero``) none at all."""

    value: Value
    link: Element
    is_zero: bool


class IndefiniteInertia(Record):
    """A tensor that is not positive definite; ``value`` is the component that makes it so, if it is one."""

    inertia: Element
    value: Value | None
    link: Element
    smallest: float


class ImpossibleInertia(Record):
    """Principal moments that break the triangle inequality; ``value`` is the largest diagonal component."""

    value: Value
    link: Element
    principal: tuple[float, float, float]


class MissingInertial(Record):
    """A moving link without ``inertial``."""

    link: Element


class PlaceholderInertia(Record):
    """The unit inertia, written or taken by default, on a body for which it is absurd.

    ``expected`` is the trace of a solid of the link's shapes.
    """

    place: Element
    link: Element
    mass: float
    ratio: float
    written: bool


class ImplausibleInertia(Record):
    """Moments ``ratio`` times those of a solid of this mass in the link's shapes."""

    inertia: Element
    link: Element
    ratio: float
    shape: Element


class InertiaAboutWrongPoint(Record):
    """Moments that fit the link's shapes once they are shifted from the link's origin to the centre of mass."""

    inertia: Element
    link: Element
    offset: float
    ratio: float


class UnusableAutomaticInertia(Record):
    """``auto="true"`` where nothing can be computed: no collision, or one (``collision``) without volume."""

    place: Element
    link: Element
    collision: Element | None
    reason: str


def problems(document: Document) -> list[Record]:
    """What is wrong with the masses and inertias of an SDF or URDF document; static models are passed over."""
    found: list[Record] = []
    is_urdf = document.root is not None and document.root.name == "robot"
    for link in _moving_links(document):
        if is_sound(link):
            continue
        inertial = read_inertial(link)
        if inertial is None:
            # In URDF what a link without inertial means depends on its joint: said with the tree.
            misspelt = (link, "inertial") in survey(document).misspelled
            if not is_urdf and not misspelt and (link.has("collision") or link.has("visual")):
                found.append(MissingInertial(link))
        elif inertial.is_automatic:
            found += _look_at_automatic(inertial)
        else:
            found += _look_at(inertial, is_urdf)
    return found


def problems_of_links(links: Iterable[Element]) -> Iterator[Record]:
    """What no body can have, in links of URDF of which not everything is known."""
    for link in links:
        inertial = read_inertial(link)
        if inertial is not None and inertial.mass is not None and inertial.mass.number < 0:
            yield NonPositiveMass(inertial.mass, link, is_zero=False)
        elif inertial is not None and len(inertial.moments) == len(COMPONENTS):
            hard = _hard(inertial, inertial.tensor())
            if hard is not None:
                yield hard


def _moving_links(document: Document) -> Iterable[Element]:
    root = document.root
    if root is None:
        return []
    if root.name == "robot":
        return root.children("link")
    moving = {
        scope.element
        for scope in scopes(document).all()
        if scope.kind == "model" and not scope.is_static and not _may_be_static(scope.element)
    }
    return [link for link in survey(document).index.get("link", []) if link.parent in moving]


def _may_be_static(model: Element) -> bool:
    """Does a model say something about it that is neither true nor false? That is told of."""
    static = model.find("static")
    return static is not None and static.content.lower() not in {"true", "1", "false", "0", ""}


def _look_at(inertial: Inertial, is_urdf: bool) -> Iterator[Record]:
    mass = inertial.mass.number if inertial.mass is not None else 1.0
    # Text that is no number is the schema's business; "nan" is read, and refused as a mass.
    if inertial.mass is not None and math.isnan(mass) and inertial.mass.text.strip().lower() != "nan":
        return
    if inertial.mass is not None and (mass <= 0 or math.isnan(mass)):
        if mass != 0 or not is_urdf:
            yield NonPositiveMass(inertial.mass, inertial.link, mass == 0)
        return
    if len(inertial.moments) < len(COMPONENTS) and (is_urdf or _is_garbled(inertial)):
        return  # the schema's business
    tensor = inertial.tensor()
    if not all(math.isfinite(value) for value in tensor):
        return
    hard = _hard(inertial, tensor)
    if hard is not None:
        yield hard
        return
    if math.isfinite(mass):
        yield from _soft(inertial, tensor, mass)


def _is_garbled(inertial: Inertial) -> bool:
    """Is a component there that is no number, or misspelt? What is taken instead was not meant."""
    inertia = inertial.inertia
    if inertia is None:
        return (inertial.element, "inertia") in survey(inertial.link.document).misspelled
    misspelled = survey(inertial.link.document).misspelled
    return any(
        (inertia.has(name) and name not in inertial.moments) or (inertia, name) in misspelled
        for name in COMPONENTS
    )


def _hard(inertial: Inertial, tensor: Moments) -> Record | None:
    low, middle, high = tensor.principal()
    tolerance = 10 * 2.3e-16 * max(abs(value) for value in tensor)
    inertia = inertial.inertia
    if inertia is None:
        return None
    if low < -tolerance:
        return IndefiniteInertia(inertia, _culprit(inertial, tensor), inertial.link, low)
    if low + middle + tolerance < high:
        largest = max(COMPONENTS[:3], key=lambda name: getattr(tensor, name))
        value = inertial.moments.get(largest)
        return ImpossibleInertia(value or inertia.own_value, inertial.link, (low, middle, high))
    return None


def _culprit(inertial: Inertial, tensor: Moments) -> Value | None:
    """The one component that makes a tensor indefinite: a negative moment, or too large a product."""
    diagonal = (inertial.moments[name] for name in COMPONENTS[:3] if name in inertial.moments)
    negative = next((value for value in diagonal if value.number < 0), None)
    if negative is not None:
        return negative
    too_large = [
        inertial.moments[name]
        for name in COMPONENTS[3:]
        if name in inertial.moments
        and abs(getattr(tensor, name))
        > math.sqrt(getattr(tensor, "i" + name[1] * 2)) * math.sqrt(getattr(tensor, "i" + name[2] * 2))
    ]
    return too_large[0] if len(too_large) == 1 else None


def _soft(inertial: Inertial, tensor: Moments, mass: float) -> Iterator[Record]:
    solids = list(shapes(inertial.link))
    if not solids or inertial.centre is None:
        return
    expected = _solid_trace(solids, mass, inertial.centre)
    if not (0 < expected < math.inf and 0 < tensor.trace < math.inf):
        return
    ratio = tensor.trace / expected
    offset = math.hypot(*inertial.centre)
    shifted = (tensor.trace - 2 * mass * offset * offset) / expected
    if offset > 0 and ratio > 10 and 1 / 3 < shifted < 3 and inertial.inertia is not None:
        yield InertiaAboutWrongPoint(inertial.inertia, inertial.link, offset, ratio)
    elif 1 / FACTOR <= ratio <= FACTOR:
        return
    elif tensor == _UNIT:
        place = inertial.inertia if inertial.inertia is not None else inertial.element
        yield PlaceholderInertia(place, inertial.link, mass, ratio, inertial.inertia is not None)
    elif inertial.inertia is not None:
        yield ImplausibleInertia(inertial.inertia, inertial.link, ratio, solids[0].element)


def _solid_trace(solids: list[Shape], mass: float, centre: tuple[float, float, float]) -> float:
    """The trace about ``centre`` of a body of this mass that fills the shapes evenly."""
    volume = sum(shape.solid.volume for shape in solids)
    trace = 0.0
    for shape in solids:
        part = mass * shape.solid.volume / volume
        distance = math.dist(shape.at, centre)
        trace += part * (shape.solid.moments.trace + 2 * distance * distance)
    return trace


def _look_at_automatic(inertial: Inertial) -> Iterator[Record]:
    collisions = list(inertial.link.children("collision"))
    if not collisions:
        yield UnusableAutomaticInertia(inertial.element, inertial.link, None, "the link has no collision")
        return
    for collision in collisions:
        density = collision.number("density") or inertial.element.number("density")
        if density is not None and density.number <= 0:
            reason = f"density {density.text} is not positive"
            yield UnusableAutomaticInertia(density.element, inertial.link, collision, reason)
            continue
        geometry = collision.find("geometry")
        names = [c.name for c in geometry.children()] if geometry is not None else []
        if not names or names[0] in _NO_SOLID:
            shape = "an empty geometry" if "empty" in names[:1] else f"a {names[0]}" if names else ""
            what = shape or "a collision without shape"
            yield UnusableAutomaticInertia(collision, inertial.link, collision, f"{what} has no volume")

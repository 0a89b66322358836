"""The robot that libsdformat builds of a URDF description.

It drops a link without mass with all that hangs on it, merges the links that fixed joints tie
together, gives shapes new names, and moves what ``<gazebo>`` blocks hold to the link or joint that is
left. Each part of the result knows the part of the description that it comes from. Source: libsdformat
17's parser_urdf.cc, and what libsdformat 12.3 builds.
"""

from __future__ import annotations

import math
import re
from collections.abc import Iterable, Iterator, Mapping
from functools import cache
from itertools import takewhile
from operator import itemgetter
from typing import TYPE_CHECKING

from sdfcheck.formats.urdf.schema import settings
from sdfcheck.robot.motion.origin import Origin, Triple, origin_in, urdf_number
from sdfcheck.robot.solids import Moments
from sdfcheck.robot.values import MOMENTS, lazy
from sdfcheck.source.document import Value
from sdfcheck.source.errors import DescriptionError
from sdfcheck.source.record import NamedTuple
from sdfcheck.source.text import is_expression

if TYPE_CHECKING:
    from sdfcheck.robot.graph import GazeboBlock, Joint, Link, Model, Plugin, Sensor, Shape
    from sdfcheck.source.document import Document, Element
    from sdfcheck.source.text import Span

WORLD = "world"
LEAST = 1e-6
"""kg: a mass that is not above it counts as none in releases before 9.10.1, 12.7.2, 13.5 and 14.1."""
_LUMP = "_fixed_joint_lump__"
_REWRITTEN = ("bodyName", "frameName")
"""Parameters of plugins in which the name of a merged link becomes that of the link that is left."""
_SHAPES = frozenset(("box", "cylinder", "mesh", "sphere"))


class BuiltShape(NamedTuple):
    """A visual or collision of the result."""

    name: str
    origin: Shape
    settings: tuple[Element, ...]
    """The settings of blocks that reach it, in their order: of a repeated one the last counts."""


class BuiltLink(NamedTuple):
    """A link of the result; ``members`` are the links that it is made of, itself first."""

    name: str
    origin: Link
    members: tuple[Link, ...]
    visuals: tuple[BuiltShape, ...]
    collisions: tuple[BuiltShape, ...]
    blocks: tuple[GazeboBlock, ...]
    """The ``<gazebo>`` blocks whose content it has."""

    @property
    def sensors(self) -> tuple[Sensor, ...]:
        """The sensors that it has."""
        return tuple(sensor for block in self.blocks for sensor in block.sensors)


class BuiltJoint(NamedTuple):
    """A joint of the result, with the type that SDFormat has for it; ``parent`` may be ``world``."""

    name: str
    type: str
    parent: str
    child: str
    origin: Joint
    blocks: tuple[GazeboBlock, ...]

    @property
    def sensors(self) -> tuple[Sensor, ...]:
        """The sensors that it has."""
        return tuple(sensor for block in self.blocks for sensor in block.sensors)


class BuiltFrame(NamedTuple):
    """A frame of the result: the place of a link or joint that is merged away."""

    name: str
    attached_to: str
    origin: Link | Joint


class GazeboRobot:
    """A URDF robot as Gazebo has it."""

    def __init__(self, model: Model) -> None:
        self.model = model
        self.tops: list[Link] = []
        """The links with which libsdformat begins: the root, or what hangs on a root called ``world``."""
        for root in model.tree.main_roots:
            if root.name != WORLD:
                self.tops.append(root)
                continue
            below = (joint.child_link for joint in root.child_joints)
            self.tops += [link for link in below if link is not None]

    # Links that are merged, and links that are dropped

    @lazy
    def masses(self) -> dict[Link, float]:
        """The masses (kg) of links and of the links that are merged into them; infinite where one is not known."""
        masses = {link: _mass(link) for link in self.model.tree.links.values()}
        below = self.model.tree.below(*dict.fromkeys(self.tops))
        for link in reversed(list(below)):
            for joint in link.parent_joints:
                parent = joint.parent_link
                if joint.is_lumped and parent is not None:
                    masses[parent] += masses[link]
        return masses

    @lazy
    def with_mass(self) -> set[Link]:
        """The links that have mass, their own or that of links that are merged into them."""
        return {link for link, mass in self.masses.items() if mass > 0}

    @lazy
    def barely_with_mass(self) -> set[Link]:
        """Those of them whose mass counts as none in older releases (:data:`LEAST`)."""
        return {link for link in self.with_mass if self.masses[link] <= LEAST}

    @lazy
    def without_center(self) -> dict[Link, Link]:
        """Link → the one above it, where neither has mass when libsdformat merges them.

        Their center of mass is 0/0 then, and so is that of all that is merged into the same link
        later. Children are merged in the order of their joints' names, each with what is on it.
        """
        found: dict[Link, Link] = {}
        known: dict[Link, float] = {}
        for link in reversed(list(self.model.tree.below(*dict.fromkeys(self.tops)))):
            mass = _mass(link)
            for joint in sorted(link.child_joints, key=lambda joint: joint.name):
                child = joint.child_link
                if joint.is_lumped and child in known:
                    if mass + known[child] == 0:
                        found[child] = link
                    mass += known[child]
            if link.inertial.is_given or mass:
                known[link] = mass
        return {child: link for child, link in found.items() if self.base(link) in self.with_mass}

    @lazy
    def _bases(self) -> dict[Link, Link]:
        """Link → the link into which it is merged, or itself; of what hangs on roots, parents first."""
        bases: dict[Link, Link] = {}
        for link in self.model.tree.below(*dict.fromkeys((*self.tops, *self.model.tree.roots))):
            joint = link.parent_joints[0] if link.parent_joints else None
            parent = joint.parent_link if joint is not None and joint.is_lumped else None
            bases[link] = link if parent is None else bases.get(parent, parent)
        return bases

    def base(self, link: Link) -> Link:
        """The link into which a link is merged; the link itself where it is merged into none."""
        return self._bases.get(link, link)

    @lazy
    def _dropped(self) -> set[Link]:
        dropped: set[Link] = set()
        for link in (*self._bases, *self.model.tree.links.values()):
            base = self.base(link)
            above = base.parent_joints[0].parent_link if base.parent_joints else None
            hangs = above is not None and above.name != WORLD and above in dropped
            if above is not None and self.is_left_out(above):
                hangs = False
            if hangs or base not in self.with_mass:
                dropped.add(link)
        return dropped

    def is_left_out(self, link: Link) -> bool:
        """Is it without mass, and fixed to the world? libsdformat leaves out such a link, but not what hangs on it."""
        joint = link.parent_joints[0] if link.parent_joints else None
        is_tied = (
            joint is not None and joint.parent_name == WORLD and joint.is_fixed and not joint.is_preserved
        )
        return is_tied and link not in self.with_mass

    @lazy
    def orphaned(self) -> dict[Link, BuiltJoint]:
        """Link that is left out → the first joint that has no parent without it, for which the file is refused."""
        first: dict[str, BuiltJoint] = {}
        for joint in self.joints.values():
            first.setdefault(joint.parent, joint)
        return {top: first[top.name] for top in self.tops if self.is_left_out(top) and top.name in first}

    @lazy
    def followed(self) -> Mapping[Link, Joint]:
        """Link that is dropped with its joint → a joint of the result that mimics that joint."""
        found: dict[Link, Joint] = {}
        for joint in self.joints.values():
            mimic = joint.origin.axis.mimic
            link = mimic.leader.child_link if mimic is not None and mimic.leader is not None else None
            if link is not None and self.is_dropped(link):
                found.setdefault(link, joint.origin)
        return found

    def refused_without(self, link: Link) -> str:
        """Why libsdformat refuses the robot of which a link without mass is dropped; empty if it does not."""
        if link in self.orphaned:
            return "a joint loses its parent"
        if link not in self._reached:
            return ""  # the world, or another root
        if not self.links:
            return "nothing is left"
        if link in self._leading:
            return "the leader of a mimic is not there"
        return (
            "a frame loses its link, which version 17 is the first to make" if link in self._carrying else ""
        )

    @lazy
    def _leading(self) -> set[Link]:
        """The links that are :attr:`followed`, and all above them."""
        return _with_above(self.followed)

    @lazy
    def _carrying(self) -> set[Link]:
        """The links with which others are merged, and all above them."""
        parents = (joint.parent_link for joint in self.model.tree.joints if joint.is_lumped)
        return _with_above(link for link in parents if link is not None)

    def mass_fault(self, base: Link) -> Span | None:
        """The place of the mistake for which a link, with all that is merged into it, has no mass."""
        return next(filter(None, map(_mass_fault, self.members(base))), None)

    def is_dropped(self, link: Link) -> bool:
        """Is it left out: without mass once links are merged, or on such a link?"""
        return link in self._dropped or self.base(link) not in self.with_mass

    def members(self, base: Link) -> Iterator[Link]:
        """A link and all links that are merged into it: those on a link in the order of its joints' names."""
        seen, waiting = {base}, [base]
        while waiting:
            link = waiting.pop()
            yield link
            for joint in sorted(link.child_joints, key=lambda joint: joint.name, reverse=True):
                child = joint.child_link
                if child is not None and child not in seen and self._bases.get(child) is base:
                    seen.add(child)
                    waiting.append(child)

    def moments(self, base: Link) -> Moments:
        """The moments (kg·m²) of a link and of all that is merged into it, about their center of mass.

        In the axes of the link. They are nan where a number or the mass is missing.
        """
        try:
            return _sum(self.members(base))
        except (DescriptionError, ArithmeticError):
            return Moments(math.nan, math.nan, math.nan)

    # The result

    @lazy
    def links(self) -> dict[str, BuiltLink]:
        """Name → link."""
        return {
            link.name: self._link(link)
            for link in self._bases
            if self.base(link) is link and link in self._reached and not self.is_dropped(link)
        }

    @lazy
    def joints(self) -> dict[str, BuiltJoint]:
        """Name → joint; fixed ones are there that are preserved, or tie the robot to the world."""
        found: dict[str, BuiltJoint] = {}
        merged = {frame.name for frame in self.frames if frame.origin.kind == "link"}
        for joint in self.model.tree.joints:
            child, parent = joint.child_link, joint.parent_link
            if child is None or parent is None or joint.is_lumped or joint.is_unconverted:
                continue
            if child in self._reached and not self.is_dropped(child):
                parent_name = WORLD if parent.name == WORLD else self.base(parent).name
                blocks = tuple(self._blocks(joint.name)) if joint.name not in merged else ()
                made = BuiltJoint(joint.name, _type(joint), parent_name, child.name, joint, blocks)
                found[joint.name] = made
        return found

    @lazy
    def frames(self) -> tuple[BuiltFrame, ...]:
        """The frames that keep the names of the joints and links that are merged away."""
        found: list[BuiltFrame] = []
        for link in self._bases:
            if self.base(link) is not link and link in self._reached:
                joint = link.parent_joints[0]
                found += (
                    BuiltFrame(joint.name, joint.parent_name, joint),
                    BuiltFrame(link.name, joint.name, link),
                )
        return tuple(found)

    @lazy
    def lost(self) -> dict[GazeboBlock, Joint]:
        """Block → the fixed joint that it is about, which is merged away with all that the block holds."""
        merged = {
            link.parent_joints[0].name: link.parent_joints[0]
            for link in self._bases
            if self.base(link) is not link
        }
        return {
            block: merged[name]
            for name, blocks in self.model.blocks_by_reference.items()
            if name in merged and name not in self.model.tree.links
            for block in blocks
        }

    def rewritten(self, plugin: Plugin) -> dict[Element, str]:
        """The parameters of a plugin of a block in which it writes another link's name, and that name."""
        found: dict[Element, str] = {}
        for name in _REWRITTEN:
            parameter = plugin.find(name)
            if parameter is None or plugin.holder is None or plugin.holder.kind != "gazebo":
                continue
            link = self.model.tree.links.get((parameter.get("value") or parameter.content).strip())
            if link is not None and self.base(link) is not link:
                found[parameter] = self.base(link).name
        return found

    @lazy
    def _reached(self) -> set[Link]:
        """The links that libsdformat looks at: what hangs on the first of the roots."""
        return set(self.model.tree.below(*dict.fromkeys(self.tops)))

    def _blocks(self, *names: str) -> Iterator[GazeboBlock]:
        for name in names:
            yield from self.model.blocks_by_reference.get(name, ())

    def _link(self, base: Link) -> BuiltLink:
        members = tuple(self.members(base))
        blocks = tuple(self._blocks(*(link.name for link in members)))
        visuals = tuple(self._shapes(members, "visual", blocks))
        collisions = tuple(self._shapes(members, "collision", blocks))
        return BuiltLink(base.name, base, members, visuals, collisions, blocks)

    def _shapes(
        self, members: tuple[Link, ...], kind: str, blocks: tuple[GazeboBlock, ...]
    ) -> Iterator[BuiltShape]:
        base = members[0].name
        handed_on = _handed_on(kind)
        passed: dict[str, list[tuple[int, Element]]] = {}
        """Reference of blocks → their settings for shapes, with their place among all of them."""
        settings_of = ((block.reference, child) for block in blocks for child in block.children())
        for place, (reference, child) in enumerate(settings_of):
            if child.name in handed_on:
                passed.setdefault(reference, []).append((place, child))
        lengths = {len(reference) for reference in passed}
        shapes = (
            (shape, shape.element.attributes.get("name", "") or link.name)
            for link in members
            for shape in _read(link)[kind == "collision"]
        )
        for number, (shape, called) in enumerate(shapes):
            name = f"{called}_{kind}" + (f"_{number}" if number else "")
            if not name.startswith(base):
                name = f"{base}{_LUMP}{name}"
            references = {base} if _LUMP not in name else set(_referred(name, kind, lengths)) - {base}
            reaching = sorted(
                (each for reference in references for each in passed.get(reference, ())), key=itemgetter(0)
            )
            yield BuiltShape(name, shape, tuple(child for _, child in reaching))


def _referred(name: str, kind: str, lengths: Iterable[int]) -> Iterator[str]:
    """The names of links between mark and kind in the name of a merged link's shape, if of one of the lengths."""
    for mark in re.finditer(_LUMP, name):
        for length in lengths:
            if name.startswith(f"_{kind}", mark.end() + length):
                yield name[mark.end() : mark.end() + length]


@cache
def _handed_on(kind: str) -> frozenset[str]:
    """The settings of a block about a link that are handed on to its shapes of a kind."""
    if kind == "visual":
        return frozenset(("material", "visual"))
    places = ((name, path[0]) for name, one in settings("link").items() for path in one.counterparts)
    return frozenset(("collision", *(name for name, place in places if place == "collision")))


def _mass(link: Link) -> float:
    """The mass of a link, infinite where it is not known; none where urdfdom fails before it reads one."""
    if not link.has_mass or _is_cut(link.inertial.element):
        return 0.0
    mass = link.inertial.mass.number
    return math.inf if math.isnan(mass) else mass


def _is_cut(inertial: Element) -> bool:
    """Does urdfdom fail on a number before it has the mass?"""
    return next(_cuts(inertial), None) is not None


def _cuts(inertial: Element) -> Iterator[Element]:
    """The parts with a number on which urdfdom fails before it has the mass."""
    return (part for name in ("origin", "mass") for part in inertial.children(name) if _fails(part))


def _mass_fault(link: Link) -> Span | None:
    """The place of the mistake for which a link has no mass, or none that is read."""
    inertial = link.inertial
    if not inertial.is_given:
        return link.misnamed("inertial")
    mass = inertial.find("mass")
    if mass is None:
        return inertial.misnamed("mass") or inertial.span
    if (cut := next(_cuts(inertial.element), None)) is not None:
        return cut.document.spans.whole(cut)
    if "value" not in mass.attributes:
        return inertial.part(mass).misnamed("value") or mass.span
    return inertial.mass.span if inertial.mass.number < 0 else None


def _read(link: Link) -> tuple[tuple[Shape, ...], tuple[Shape, ...]]:
    """The visuals and collisions that urdfdom reads: it leaves a link at the first thing that it cannot read."""
    inertial = link.inertial
    if inertial.is_given and (
        inertial.inertia is None
        or inertial.missing_moments
        or not inertial.has("mass")
        or _fails(inertial.element)
    ):
        return (), ()
    visuals = tuple(takewhile(_is_read, link.visuals))
    is_cut = len(visuals) < len(link.visuals)
    return visuals, () if is_cut else tuple(takewhile(_is_read, link.collisions))


def _is_read(shape: Shape) -> bool:
    material = shape.element.find("material") if shape.kind == "visual" else None
    is_named = material is None or "name" in material.attributes
    return shape.geometry.shape in _SHAPES and is_named and not _fails(shape.element)


def _fails(part: Element) -> bool:
    """Does urdfdom fail on a number in a part of a link? In materials it matters to these alone."""
    failing = part.document.view(_failing)
    return bool(failing) and any(each in failing for each in part.walk())


def _failing(document: Document) -> frozenset[Element]:
    """The elements with numbers that urdfdom cannot read; what xacro has yet to expand is not known."""
    from sdfcheck.formats.problems import MalformedValue, MissingAttribute, WrongComponentCount
    from sdfcheck.formats.urdf.survey import survey

    surveyed, causes = survey(document), (MalformedValue, MissingAttribute, WrongComponentCount)
    if not any(isinstance(each, causes) for each in surveyed.problems):
        return frozenset()
    parts = (part for name in ("inertial", "visual", "collision") for part in surveyed.index.get(name, ()))
    return frozenset(element for part in parts for element in part.walk() if _is_failing(element))


def _is_failing(element: Element) -> bool:
    from sdfcheck.formats.urdf.findings import as_written, read
    from sdfcheck.formats.urdf.schema import definition

    place = None if element.name == "color" else definition(element)
    known = place.attributes if place is not None else {}
    return any(
        name in known
        and not is_expression(text)
        and not read(known[name], as_written(Value(element, name, text))).is_fine
        for name, text in element.attributes.items()
    )


def _type(joint: Joint) -> str:
    if joint.is_fixed:
        is_fixed = joint.parent_name == WORLD or any(
            block.is_on("preserveFixedJoint") for block in joint.gazebo_blocks
        )
        is_turned = any(block.is_on("disableFixedJointLumping") for block in joint.gazebo_blocks)
        return "revolute" if is_turned and not is_fixed else "fixed"
    return "revolute" if joint.type == "continuous" else joint.type


def _with_above(links: Iterable[Link]) -> set[Link]:
    """Some links, and those that carry them, each visited once."""
    found: set[Link] = set()
    waiting = list(links)
    while waiting:
        link = waiting.pop()
        if link not in found:
            found.add(link)
            waiting += (joint.parent_link for joint in link.parent_joints if joint.parent_link is not None)
    return found


def _sum(links: Iterable[Link]) -> Moments:
    """The moments of links, each of which comes after the one that it is fixed to."""
    places: dict[Link, Origin] = {}
    bodies: list[tuple[float, Triple, Moments]] = []
    for link in links:
        joint = link.parent_joints[0] if places else None
        if joint is None or joint.parent_link is None:
            places[link] = Origin()
        else:
            places[link] = places[joint.parent_link].followed_by(origin_in(joint.element))
        inertial = link.inertial
        if inertial.is_given and not _is_cut(inertial.element):
            mass, inertia = inertial.find("mass"), inertial.inertia
            place = places[link].followed_by(origin_in(inertial.element))
            moments = Moments(0.0, 0.0, 0.0)
            if inertia is not None and not _fails(inertia):
                moments = Moments(**{name: urdf_number(inertia, name, 0.0) for name in MOMENTS})
            weight = 0.0 if mass is None else urdf_number(mass, "value", 0.0)
            bodies.append((weight, place.position, place.turned_moments(moments)))
    whole = sum(mass for mass, _, _ in bodies)
    x, y, z = (sum(mass * at[i] for mass, at, _ in bodies) / whole for i in range(3))
    total = Moments(0.0, 0.0, 0.0)
    for weight, at, moments in bodies:
        total = total.plus(moments.moved(weight, at[0] - x, at[1] - y, at[2] - z))
    return total

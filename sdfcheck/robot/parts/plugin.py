"""Plugins, the names that their parameters write, and the differential drives that they describe."""

from __future__ import annotations

import math
import re
from collections.abc import Iterable, Iterator
from typing import TYPE_CHECKING, cast

from sdfcheck.robot.graph import Model, Part
from sdfcheck.robot.values import lazy
from sdfcheck.source.document import Value
from sdfcheck.source.record import NamedTuple

if TYPE_CHECKING:
    from sdfcheck.formats.plugins import Naming, PluginFacts
    from sdfcheck.robot.graph import Node
    from sdfcheck.robot.parts.joint import Joint
    from sdfcheck.source.document import Element


# Names of joints and links that the parameters of plugins write.
#
# Systems look among the joints and links directly in their model, and know no ``::`` but for some.


_TEMPLATE = re.compile(r"[${}%@]")
_USUAL = {
    "bodyName": "link",
    "linkName": "link",
    "link_name": "link",
    "jointName": "joint",
    "joint_name": "joint",
}
"""Parameter of a plugin that is not known → the kind of thing that it names."""
_ALWAYS = frozenset({"", "world", "canonical", "__default__"})


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
        """Does it reach no joint or link of its kind, or a joint that libsdformat merges away?"""
        return self.node is None or self.node.kind != self.kind or _is_lumped(self.node)


def references(plugin: Plugin, namings: Iterable[Naming]) -> Iterator[PluginReference]:
    """The names of joints and links that are written; what may be in a file that could not be read is left out."""
    model = _model(plugin)
    if model is None or not model.is_complete or not any(n.kind == "link" for n in model.nodes.values()):
        return
    for naming in namings:
        for value in _written(plugin.element, naming):
            name = value.text.strip()
            if name in _ALWAYS or _TEMPLATE.search(name) or (naming.is_list and "," in name):
                continue
            name = name.removeprefix(f"{model.name}::")
            if "::" in name and (not naming.is_scoped or model.may_hold(name)):
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
        if value is not None:
            yield value


def _is_lumped(node: Node) -> bool:
    """Does libsdformat merge a joint away? Names of links it rewrites in some parameters."""
    from sdfcheck.robot.parts.joint import Joint

    return isinstance(node, Joint) and node.is_lumped


# Plugins.


class Plugin(Part):
    """A plugin, of a world, model, sensor, visual or ``<gazebo>`` block; its parameters are its own."""

    __slots__ = ()
    kind = "plugin"

    @property
    def filename(self) -> str:
        """The library as written, without spaces around it."""
        return (self._text("filename") or "").strip()

    @property
    def filename_value(self) -> Value | None:
        """The library with its place."""
        return self.attribute("filename")

    @property
    def parameters(self) -> Iterator[Element]:
        """Its parameters."""
        return self.children()

    @lazy
    def known(self) -> PluginFacts | None:
        """The facts about its library, in the generation that shares most parameters with it."""
        if not self.filename:
            return None
        from sdfcheck.formats.plugins import known

        found = known(self.filename)
        given = {parameter.name for parameter in self.parameters} if len(found) > 1 else set()
        return max(found, key=lambda facts: len(given & facts.parameters), default=None)

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
            if not any(child.name in _USUAL for child in self.parameters):
                return ()
            from sdfcheck.formats.plugins import Naming

            namings = tuple(Naming(name, kind, True, False) for name, kind in _USUAL.items())
        return tuple(references(self, namings)) if namings else ()

    @property
    def unresolved(self) -> tuple[PluginReference, ...]:
        """The parameters that name a joint or link which its model does not have."""
        return tuple(reference for reference in self.references if reference.is_unresolved)

    @property
    def siblings(self) -> tuple[Plugin, ...]:
        """The plugins beside it, itself included; those of all blocks about the robot in URDF."""
        if self.holder is None:
            return (self,)
        beside = (child for child in self.root.elements.get("plugin", ()) if self._is_beside(child))
        return tuple(part for child in beside if isinstance(part := self.root.part_of(child), Plugin))

    def _is_beside(self, other: Element) -> bool:
        parent, own = other.parent, self.element.parent
        if parent is own or parent is None or own is None:
            return parent is own
        is_block = parent.name == own.name == "gazebo"
        return is_block and parent.attributes.get("reference", "") == own.attributes.get("reference", "")

    @lazy
    def drive(self) -> Drive | None:
        """The drive that it makes, where it names the wheels on each side, and they are known."""
        name = self.filename.lower()
        if "drive" not in name and "steering" not in name:
            return None

        return drive_of(self)

    @lazy
    def meant_file(self) -> str | None:
        """The file of a system of Gazebo, or of a part of its window, that was probably meant by one that is not."""
        name = self.filename
        if self.known is not None or "$" in name:
            return None
        from sdfcheck.formats.plugins import gui_files, known_files, stem

        if "gz-sim" in name or "ignition-gazebo" in name:
            return self.nearest(stem(name), known_files())
        parent = self.element.parent
        if name and parent is not None and parent.name == "gui":
            return self.nearest(stem(name), gui_files())
        return None

    @lazy
    def misspelled_parameters(self) -> tuple[tuple[Element, str], ...]:
        """The parameters that it does not read, with those that they were probably meant to be."""
        facts = self.known
        if facts is None or not facts.parameters:
            return ()
        given = [parameter for parameter in self.parameters if ":" not in parameter.name]
        names = {parameter.name for parameter in given}
        unread = [parameter for parameter in given if not facts.reads(parameter.name)]
        free = [name for name in facts.parameters if name not in names]
        from sdfcheck.formats.near_names import without_a_word

        found = (
            (
                each,
                facts.in_other_case(each.name)
                or self.nearest(each.name, free)
                or without_a_word(each.name, free),
            )
            for each in unread
        )
        return tuple((each, meant) for each, meant in found if meant is not None)

    @lazy
    def missing_parameters(self) -> tuple[str, ...]:
        """The parameters without which it does not run, and that are not there, not even misspelled."""
        facts = self.known
        if facts is None or not facts.required or self.is_template or self._is_of_several_generations:
            return ()
        meant = {name for _, name in self.misspelled_parameters}
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
        from sdfcheck.formats.plugins import known

        given = {parameter.name for parameter in self.parameters}
        shared = sorted(len(given & facts.parameters) for facts in known(self.filename))
        return len(shared) > 1 and shared[-1] == shared[-2]

    @property
    def is_template(self) -> bool:
        """Will something else write more of it, such as xacro?"""
        return any("xacro:" in child.name or "$" in child.content for child in self.parameters)


# Differential drives: what the parameters of a plugin say, and where the wheels are.


_LEFT = ("left_joint", "leftJoint", "front_left_joint", "back_left_joint")
_RIGHT = ("right_joint", "rightJoint", "front_right_joint", "back_right_joint")
_SEPARATION = ("wheel_separation", "wheelSeparation")
_RADIUS = ("wheel_radius", "wheelRadius")
_BASE = ("wheel_base", "wheelbase")
_DIAMETER = ("wheel_diameter", "wheelDiameter")


class Wheel(NamedTuple):
    """A wheel of a drive, in the frame of the model."""

    joint: Joint
    position: tuple[float, ...]
    axis: tuple[float, ...]
    """Of length 1."""
    radius: float
    """m, of its round shape; nan where there is none."""


class Drive(NamedTuple):
    """A drive with one wheel on each side, or with several whose distance along the robot it takes as well."""

    left: Wheel
    right: Wheel
    left_name: Element
    """The parameter that names the joint."""
    right_name: Element
    separation: Element | None
    radius: Element | None
    """The parameter of the radius or the diameter."""
    base: Element | None = None
    """The parameter of the distance of the axles."""
    rear: Wheel | None = None
    """The other wheel on the left."""

    @property
    def distance(self) -> float:
        """How far to the left of the right wheel the left one is, along its axis (m)."""
        pairs = zip(self.left.position, self.right.position, self.left.axis, strict=True)
        return sum((left - right) * along for left, right, along in pairs)

    @property
    def axle_distance(self) -> float:
        """How far the wheels on the left are apart, across their axis (m); nan where there is one."""
        if self.rear is None:
            return math.nan
        apart = [a - b for a, b in zip(self.left.position, self.rear.position, strict=True)]
        along = sum(step * axis for step, axis in zip(apart, self.left.axis, strict=True))
        return math.sqrt(max(0.0, math.hypot(*apart) ** 2 - along**2))

    @property
    def written_radius(self) -> float:
        """The radius that the plugin takes (m); nan if none is written."""
        number = self.radius.own_value.number if self.radius is not None else math.nan
        return number / 2 if self.radius is not None and self.radius.name in _DIAMETER else number


def drive_of(plugin: Plugin) -> Drive | None:
    """The drive that a plugin makes; None for other plugins, more wheels a side, and what is not known."""
    model = _driven_model(plugin)
    given: dict[str, list[Element]] = {}
    for parameter in plugin.parameters:
        given.setdefault(parameter.name, []).append(parameter)
    lefts, rights = ([each for name in names for each in given.get(name, ())] for names in (_LEFT, _RIGHT))
    base = _only(given, _BASE)
    if model is None or not 0 < len(lefts) == len(rights) <= (1 if base is None else 2):
        return None
    wheels = [_wheel(model, name.content.strip()) for name in (lefts[0], rights[0], *lefts[1:])]
    first, second, *rear = wheels
    if first is None or second is None or first.joint is second.joint:
        return None
    radius = _only(given, (*_RADIUS, *_DIAMETER))
    separation = _only(given, _SEPARATION)
    return Drive(first, second, lefts[0], rights[0], separation, radius, base, rear[0] if rear else None)


def _only(given: dict[str, list[Element]], names: tuple[str, ...]) -> Element | None:
    found = [element for name in names for element in given.get(name, ())]
    return found[0] if len(found) == 1 else None


def _driven_model(plugin: Plugin) -> Model | None:
    scope = plugin.root.scope_of(plugin.element)
    return scope if isinstance(scope, Model) else None


def _wheel(model: Model, name: str) -> Wheel | None:
    joint = model.joints_by_name.get(name)
    if joint is None or joint.axis_count != 1 or joint.at_rest is None or joint.direction is None:
        return None
    return Wheel(joint, joint.at_rest.position, joint.direction, wheel_radius(joint))


def wheel_radius(joint: Joint) -> float:
    """The radius (m) of the one round shape of the link that a joint turns; nan where it has another number of them."""
    link = joint.child_link
    shapes = (link.collisions or link.visuals) if link is not None else ()
    geometry = shapes[0].geometry if len(shapes) == 1 else None
    if geometry is None or geometry.solid is None or geometry.shape not in {"cylinder", "sphere"}:
        return math.nan
    return float(geometry.radius)

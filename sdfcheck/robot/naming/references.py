"""References: every text of a description that names a link, joint, frame or model."""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import TYPE_CHECKING

from sdfcheck.robot.graph import Include, Model, Plugin, Scope, State
from sdfcheck.robot.part import Node
from sdfcheck.source.record import NamedTuple
from sdfcheck.source.text import pattern

if TYPE_CHECKING:
    from sdfcheck.robot.part import Part, Whole
    from sdfcheck.source.document import Element, Value

_ATTRIBUTES = {
    "frame": ("attached_to",),
    "pose": ("relative_to", "frame"),
    "xyz": ("expressed_in",),
    "model": ("canonical_link", "placement_frame"),
    "mimic": ("joint",),
    "custom_rpy": ("parent_frame",),
}
"""Element of SDFormat → its attributes that name a node of the model or world around it."""

_ELEMENTS = ("parent", "child", "gearbox_reference_body", "gripper_link", "palm_link")

_URDF = {"parent": ("link",), "child": ("link",), "mimic": ("joint",), "gazebo": ("reference",)}
_IN_EXTENSIONS = ("pose", "frame", "xyz")
"""Elements of SDFormat whose attributes name nodes in ``<gazebo>`` blocks of URDF, too."""
_URDF_JOINTS = frozenset(("transmission", "ros2_control"))
_OF_JOINTS = _URDF_JOINTS | {"mimic"}

_IN_STATES = frozenset(("model", "link", "joint", "model_state", "link_state", "joint_state"))
NAMING = pattern(r"link|joint|frame|body|model", re.IGNORECASE)
"""Parameters of plugins that are called so are taken for names, where there is a node of that name."""


class Reference(NamedTuple):
    """A text that names a node: ``nodes`` are what its parts between ``::`` name, the last one is meant."""

    value: Value
    nodes: tuple[Node, ...]


def references(root: Whole) -> Iterator[Reference]:
    """The references of a file that name something, in no particular order."""
    for element, value in _values(root):
        scope = _scope(root, element)
        nodes = _nodes(scope, element, value.text.strip()) if scope is not None else ()
        if nodes:
            yield Reference(value, nodes)
    for state in root.each(State):
        if state.world is not None:
            yield from _in_state(state.element, state.world)


def _in_state(holder: Element, scope: Scope) -> Iterator[Reference]:
    """The models, links and joints that a state of a world or model names."""
    for part in holder.children():
        name = part.attribute("name") if part.name in _IN_STATES else None
        nodes = () if name is None else _path(scope, name.text.strip())
        if name is not None and nodes:
            yield Reference(name, nodes)
            if isinstance(nodes[-1], Scope):
                yield from _in_state(part, nodes[-1])


def _values(root: Whole) -> Iterator[tuple[Element, Value]]:
    """Every text that may be a reference, and the element from which it looks."""
    yield from written(root)
    for plugin in root.each(Plugin):
        yield from _parameters(plugin)


def written(root: Whole) -> Iterator[tuple[Element, Value]]:
    """Every text that the format takes for a reference, and the element from which it looks."""
    yield from _in_attributes(root)
    for name in _ELEMENTS:
        for element in root.elements.get(name, ()):
            if element.content and element.attribute("link") is None:
                yield element, element.own_value
    for include in root.each(Include):
        placement = include.find("placement_frame")
        if placement is not None and placement.content:
            yield placement, placement.own_value


def _in_attributes(root: Whole) -> Iterator[tuple[Element, Value]]:
    for name, attributes in (_URDF if root.is_urdf else _ATTRIBUTES).items():
        for element in root.elements.get(name, ()):
            for value in filter(None, map(element.attribute, attributes)):
                yield element, value
    if root.is_urdf:
        yield from _in_extensions(root)
    for name in _URDF_JOINTS if root.is_urdf else ():
        for block in root.elements.get(name, ()):
            for joint in block.children("joint"):
                if (name_value := joint.attribute("name")) is not None:
                    yield block, name_value


def _in_extensions(root: Whole) -> Iterator[tuple[Element, Value]]:
    """The references of SDFormat in ``<gazebo>`` blocks."""
    for name in _IN_EXTENSIONS:
        for element in root.elements.get(name, ()):
            if any(each.name == "gazebo" for each in element.around):
                for value in filter(None, map(element.attribute, _ATTRIBUTES[name])):
                    yield element, value


def _parameters(plugin: Plugin) -> Iterator[tuple[Element, Value]]:
    waiting = list(plugin.children())
    for element in waiting:
        children = list(element.children())
        waiting += children
        if not children and element.content and NAMING.search(element.name):
            yield plugin.element, element.own_value


def _scope(root: Whole, element: Element) -> Scope | None:
    """The model or world in which a reference is looked up."""
    at: Part | None = root.part_of(element)
    if isinstance(at, Scope) and element.name == "model":
        return at  # its canonical link and placement frame are its own
    if element.name == "placement_frame" and at is not None and isinstance(at.holder, Include):
        return at.holder.model
    if element.name == "pose" and at is not None and isinstance(at.holder, Scope):
        at = at.holder  # the pose of a model is written where the model is
    while at is not None:
        at = at.holder
        if isinstance(at, Scope):
            return at
    return None


def _nodes(scope: Scope, element: Element, text: str) -> tuple[Node, ...]:
    """The part that a reference names; in URDF a joint may have the name of a link."""
    joints = scope.joints_by_name if isinstance(scope, Model) and scope.is_urdf else {}
    if element.name in _OF_JOINTS and text in joints:
        return (joints[text],)
    return _of_plugin(scope, text) if element.name == "plugin" else _path(scope, text)


def _of_plugin(scope: Scope, text: str) -> tuple[Node, ...]:
    """The parts that a plugin's name leads through; it may begin with the model that the plugin is in."""
    own, delimiter, rest = text.partition("::")
    found = _path(scope, text)
    if found or not delimiter or own != scope.name or not isinstance(scope, Model):
        return found
    inner = _path(scope, rest)
    return (scope, *inner) if inner else ()


def _path(scope: Scope, text: str) -> tuple[Node, ...]:
    found: list[Node] = []
    at: Node = scope
    for step in text.split("::"):
        node = at.resolve(step) if isinstance(at, Scope) else None
        if node is None or (found and node is at):
            return ()
        found.append(node)
        at = node
    return tuple(found)

"""Names of joints and links that the parameters of plugins write.

Systems look among the joints and links directly in their model, and know no ``::`` but for some.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import TYPE_CHECKING

from sdfcheck.robot.model import Model
from sdfcheck.source.element import Value
from sdfcheck.source.record import NamedTuple

if TYPE_CHECKING:
    from sdfcheck.formats.plugins import Naming, PluginFacts
    from sdfcheck.robot.node import Node
    from sdfcheck.robot.parts.plugin import Plugin
    from sdfcheck.source.element import Element

_TEMPLATE = re.compile(r"[${}%@]")
_ALWAYS = frozenset({"", "world", "canonical", "__default__"})


class PluginReference(NamedTuple):
    """A name that a parameter writes, of a joint or link as ``kind`` says; ``node`` is what has the name."""

    value: Value
    kind: str
    model: Model
    node: Node | None

    @property
    def is_unresolved(self) -> bool:
        """Does it reach no joint or link of its kind, or a joint that libsdformat merges away?"""
        return self.node is None or self.node.kind != self.kind or _is_lumped(self.node)


def references(plugin: Plugin, facts: PluginFacts) -> Iterator[PluginReference]:
    """The names of joints and links that are written; what may be in a file that could not be read is left out."""
    model = _model(plugin)
    if model is None or not model.is_complete or not any(n.kind == "link" for n in model.nodes.values()):
        return
    for naming in facts.namings:
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

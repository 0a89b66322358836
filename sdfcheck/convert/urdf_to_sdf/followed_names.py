"""Names that the content of ``<gazebo>`` blocks writes: of collisions, in the words of libsdformat, and of links.

A contact sensor names a collision as libsdformat calls it, which is not what the result calls it. Of
the parameters of plugins libsdformat rewrites two, with the offset of the link that is merged
(parser_urdf.cc, ReduceSDFExtensionPluginFrameReplace); others stay as they are, and are reported.
"""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from sdfcheck.consumers.reaction import Consumer
from sdfcheck.convert.loss import LossKind
from sdfcheck.convert.urdf_to_sdf.context import Context
from sdfcheck.convert.writer import Node, numbers
from sdfcheck.formats.sdf.values import floats
from sdfcheck.lint.diagnostic import Severity
from sdfcheck.robot.model import Model
from sdfcheck.robot.motion.rotations import Array, from_rpy, to_rpy, transform
from sdfcheck.robot.naming.references import NAMING
from sdfcheck.source.element import Element

_WITH_OFFSET = ("bodyName", "frameName")
"""Parameters of plugins in which the name of a link is rewritten."""
_ENDS = ("parent", "child")
_ORIGIN = ("xyzOffset", "rpyOffset")


class FollowedNames:
    """Rewrites what a copy of a block's content calls by a name that the result has for nothing."""

    def __init__(self, context: Context, robot: Model) -> None:
        self.context = context
        built = robot.as_built_by(Consumer.GAZEBO)
        self.collisions = {
            shape.name: shape.origin.element for link in built.links.values() for shape in link.collisions
        }
        """The names that libsdformat gives to collisions → the collision."""
        self.gone = dict(self._gone())

    def _gone(self) -> Iterator[tuple[str, tuple[LossKind, str]]]:
        """The names of links and joints that were merged or renamed, with the reason."""
        plan = self.context.plan
        of_links = plan.names.links.keys() - {name for name in plan.names.links if plan.is_merged(name)}
        for name, new in plan.names.joints.items():
            if name in of_links:
                continue
            if name in plan.merged_joints:
                yield name, (LossKind.MERGED_LINK, f"joint `{name}` was merged")
            elif new != name:
                yield name, (LossKind.RENAMED, f"joint `{name}` is now named `{new}`")
        for name, new in plan.names.links.items():
            survivor = plan.home[name][0]
            if survivor != name:
                yield name, (LossKind.MERGED_LINK, f"link `{name}` is now part of link `{survivor}`")
            elif new != name and not plan.is_world(name):
                yield name, (LossKind.RENAMED, f"link `{name}` is now named `{new}`")

    def follow(self, entry: Element, made: Node, holder: Node) -> None:
        """Look at one element of a block, its copy, and the element that holds the copy."""
        for element, node in _pairs(entry, made):
            if element.name == "contact" and element.parent is not None and element.parent.name == "sensor":
                self._follow_collisions(element, node, holder)
            elif element.name == "plugin":
                self._follow_parameters(element, node)
            elif element.name in _ENDS:
                self._follow_scope(element, node)

    def _follow_scope(self, end: Element, made: Node) -> None:
        """Rewrite the end of a joint in a model of a block that has got another name."""
        own, delimiter, rest = end.content.partition("::")
        if delimiter and own in self.context.own_names:
            made.text = f"{self.context.own_names[own]}::{rest}"
            self.context.note(end, LossKind.RENAMED, f"`{end.content}` is now `{made.text}`", Severity.INFO)

    def _follow_collisions(self, contact: Element, made: Node, holder: Node) -> None:
        for element, node in zip(contact.children("collision"), made.elements("collision"), strict=False):
            own = node.text or ""
            collision = self.collisions.get(own)
            written = None if collision is None else self.context.shapes.get(collision)
            if written is None or own in {
                part.attributes.get("name") for part in holder.elements("collision")
            }:
                continue
            link, shape = written
            if link is holder:
                node.text = shape.attributes["name"]
                if node.text != own:
                    text = f"collision `{own}`, as libsdformat calls it, is named `{node.text}`"
                    self.context.note(element, LossKind.RENAMED, text, Severity.INFO)
            else:
                text = f"{contact.parent.title if contact.parent is not None else contact.title} gets no contacts: "
                text += f"collision `{shape.attributes['name']}` is in link `{link.attributes['name']}`"
                self.context.note(element, LossKind.DROPPED_SENSOR, text)

    def _follow_parameters(self, plugin: Element, made: Node) -> None:
        for element, node in _pairs(plugin, made):
            found = self.gone.get(element.content)
            if found is None:
                continue
            kind, what = found
            if kind is LossKind.RENAMED and NAMING.search(element.name):
                node.text = self._renamed(element.content)
                text = f"<{element.name}> of {plugin.title} names `{node.text}`: {what}"
                self.context.note(element, kind, text, Severity.INFO)
                continue
            if element.parent is plugin and element.name in _WITH_OFFSET:
                survivor, offset = self.context.plan.home.get(element.content, ("", np.eye(4)))
                if survivor in self.context.links:
                    self._move(plugin, made, offset)
                    node.text = self.context.plan.names.links[survivor]
                    text = f"<{element.name}> of {plugin.title} names `{node.text}`: {what}"
                    self.context.note(element, kind, text, Severity.INFO)
                    continue
            text = f"<{element.name}> of {plugin.title} stays as it is, but {what}"
            self.context.note(element, kind, text)

    def _renamed(self, name: str) -> str:
        """The new name of a link or joint; a link goes before a joint of its name."""
        names = self.context.plan.names
        is_link = name in names.links and not self.context.plan.is_merged(name)
        return names.links[name] if is_link else names.joints[name]

    def _move(self, plugin: Element, made: Node, offset: Array) -> None:
        """Write where the plugin is in the link that is left, 4×4 ``offset`` being the place of its own link."""
        given = [plugin.find(name) for name in _ORIGIN]
        values = [(floats(one.content) if one is not None else None) or (0.0, 0.0, 0.0) for one in given]
        if any(len(numbers_) != len(_AXES) for numbers_ in values):
            return
        place = offset @ transform(from_rpy(*values[1]), values[0])
        if np.array_equal(place, np.eye(4)):
            return
        rows = (tuple(map(float, place[:3, 3])), to_rpy(place[:3, :3]))
        for name, one, value in zip(_ORIGIN, given, rows, strict=True):
            made.reach(name).text = numbers(value)
            if one is not None:
                text = f"<{name}> of {plugin.title} is from the link that is left"
                self.context.note(one, LossKind.MERGED_LINK, text, Severity.INFO)


_AXES = "xyz"


def _pairs(element: Element, node: Node) -> Iterator[tuple[Element, Node]]:
    """An element and its copy, and those in them, as long as they go together."""
    yield element, node
    for child, made in zip(element.children(), node.elements(), strict=False):
        if child.name != made.name:
            return
        yield from _pairs(child, made)

"""``<gazebo>`` blocks: what a URDF file says to Gazebo, in SDFormat."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from typing import TYPE_CHECKING, cast

from sdfcheck.formats.urdf.schema import TRUE, all_settings, settings
from sdfcheck.robot.graph import Model, Node, Part
from sdfcheck.robot.naming.name import NODES
from sdfcheck.robot.values import lazy, parts
from sdfcheck.source.document import Element
from sdfcheck.source.text import is_expression

if TYPE_CHECKING:
    from sdfcheck.robot.graph import Scope
    from sdfcheck.robot.parts.joint import Joint
    from sdfcheck.robot.parts.link import Link
    from sdfcheck.robot.parts.plugin import Plugin
    from sdfcheck.robot.parts.sensor import Light, Sensor
    from sdfcheck.source.document import Value


def text_of_setting(element: Element) -> str:
    """The text of a setting, or its ``value`` attribute, with one space between words."""
    return " ".join((element.content or element.attributes.get("value", "")).split())


class GazeboBlock(Part):
    """A ``<gazebo>`` block about a link, a joint, or (without ``reference``) the robot.

    Sensors, lights, plugins, joints and models in it are parts as in SDFormat.
    """

    __slots__ = ()
    kind = "gazebo"

    def __init__(self, holder: Part, element: Element | None) -> None:
        super().__init__(holder, element)
        self.is_urdf = False

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

    @property
    def reference_value(self) -> Value | None:
        """The reference with its place."""
        return self.attribute("reference")

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
        joints that xacro writes with other arguments.
        """
        name = self.reference
        if not name or self.link is not None or self.joint is not None:
            return False
        if is_expression(name) or name in self.model.link_names.unknown:
            return False
        return not self.document.may_write(
            rf'<(?:link|joint)\s[^<>]*\bname\s*=\s*["\']{re.escape(name)}["\']'
        )

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
        known = all_settings() if about else {}
        for child in self.children():
            setting = known.get(child.name)
            if setting is not None and setting.about not in about:
                yield child, setting.about

    @property
    def overridable(self) -> list[Element]:
        """The settings of libsdformat in it of which the last one counts, whichever block gives it."""
        known = {"gravity", "material", "static", *settings("link"), *settings("joint")}
        return [child for child in self.children() if child.name in known]

    def switched_on(self, name: str) -> list[Element]:
        """The settings of a name that are true."""
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

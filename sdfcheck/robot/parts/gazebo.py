"""``<gazebo>`` blocks: what a URDF file says to Gazebo, in SDFormat."""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import TYPE_CHECKING, cast

from sdfcheck.formats.urdf.table import TRUE, extension, is_expression, settings
from sdfcheck.robot.part import Part
from sdfcheck.robot.values import lazy, parts

if TYPE_CHECKING:
    from sdfcheck.robot.model import Model
    from sdfcheck.robot.parts.joint import Joint
    from sdfcheck.robot.parts.light import Light
    from sdfcheck.robot.parts.link import Link
    from sdfcheck.robot.parts.plugin import Plugin
    from sdfcheck.robot.parts.sensor import Sensor
    from sdfcheck.robot.scope import Scope
    from sdfcheck.source.element import Element, Value


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
        known = extension().children if about else {}
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

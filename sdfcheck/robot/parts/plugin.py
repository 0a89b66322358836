"""Plugins."""

from __future__ import annotations

from typing import TYPE_CHECKING

from sdfcheck.robot.part import Part
from sdfcheck.robot.values import lazy

if TYPE_CHECKING:
    from collections.abc import Iterator

    from sdfcheck.formats.plugins import PluginFacts
    from sdfcheck.robot.naming.plugin_names import PluginReference
    from sdfcheck.robot.parts.drive import Drive
    from sdfcheck.source.element import Element, Value


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
    def unresolved(self) -> tuple[PluginReference, ...]:
        """The parameters that name a joint or link which its model does not have."""
        if self.known is None or not self.known.namings:
            return ()
        from sdfcheck.robot.naming.plugin_names import unresolved

        return tuple(unresolved(self, self.known))

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
        is_block = parent.tag == own.tag == "gazebo"
        return is_block and parent.attributes.get("reference", "") == own.attributes.get("reference", "")

    @lazy
    def drive(self) -> Drive | None:
        """The differential drive that it makes, where it names one wheel on each side, and both are known."""
        if "drive" not in self.filename.lower():
            return None
        from sdfcheck.robot.parts.drive import drive_of

        return drive_of(self)

    @lazy
    def meant_file(self) -> str | None:
        """The file of a system of Gazebo that was probably meant by a file that is not one."""
        name = self.filename
        if self.known is not None or not ("gz-sim" in name or "ignition-gazebo" in name):
            return None
        from sdfcheck.formats.plugins import known_files, stem

        return self.nearest(stem(name), known_files())

    @lazy
    def misspelled_parameters(self) -> tuple[tuple[Element, str], ...]:
        """The parameters that it does not read, with those that they were probably meant to be."""
        known = self.known.parameters if self.known is not None else ()
        if not known:
            return ()
        given = [parameter for parameter in self.parameters if ":" not in parameter.name]
        names = {parameter.name for parameter in given}
        unread = [parameter for parameter in given if parameter.name not in known]
        found = ((each, self.nearest(each.name, [n for n in known if n not in names])) for each in unread)
        return tuple((each, meant) for each, meant in found if meant is not None)

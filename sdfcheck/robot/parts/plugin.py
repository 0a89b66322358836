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
    def references(self) -> tuple[PluginReference, ...]:
        """The parameters that name a joint or link of its model."""
        if self.known is None or not self.known.namings:
            return ()
        from sdfcheck.robot.naming.plugin_names import references

        return tuple(references(self, self.known))

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
        """The differential drive that it makes, where it names one wheel on each side, and both are known."""
        if "drive" not in self.filename.lower():
            return None
        from sdfcheck.robot.parts.drive import drive_of

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
        found = ((each, facts.in_other_case(each.name) or self.nearest(each.name, free)) for each in unread)
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

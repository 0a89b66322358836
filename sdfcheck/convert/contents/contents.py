"""The contents of a robot, by the part that they belong to."""

from __future__ import annotations

from sdfcheck.convert.contents.entry import Entry
from sdfcheck.source.element import Element


class Contents:
    """Settings by kind and name of their part (``link``, ``joint``, ``model``), and by the element of their shape."""

    __slots__ = ("name", "parts", "shapes")

    def __init__(self, name: str) -> None:
        self.name = name
        """That of the robot."""
        self.parts: dict[tuple[str, str], Entry] = {}
        self.shapes: dict[Element, Entry] = {}

    def add(self, kind: str, name: str, entry: Entry) -> Entry:
        """The settings of a part; of several of a name the first."""
        return self.parts.setdefault((kind, name), entry)

    def of(self, kind: str, name: str) -> Entry:
        """The settings of a part; none are an empty entry."""
        return self.parts.get((kind, name)) or Entry(kind)

    def count(self) -> dict[str, int]:
        """How many sensors, plugins, lights, materials and pieces of custom data there are."""
        found: dict[str, int] = {}
        entries = [*self.parts.values(), *self.shapes.values()]
        while entries:
            entry = entries.pop()
            kind = "custom element" if ":" in entry.name else entry.name
            if kind in COUNTED:
                found[kind] = found.get(kind, 0) + 1
            if kind not in {"plugin", "custom element"}:
                entries += entry.children
        return found


COUNTED = ("sensor", "light", "plugin", "material", "surface", "custom element")
"""The settings that a summary counts."""

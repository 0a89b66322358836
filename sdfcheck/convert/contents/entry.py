"""Settings as trees of names and values, whatever they were written in, and how two trees differ."""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Callable, Iterator
from copy import copy

import numpy as np

from sdfcheck.convert.marks import MARKS
from sdfcheck.formats.schema import NOT_GIVEN, Definition
from sdfcheck.formats.sdf.sensors import NEWEST_TYPES
from sdfcheck.formats.vendor import known_tables
from sdfcheck.robot.motion.rotations import Array, to_rpy
from sdfcheck.source.document import Element
from sdfcheck.source.record import NamedTuple

Same = Callable[[str, str], bool]
"""Do two texts say the same?"""

_NEAR = 1e-9
"""Poses nearer than this are one (m, and entries of rotations)."""
_BOOLEANS = {"true": "1", "false": "0"}


class Entry:
    """One setting: its value, its attributes, and the settings in it."""

    __slots__ = ("attributes", "children", "definition", "element", "name", "own", "pose", "text")

    def __init__(
        self, name: str, text: str = "", element: Element | None = None, definition: Definition | None = None
    ) -> None:
        self.name = name
        self.text = text
        self.element = element
        """The place in the text that it comes from."""
        self.definition = definition
        """Its definition in the format; None for a custom element, or free content."""
        self.attributes: dict[str, str] = {}
        self.children: list[Entry] = []
        self.pose: Array | None = None
        """Where it is in its link, 4×4, if the link places it."""
        self.own = ""
        """The name that its author gave it."""

    @property
    def title(self) -> str:
        return f"{self.name} `{self.own}`" if self.own else self.name

    def add(self, child: Entry) -> Entry:
        self.children.append(child)
        return child

    def find(self, name: str) -> Entry | None:
        return next((child for child in self.children if child.name == name), None)

    def reach(self, path: tuple[str, ...], element: Element | None = None) -> Entry:
        """The setting at the end of a path, made where it is missing."""
        at = self
        for name in path:
            definition = at.definition.children.get(name) if at.definition is not None else None
            at = at.find(name) or at.add(Entry(name, "", element, definition))
        return at

    def seen_from(self, frame: Array) -> Entry:
        """The settings of a link in another frame, in which the link's own has a 4×4 pose."""
        made = copy(self)
        made.children = [copy(child) for child in self.children]
        for child in made.children:
            child.pose = None if child.pose is None else frame @ child.pose
        return made

    def is_default(self) -> bool:
        """Does it say no more than the format takes for granted?"""
        definition = self.definition
        if definition is None or definition.open:
            return False
        if any(not _is_taken(text, definition, name) for name, text in self.attributes.items()):
            return False
        if definition.type is not None:
            default = definition.default
            return default not in {None, NOT_GIVEN} and same_text(self.text, default or "")
        return not self.own and all(child.is_default() for child in self.children)


def entry_of(element: Element, definition: Definition | None, without: frozenset[str] = frozenset()) -> Entry:
    """An element with all that is in it, apart from some of its children."""
    made = Entry(element.name, " ".join(element.content.split()), element, definition)
    for name, text in element.attributes.items():
        if name == "name":
            made.own = text
        elif name not in MARKS:
            made.attributes[name] = text
    for child in element.children():
        if child.name not in without:
            inner = (
                definition.children.get(child.name)
                if definition is not None and not definition.open
                else None
            )
            made.add(entry_of(child, inner))
    if element.name == "sensor":
        _say_in_newest_words(made)
    return made


def _say_in_newest_words(sensor: Entry) -> None:
    """Give the type and the settings of a sensor the names of the newest version."""
    kind = sensor.attributes.get("type", "")
    sensor.attributes["type"] = NEWEST_TYPES.get(kind, kind)
    for child in sensor.children:
        newest = NEWEST_TYPES.get(child.name)
        if newest is not None and sensor.find(newest) is None:
            child.name = newest


class Divergence(NamedTuple):
    """One thing in which two trees differ: where, and what either says; ``none`` for nothing."""

    path: str
    before: str
    after: str
    element: Element | None
    """The place in the first text, or the nearest one."""

    @property
    def name(self) -> str:
        """The element or attribute that differs, prefix included."""
        return self.path.rpartition("@")[2].rpartition("/")[2]

    @property
    def is_custom(self) -> bool:
        """Is it data under a prefix of which no table knows what reads it?"""
        prefix, colon, _ = self.name.partition(":")
        document = None if self.element is None else self.element.document
        return bool(colon) and prefix not in known_tables(document and document.library)


def same_text(a: str, b: str, tolerance: float = 1e-9) -> bool:
    """Do two values say the same: as numbers, as booleans, or word for word?"""
    if a == b:
        return True
    mine, theirs = a.split(), b.split()
    return len(mine) == len(theirs) and all(
        x == y or _same_word(x, y, tolerance) for x, y in zip(mine, theirs, strict=True)
    )


def _same_word(a: str, b: str, tolerance: float) -> bool:
    x, y = (_BOOLEANS.get(word.lower(), word) for word in (a, b))
    if x == y:
        return True
    try:
        mine, theirs = float(x), float(y)
    except ValueError:
        return False
    return same_number(mine, theirs, tolerance)


def same_number(a: float, b: float, tolerance: float) -> bool:
    """Are two numbers of a robot equal, but for rounding?"""
    return a == b or math.isclose(a, b, rel_tol=tolerance, abs_tol=min(tolerance, 1e-12))


def divergences(
    a: Entry, b: Entry, same: Same = same_text, path: str = "", *, deep: bool = False
) -> Iterator[Divergence]:
    """In what two settings of one name differ; ``deep``: with each setting in one that is missing."""
    yield from _values(a, b, same, path)
    if a.pose is not None and b.pose is not None and float(np.abs(a.pose - b.pose).max()) > _NEAR:
        yield Divergence(f"{path}/pose", _placed(a.pose), _placed(b.pose), a.element)
    yield from _children_apart(a, b, same, path, deep=deep)


def _children_apart(a: Entry, b: Entry, same: Same, path: str, *, deep: bool) -> Iterator[Divergence]:
    """In what the settings inside two others differ."""
    left = _keyed(b)
    for key, child in _keyed(a).items():
        inner = f"{path}/{child.title}" if path else child.title
        other = left.pop(key, None)
        if other is not None:
            yield from divergences(child, other, same, inner, deep=deep)
        elif deep and child.children and not child.own:
            empty = Entry(child.name, "", None, child.definition)
            yield from divergences(child, empty, same, inner, deep=True)
        elif not child.is_default():
            yield Divergence(
                inner, _shown(child), "none", a.element if child.element is None else child.element
            )
    for child in left.values():
        if not child.is_default():
            inner = f"{path}/{child.title}" if path else child.title
            yield Divergence(inner, "none", _shown(child), a.element)


def _values(a: Entry, b: Entry, same: Same, path: str) -> Iterator[Divergence]:
    mine, theirs = _value(a), _value(b)
    if not same(mine, theirs):
        yield Divergence(path, mine or "none", theirs or "none", a.element)
    for name in dict.fromkeys((*a.attributes, *b.attributes)):
        mine, theirs = (entry.attributes.get(name, _default(entry, name)) for entry in (a, b))
        if not same(mine, theirs):
            yield Divergence(f"{path} @{name}".lstrip(), mine or "none", theirs or "none", a.element)


def _value(entry: Entry) -> str:
    """Its text; an empty one means the default."""
    definition = entry.definition
    if entry.text and definition is not None and definition.type == "color" and len(entry.text.split()) == 3:
        return f"{entry.text} 1"
    if entry.text or definition is None or definition.type is None:
        return entry.text
    return "" if definition.default in {None, NOT_GIVEN} else definition.default or ""


def _placed(pose: Array) -> str:
    return " ".join(
        f"{0.0 if abs(number) < _NEAR else number:.6g}" for number in (*pose[:3, 3], *to_rpy(pose[:3, :3]))
    )


def _default(entry: Entry, name: str) -> str:
    known = entry.definition.attributes.get(name) if entry.definition is not None else None
    return "" if known is None or known.default == NOT_GIVEN else known.default


def _is_taken(text: str, definition: Definition, name: str) -> bool:
    known = definition.attributes.get(name)
    return known is not None and same_text(text, known.default)


def _keyed(entry: Entry) -> dict[tuple[str, str, int], Entry]:
    """The settings inside one, by name, the author's name for it, and number among its like."""
    found: dict[tuple[str, str, int], Entry] = {}
    counts: Counter[tuple[str, str]] = Counter()
    for child in entry.children:
        name = child.name, child.own
        found[child.name, child.own, counts[name]] = child
        counts[name] += 1
    return found


def _shown(entry: Entry) -> str:
    kind = entry.attributes.get("type") or entry.attributes.get("filename") or ""
    text = (
        entry.text or kind or entry.own or (f"{len(entry.children)} settings" if entry.children else "given")
    )
    return text if len(text) <= 60 else f"{text[:60]}…"


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

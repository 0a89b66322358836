"""What URDF allows where, and what its consumers make of it.

There is no official schema: the table (``data/urdf.txt``) holds the elements that urdfdom reads,
and in addition those of libsdformat, Drake, PyBullet and MuJoCo.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import cache
from math import inf
from pathlib import Path

from sdfcheck.formats.sdf.table import Range
from sdfcheck.formats.sdf.version import Version

_FILE = Path(__file__).parents[1] / "data" / "urdf.txt"

VERSIONS = (Version(1, 0), Version(1, 1), Version(1, 2))
"""The versions of URDF; a document without one has the first."""


class _Row:
    """A line of the table, and the lines below it."""

    __slots__ = ("fields", "keys", "rows")

    def __init__(self, line: str) -> None:
        fields = line.split("\t")
        self.fields = [*fields[:4], "", "", ""][:4]
        self.keys = dict(field.split("=", 1) for field in fields[4:])
        self.rows: list[_Row] = []


class UrdfAttribute:
    """An attribute, or the text of an element, with the type of what it holds."""

    __slots__ = (
        "accepts",
        "choices",
        "consumers",
        "default",
        "element",
        "name",
        "range",
        "release",
        "required",
        "since",
        "sound",
        "type",
        "units",
    )

    def __init__(self, element: str, row: _Row) -> None:
        name, multiplicity, self.type, self.default = row.fields
        self.element = element
        """The name of the element that has it."""
        self.name = name.removeprefix("@")
        self.required = multiplicity == "1"
        self.since = Version(*map(int, row.keys.get("since", "1.0").split(".")))
        self.release = row.keys.get("release", "")
        """The first releases of ROS 2 that know it, in words; empty: all do."""
        self.range = _range(row.keys)
        self.choices: tuple[str, ...] = tuple(filter(None, row.keys.get("choices", "").split(",")))
        self.units = tuple(filter(None, row.keys.get("unit", "").split("|")))
        """Its unit; two where it depends on the joint: angular, linear."""
        self.consumers = tuple(filter(None, row.keys.get("consumers", "").split(",")))
        """Its consumers; empty: urdfdom, and with it almost all."""
        self.accepts: Callable[[str], object] = _acceptance(self)
        """True for text that is surely read as written and nothing can be said against."""
        self.sound: set[str] = set()
        """Texts that ``accepts`` has accepted, remembered by those who walk over documents."""

    def __repr__(self) -> str:
        return f"UrdfAttribute({self.element}/@{self.name})"

    @property
    def is_number(self) -> bool:
        """Whether it holds numbers, one or several."""
        return self.type in _COUNTS


class UrdfElement:
    """An element, as URDF allows it below one kind of parent."""

    __slots__ = (
        "about",
        "attributes",
        "children",
        "consumers",
        "counterparts",
        "name",
        "negated",
        "open",
        "release",
        "required",
        "required_attributes",
        "required_children",
        "since",
        "single",
        "value",
    )

    def __init__(self, row: _Row, use: _Row, blocks: dict[str, _Row]) -> None:
        self.name, multiplicity = use.fields[:2]
        kind, keys = row.fields[2], {**row.keys, **use.keys}
        self.single = multiplicity in {"0", "1"}
        self.required = multiplicity in {"1", "+"}
        self.open = kind == "open"
        """Content is free: nothing inside is URDF."""
        self.since = Version(*map(int, keys.get("since", "1.0").split(".")))
        self.release = keys.get("release", "")
        self.consumers = tuple(filter(None, keys.get("consumers", "").split(",")))
        self.about = keys.get("at", "")
        """Of a setting in ``<gazebo>``: what the block is about (link, joint or robot); empty: nobody reads it."""
        paths = keys.get("sdf", "")
        self.counterparts = tuple(tuple(path.split("/")) for path in paths.lstrip("!").split(",") if path)
        """Of a setting in ``<gazebo>``: the paths at which SDFormat has it in the link or joint."""
        self.negated = paths.startswith("!")
        """Of a flag: does SDFormat say the contrary?"""
        self.value = UrdfAttribute(self.name, row) if kind and not self.open else None
        """The type of its text; None for an element that holds elements, or nothing."""
        self.attributes: dict[str, UrdfAttribute] = {}
        self.children: dict[str, UrdfElement] = {}
        for inner in row.rows:
            if inner.fields[0][0] == "@":
                attribute = UrdfAttribute(self.name, inner)
                self.attributes[attribute.name] = attribute
            else:
                kind = inner.fields[2]
                below = blocks[kind[1:]] if kind.startswith("^") else inner
                self.children[inner.fields[0]] = UrdfElement(below, inner, blocks)
        self.required_attributes = tuple(a.name for a in self.attributes.values() if a.required)
        self.required_children = tuple(c.name for c in self.children.values() if c.required)

    def __repr__(self) -> str:
        return f"UrdfElement({self.name})"

    def translated(self, text: str) -> str:
        """The text of a setting as SDFormat writes it: libsdformat takes each flag that is not true for false."""
        if self.value is None or self.value.type != "flag":
            return text
        return str((text.strip().lower() in TRUE) is not self.negated).lower()

    def at(self, path: str) -> UrdfElement | None:
        """The definition at a path below this one, such as ``joint/limit``; None without one."""
        found: UrdfElement | None = self
        for name in filter(None, path.split("/")):
            found = found and found.children.get(name)
        return found


@cache
def urdf() -> UrdfElement:
    """The element ``robot``, with everything in it."""
    blocks = _blocks()
    return UrdfElement(blocks["robot"], blocks["robot"], blocks)


@cache
def extension() -> UrdfElement:
    """The element ``gazebo``, with the settings in it that libsdformat translates."""
    blocks = _blocks()
    return UrdfElement(blocks["extension"], blocks["extension"], blocks)


def settings(about: str) -> dict[str, UrdfElement]:
    """The settings in ``<gazebo>`` that SDFormat has a place for, of blocks about a ``link`` or a ``joint``."""
    return {
        name: setting
        for name, setting in extension().children.items()
        if setting.about == about and setting.counterparts
    }


@cache
def control() -> UrdfElement:
    """The element ``ros2_control``, with what ros2_control reads of it."""
    blocks = _blocks()
    use = next(row for row in blocks["robot"].rows if row.fields[0] == "ros2_control")
    return UrdfElement(blocks["control"], use, blocks)


@cache
def known_parents(name: str) -> tuple[str, ...]:
    """The elements that may hold one of this name, sorted, of those that urdfdom reads."""
    found: set[str] = set()
    waiting = [urdf()]
    while waiting:
        element = waiting.pop()
        if name in element.children:
            found.add(element.name)
        waiting += [child for child in element.children.values() if not child.consumers]
    return tuple(sorted(found))


def _blocks() -> dict[str, _Row]:
    blocks: dict[str, _Row] = {}
    path: list[_Row] = []
    for line in _FILE.read_text("utf-8").splitlines():
        if line.startswith("#"):
            continue
        text = line.lstrip(" ")
        row = _Row(text)
        del path[len(line) - len(text) :]
        if path:
            path[-1].rows.append(row)
        else:
            blocks[row.fields[0]] = row
        path.append(row)
    return blocks


def _range(keys: dict[str, str]) -> Range | None:
    interval = keys.get("range")
    if interval is None:
        return None
    low, _, high = interval[1:-1].partition(",")
    found = Range(float(low), float(high), (interval[0] == "(", interval[-1] == ")"))
    found.instead = keys.get("instead")
    found.refused = found.instead is None
    return found


TRUE = frozenset(("1", "true", "yes"))
"""The words for true in ``<gazebo>``."""
_FLAGS = frozenset(("", "0", "false", "no", *TRUE))
"""The words for true and false in ``<gazebo>``; everything else is false as well."""
_COUNTS = {"double": 1, "vector3": 3, "color": 4, "quaternion": 4}


def _acceptance(attribute: UrdfAttribute) -> Callable[[str], object]:
    """A quick check. Unlike in SDFormat, a number must not be followed by spaces."""
    if attribute.required and attribute.type == "string" and not attribute.choices:
        return str.strip
    if attribute.choices:
        return frozenset(attribute.choices).__contains__
    if attribute.type == "flag":
        return _is_flag
    count = _COUNTS.get(attribute.type)
    if count is None:
        return str.isdecimal if attribute.type in {"int", "unsigned int"} else _anything
    return _numbers(count, attribute.range)


def _numbers(count: int, bounds: Range | None) -> Callable[[str], object]:
    def accepts(text: str) -> bool:
        # Stripping leaves nothing when all characters are of the given ones.
        if text.strip("0123456789.+-eE ") or len(text) > 150:
            return False
        parts = text.split()
        if len(parts) != count or (count == 1 and text[-1] == " "):
            return False
        try:
            numbers = [float(part) for part in parts]
        except ValueError:
            return False
        if bounds is not None:
            return all(map(bounds.holds, numbers))
        return max(numbers) < inf and min(numbers) > -inf

    return accepts


def _is_flag(text: str) -> bool:
    return text.strip().lower() in _FLAGS


def _anything(text: str) -> bool:
    return True

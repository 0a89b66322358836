"""What SDFormat allows where, for each of its versions."""

from __future__ import annotations

import re
from collections.abc import Callable
from functools import cache
from math import inf
from typing import TYPE_CHECKING, Any

from sdfcheck.formats.sdf.table import Row, at, block, newest_name
from sdfcheck.formats.sdf.version import Version

if TYPE_CHECKING:
    from sdfcheck.formats.sdf.choices import Choices
    from sdfcheck.formats.sdf.table import Range


# The common part of elements and attributes: a row of the table, as one version has it.


Accepts = Callable[[str], object]

# Digits are counted so that a number stays inside its type without being converted.
_NUMBER = r"[+-]?(?:\d{1,60}\.?\d{0,60}|\.\d{1,60})(?:[eE][+-]?\d\d?)?"
_SINGLE = r"[+-]?(?:\d{1,8}\.?\d{0,8}|\.\d{1,8})(?:[eE][+-]?[0-2]?\d)?"
_SHARE = r"(?:0?\.\d{1,20}|[01](?:\.0*)?)"
_WHOLE = r"[+-]?\d{1,9}"

_LONGEST = 60
_TINY = 1e-300

_TRUTH = frozenset(("true", "false", "1", "0", "True", "False"))
# Each part, and how many of them.
_PATTERNS = {
    "color": (_SHARE, "3,4"),
    "float": (_SINGLE, "1"),
    "pose": (_NUMBER, "6"),
    "time": (_WHOLE, "2"),
    "vector2d": (_NUMBER, "2"),
    "vector3": (_NUMBER, "3"),
}


class RowInVersion:
    """An element or attribute; ``choices``, ``range``, ``may_be_infinite`` and ``accepts`` at their first use."""

    __slots__ = ("accepts", "choices", "may_be_infinite", "name", "place", "range", "row", "version")
    version: Version
    row: Row
    name: str
    place: str
    """Its path over all versions, such as ``joint:joint/axis/limit/lower`` or ``joint:joint/@type``."""
    range: Range | None
    """Bounds that hold by meaning or by the table; libsdformat does not check those of attributes."""
    choices: Choices | None
    may_be_infinite: bool
    accepts: Accepts
    """True for text that is surely read as written and nothing can be said against.

    For a pose: with rotation_format euler_rpy, the default.
    """

    if TYPE_CHECKING:
        type: str | None
        default: str | None

        @property
        def needs_value(self) -> bool: ...
    else:

        def __getattr__(self, name: str) -> Any:
            if name == "choices":
                self.choices = self._read_choices()
            elif name == "range":
                self.range = self._read_range()
            elif name == "may_be_infinite":
                self.may_be_infinite = "inf" in self.row.default or self.row.extra("infinite") != ""
            elif name == "accepts":
                self.accepts = _acceptance(self)
            else:
                raise AttributeError(name)
            return object.__getattribute__(self, name)

    def _read_choices(self) -> Choices | None:
        if not self.row.extra("choices"):
            return None
        from sdfcheck.formats.sdf.choices import Choices

        return Choices.of(self.row, self.version)

    def _read_range(self) -> Range | None:
        if not self.row.extras:
            return None
        from sdfcheck.formats.sdf.table import Range

        return Range.of(self.row, self.version.minor)


def _acceptance(definition: RowInVersion) -> Accepts:
    """The check for one place. An empty text is accepted for texts only, where it is the default."""
    kind, bounds = definition.type, definition.range
    if kind is None:
        return _nothing
    if listed := at(definition.row.extra("choices"), definition.version.minor):
        return _choices(definition, listed)
    if kind == "bool":
        return _TRUTH.__contains__
    if kind in {"int", "unsigned int"}:
        return _bounded(_digits, bounds) if bounds else _digits
    if kind == "string" and bounds is None:
        return str.strip if definition.needs_value else _anything
    matches: Accepts
    if kind in {"double", "string"}:
        matches = _number_or_infinity if definition.may_be_infinite else _number
    else:
        matches = _parts(*_PATTERNS[kind])
    return matches if bounds is None else _bounded(matches, bounds)


def _anything(text: str) -> bool:
    return True


def _number(text: str) -> bool:
    # Stripping leaves nothing when all characters are of the given ones.
    if text.strip("0123456789.+-eE \t\n") or len(text) > _LONGEST:
        return False
    try:
        value = abs(float(text))
    except ValueError:
        return False
    return _TINY < value < inf or (value == 0 and "e" not in text and "E" not in text)


def _number_or_infinity(text: str) -> bool:
    return _number(text) or text in {"inf", "-inf", "+inf"}


def _digits(text: str) -> bool:
    return len(text) < 10 and text.isascii() and text.isdigit()


def _nothing(text: str) -> bool:
    return not text or text.isspace()


def _choices(definition: RowInVersion, listed: str) -> Accepts:
    accepted = set(listed.split(","))
    if library := definition.row.extra("library"):
        accepted.intersection_update(library.split(","))
    if definition.default != "__default__":
        accepted.add(definition.default or "")
    accepted.discard("") if definition.needs_value else accepted.add("")
    return frozenset(accepted).__contains__


@cache
def _parts(part: str, count: str) -> Accepts:
    return re.compile(rf"\s*(?:(?:{part})(?:\s+|\Z)){{{count}}}", re.ASCII).fullmatch


def _bounded(matches: Accepts, bounds: Range) -> Accepts:
    holds = bounds.holds

    def accepts(text: str) -> bool:
        return bool(matches(text)) and all(holds(float(part)) for part in text.split())

    return accepts


# What SDFormat allows where, for each of its versions.
#
# The walk over a document asks for plain attributes only: ``definition.children.get(tag)``,
# ``definition.attributes.get(name)``, ``definition.accepts(text)``. They are built at their
# first use, so that a document pays for the part of the format that it uses.


NOT_GIVEN = "__default__"
"""The default that means "not given": no value would be sensible."""

_NEEDED = frozenset(
    """
    attenuation/range battery/voltage blend/fade_dist blend/min_height
    box/size capsule/length capsule/radius cone/length cone/radius cylinder/length cylinder/radius
    ellipsoid/radii image/height image/scale image/width polyline/height polyline/point sphere/radius
    intrinsics/cx intrinsics/cy intrinsics/fx intrinsics/fy
    axis/xyz axis2/xyz inertia/ixx inertia/iyy inertia/izz
    joint/child joint/parent
    lidar/range lidar/scan ray/range ray/scan range/max range/min scan/horizontal
    horizontal/max_angle horizontal/min_angle horizontal/samples
    logical_camera/aspect_ratio logical_camera/far logical_camera/horizontal_fov logical_camera/near
    population/model road/point sonar/max sonar/min sonar/radius spot/outer_angle
    spherical_coordinates/latitude_deg spherical_coordinates/longitude_deg
    texture/size trajectory/waypoint vertical/max_angle vertical/min_angle vertical/samples
    waypoint/pose waypoint/time
    """.split()
)
"""Required children that make another robot when they are left out, or nothing sensible at all.

libsdformat fills in every required child but the ends of a joint, and says nothing. For
most (the atmosphere of a world, the step of a physics) the default is what an author who
leaves them out expects. Where that depends on something else, ``structure`` decides.
"""


class AttributeDefinition(RowInVersion):
    """An attribute, as one version allows it at one place."""

    __slots__ = ("default", "required", "type")
    type: str
    default: str
    required: bool

    def __init__(self, version: Version, row: Row, place: str) -> None:
        minor = version.minor
        self.row = row
        self.version = version
        self.name = row.name[1:]
        self.place = f"{place}/{row.name}"
        self.type = at(row.type, minor)
        self.default = at(row.default, minor)
        self.required = at(row.multiplicity, minor) == "1"

    def __repr__(self) -> str:
        return f"AttributeDefinition({self.place!r}, {self.version})"

    @property
    def needs_value(self) -> bool:
        """Whether an empty text is refused."""
        return self.required


class Definition(RowInVersion):
    """An element, as one version allows it below one kind of parent.

    ``multiplicity`` (``0``, ``1``, ``+``, ``*``, or ``-1`` for deprecated) is the one written where
    the element is used; libsdformat uses ``own_multiplicity``, that of the definition.
    """

    __slots__ = (
        "_schema",
        "attributes",
        "children",
        "default",
        "deprecated",
        "multiplicity",
        "needed_children",
        "open",
        "own_multiplicity",
        "path",
        "required_attributes",
        "required_children",
        "single",
        "sound",
        "type",
    )
    path: str
    """The names from the element that starts the definition: ``joint/axis/limit/lower``."""
    type: str | None
    """None for an element that holds elements."""
    default: str | None
    deprecated: bool
    open: bool
    """Content is free: nothing inside is the format's business."""
    single: bool
    """At most one below a parent."""
    sound: set[str | None]
    """Texts that ``accepts`` has accepted, remembered by those who walk over documents."""
    attributes: dict[str, AttributeDefinition]
    children: dict[str, Definition]
    required_attributes: tuple[str, ...]
    required_children: tuple[str, ...]
    needed_children: tuple[str, ...]
    """Those of the required children whose silent default makes another robot."""

    def __init__(self, parent: Definition | None, schema: Schema, row: Row, use: Row) -> None:
        minor = schema.version.minor
        self._schema = schema
        self.row = row
        self.version = schema.version
        if row is use and parent is not None:
            self.path = f"{parent.path}/{row.name}"
            self.place = f"{parent.place}/{row.name}"
            self.name = row.name
        else:
            self.path = at(row.extra("name"), minor) or row.name
            self.place = f"{row.name}:{newest_name(row)}"
            self.name = use.name if parent is not None else self.path
        self.type = at(row.type, minor) or None
        self.default = at(row.default, minor) if self.type else None
        self.multiplicity = at(use.multiplicity, minor)
        self.own_multiplicity = (use.extras and at(use.extra("own"), minor)) or self.multiplicity
        self.single = self.multiplicity not in {"*", "+"}
        self.sound = set()
        self.deprecated = row.extras != [] and at(row.extra("deprecated"), minor) != ""
        self.open = row.extras != [] and row.extra("open") != ""

    def __repr__(self) -> str:
        return f"Definition({self.place!r}, {self.version})"

    @property
    def needs_value(self) -> bool:
        """Whether an empty text is refused; elsewhere it means the default."""
        return self.type is not None and self.own_multiplicity == "1"

    def _unfold(self) -> None:
        schema, minor = self._schema, self.version.minor
        self.children = children = {}
        self.attributes = attributes = {}
        for row in self.row.rows:
            if not row.lives(minor):
                continue
            if row.name[0] == "@":
                attributes[row.name[1:]] = AttributeDefinition(self.version, row, self.place)
            else:
                children[row.name] = schema.define(self, row)
        self.required_children = tuple(
            name for name, child in children.items() if child.multiplicity in {"1", "+"}
        )
        self.required_attributes = tuple(name for name, attribute in attributes.items() if attribute.required)
        self.needed_children = tuple(
            name
            for name in self.required_children
            if children[name].default == NOT_GIVEN or f"{self.name}/{name}" in _NEEDED
        )

    if not TYPE_CHECKING:

        def __getattr__(self, name: str) -> Any:
            if name not in _UNFOLDED:
                return super().__getattr__(name)
            self._unfold()
            return object.__getattribute__(self, name)


_UNFOLDED = {"attributes", "children", "needed_children", "required_attributes", "required_children"}


class Schema:
    """The format in one version."""

    __slots__ = ("_uses", "root", "version")

    def __init__(self, version: Version) -> None:
        self.version = version
        self._uses: dict[tuple[str, str, str, str], Definition] = {}
        self.root = Definition(None, self, block("root"), block("root"))
        """The element ``sdf``."""

    def __repr__(self) -> str:
        return f"Schema({self.version})"

    def define(self, parent: Definition, row: Row) -> Definition:
        """The definition of a child; one object for all uses that say the same."""
        if not row.type.startswith("^"):
            return Definition(parent, self, row, row)
        minor = self.version.minor
        key = (row.type, row.name, at(row.multiplicity, minor), at(row.extra("own"), minor))
        if key not in self._uses:
            self._uses[key] = Definition(parent, self, block(row.type[1:]), row)
        return self._uses[key]

    def at(self, place: str) -> Definition | None:
        """The definition at a place such as ``joint:joint/axis``, or None; as a part of no special parent."""
        stem, _, path = place.partition(":")
        top = block(stem)
        if not top.lives(self.version.minor):
            return None
        key = (stem, "", "", "")
        if key not in self._uses:
            self._uses[key] = Definition(None, self, top, top)
        found: Definition | None = self._uses[key]
        for name in path.split("/")[1:]:
            found = found and found.children.get(name)
        return found


@cache
def schema(version: Version) -> Schema:
    """The format in a version, built once a process."""
    return Schema(version)

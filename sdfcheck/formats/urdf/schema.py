"""URDF: what it allows where, and what its consumers make of it.

There is no official schema: the table (``data/urdf.txt``) holds the elements that urdfdom reads,
and in addition those of libsdformat, Drake, PyBullet and MuJoCo.
"""

from __future__ import annotations

from collections.abc import Mapping
from functools import cache, lru_cache
from math import inf
from typing import TYPE_CHECKING, cast

from sdfcheck.formats.schema import Accepts, Definition, Format, RowInVersion
from sdfcheck.formats.table import Range, Table
from sdfcheck.formats.version import Version
from sdfcheck.source.record import NamedTuple

if TYPE_CHECKING:
    from sdfcheck.source.document import Document, Element

VERSIONS = (Version(1, 0), Version(1, 1), Version(1, 2))
"""The versions of URDF; a document without one has the first."""

CONTROL = "ros2_control"

TRUE = frozenset(("1", "true", "yes"))
"""The words for true in ``<gazebo>``."""
_FLAGS = frozenset(("", "0", "false", "no", *TRUE))
"""The words for true and false in ``<gazebo>``; everything else is false as well."""
COUNTS = {"double": 1, "vector3": 3, "color": 4, "quaternion": 4}
"""How many numbers a text of a type holds."""
_REMEMBERED = 1000
"""So many texts are kept for each attribute: most robots repeat themselves."""


def acceptance(place: RowInVersion) -> Accepts:
    """A quick check. Unlike in SDFormat, a number must not be followed by spaces."""
    if place.listed:
        return frozenset(place.listed).__contains__
    if place.needs_value and place.type == "string":
        return str.strip
    if place.type == "flag":
        return _is_flag
    count = COUNTS.get(place.type or "")
    if count is None:
        return str.isdecimal if place.type in {"int", "unsigned int"} else _anything
    return lru_cache(_REMEMBERED)(_numbers(count, place.range))


def _numbers(count: int, bounds: Range | None) -> Accepts:
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


def is_needed(parent: Definition, child: Definition) -> bool:
    """Each required child is."""
    return True


URDF = Format(Table("urdf"), "robot", VERSIONS, acceptance, is_needed)


def urdf(version: Version = VERSIONS[-1]) -> Definition:
    """The element ``robot``, with everything in it."""
    return URDF.schema(version).root


def extension() -> Definition:
    """The element ``gazebo``, with the settings in it that libsdformat translates."""
    return urdf().children["gazebo"]


@cache
def control() -> Definition:
    """The element ``ros2_control``, with what ros2_control reads of it."""
    return cast("Definition", URDF.schema(URDF.newest).at(f"control:{CONTROL}"))


@cache
def of_controllers() -> Mapping[str, Definition]:
    """The elements of a robot whose content URDF leaves to those who control it, as these read them."""
    drive = cast("Definition", URDF.schema(URDF.newest).at("drive:transmission"))
    return {CONTROL: control(), drive.name: drive}


class Setting(NamedTuple):
    """A setting in ``<gazebo>`` that libsdformat translates."""

    type: str | None
    about: str
    """The subject of its block (link, joint or robot); empty: nobody reads it."""
    counterparts: tuple[tuple[str, ...], ...]
    """The paths at which SDFormat has it in the link or joint."""
    negated: bool
    """Of a flag: does SDFormat say the contrary?"""

    def translated(self, text: str) -> str:
        """The text as SDFormat writes it: libsdformat takes each flag that is not true for false."""
        if self.type != "flag":
            return text
        return str((text.strip().lower() in TRUE) is not self.negated).lower()


@cache
def all_settings() -> dict[str, Setting]:
    """The settings in ``<gazebo>`` by their names."""
    found = {}
    for name, setting in extension().children.items():
        paths = setting.row.extra("sdf")
        counterparts = tuple(tuple(path.split("/")) for path in paths.lstrip("!").split(",") if path)
        about = setting.row.extra("at")
        found[name] = Setting(setting.type, about, counterparts, negated=paths.startswith("!"))
    return found


@cache
def settings(about: str) -> dict[str, Setting]:
    """Those that SDFormat has a place for, of blocks about a ``link`` or a ``joint``."""
    return {name: one for name, one in all_settings().items() if one.about == about and one.counterparts}


@lru_cache(maxsize=1000)
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


def definition(element: Element) -> Definition | None:
    """The definition of an element by its place in the document; None where URDF has no such element.

    In a macro of xacro it is that of the first place where such an element may be.
    """
    path: list[str] = []
    at: Element | None = element
    while (
        at is not None and not at.name.startswith("xacro:") and (at.name != "robot" or at.parent is not None)
    ):
        path.append(at.name)
        at = at.parent
    steps = "/".join(reversed(path))
    found = urdf().at(steps)
    if found is None and at is not None and at.name != "robot":
        found = next(filter(None, (place.at(steps) for place in _places())), None)
    return found


@cache
def _places() -> tuple[Definition, ...]:
    """All definitions, from the outside in."""
    places = [urdf()]
    for place in places:
        places += place.children.values()
    return tuple(places)


def has_known_names(element: Element) -> bool:
    """Does its place have all attributes and children of an element? In nearly all robots it has."""
    known = element.document.view(_known)
    if element not in known:
        place = definition(element)
        known[element] = place is None or (
            element.attributes.keys() <= place.attributes.keys()
            and all(child.name in place.children for child in element.children())
        )
    return known[element]


def _known(document: Document) -> dict[Element, bool]:
    """The answers so far: a robot is asked for each of its parts."""
    return {}

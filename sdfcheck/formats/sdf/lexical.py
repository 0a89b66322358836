"""How values may be written, in the terms that schema languages share: patterns, words, bounds.

They let pass what consumers take as written. Conditions that the schema languages cannot express (a
quaternion's length, infinity only here and there) are left to the linter.
"""

from __future__ import annotations

from collections.abc import Iterator
from math import inf

from sdfcheck.formats.history import in_version
from sdfcheck.formats.schema import AttributeDefinition, Definition, Schema
from sdfcheck.formats.sdf.schema import schema
from sdfcheck.formats.table import Range
from sdfcheck.formats.version import NEWEST
from sdfcheck.source.record import NamedTuple

_NUMBER = r"[+\-]?([0-9]+\.?[0-9]*|\.[0-9]+)([eE][+\-]?[0-9]+)?"
_INFINITE = r"[+\-]?[iI][nN][fF]([iI][nN][iI][tT][yY])?"
_WHOLE = r"[+\-]?[0-9]+(\.0*)?"
_HEXADECIMAL = "0[xX][0-9a-fA-F]+"
_PATTERNS = {
    "bool": "[tT][rR][uU][eE]|[fF][aA][lL][sS][eE]|1|0",
    "char": ".",
    "double": _NUMBER,
    "float": _NUMBER,
    "int": _WHOLE,
    "unsigned int": r"\+?[0-9]+(\.0*)?",
}
_PARTS = {
    "color": (_NUMBER, "{2,3}"),
    "pose": (_NUMBER, "{5,6}"),
    "quaternion": (_NUMBER, "{2,3}"),
    "time": (_WHOLE, "{1}"),
    "vector2d": (_NUMBER, "{1}"),
    "vector2i": (_WHOLE, "{1}"),
    "vector3": (_NUMBER, "{2}"),
}
_NUMBERS = frozenset(("double", "float", "int", "unsigned int"))


class Form(NamedTuple):
    """The texts of one place: those of any of its parts."""

    patterns: tuple[str, ...] = ()
    """Regular expressions as XML Schema writes them."""
    words: tuple[str, ...] = ()
    bounds: Range | None = None
    """A number in this range."""
    empty: bool = True
    """An empty text, which means the default."""

    @property
    def is_free(self) -> bool:
        """Any text at all, though maybe none that is empty."""
        return not self.patterns and not self.words and self.bounds is None


def form(place: Definition | AttributeDefinition) -> Form:
    """The form of an element's text or an attribute's value."""
    needed = place.needs_value if isinstance(place, Definition) else place.required
    kind = place.type or "string"
    if place.place == "root:sdf/@version":
        return Form(words=(str(place.version),), empty=False)
    if place.choices is not None:
        return _words(place, needed)
    if kind in _PARTS:
        part, more = _PARTS[kind]
        return Form((_padded(rf"({part})(\s+({part})){more}"),), empty=not needed)
    if kind not in _PATTERNS:
        return Form(empty=not needed)
    others = (_HEXADECIMAL,) if kind in {"int", "unsigned int"} else ()
    if place.may_be_infinite and kind in {"double", "float"}:
        others = (_INFINITE,)
    if place.range is not None and kind in _NUMBERS:
        return Form(tuple(map(_padded, others)), bounds=place.range, empty=not needed)
    return Form(tuple(map(_padded, (_PATTERNS[kind], *others))), empty=not needed)


def _padded(pattern: str) -> str:
    """With spaces around: not all validators take them away."""
    return rf"\s*({pattern})\s*"


def _words(place: Definition | AttributeDefinition, needed: bool) -> Form:
    choices = place.choices
    assert choices is not None
    words = {*choices.listed, *choices.library, *choices.aliases, *_later(place)}
    if place.default and place.default != "__default__":
        words.add(place.default)
    listed = tuple(sorted(words - {""}))
    if choices.ignores_case:
        return Form(tuple(_padded(_any_case(word)) for word in listed), empty=not needed)
    return Form(words=listed, empty=not needed)


def _later(place: Definition | AttributeDefinition) -> tuple[str, ...]:
    """Values that newer versions list: consumers take them in older documents as well."""
    if isinstance(place, Definition):
        newer = in_version(place, NEWEST)
        return newer.choices.listed if newer is not None and newer.choices else ()
    stem, _, name = place.place.rpartition("/@")
    owner = schema(NEWEST).at(stem)
    attribute = owner.attributes.get(name) if owner is not None else None
    return attribute.choices.listed if attribute is not None and attribute.choices else ()


def _any_case(word: str) -> str:
    return "".join(f"[{letter.lower()}{letter.upper()}]" if letter.isalpha() else letter for letter in word)


def definitions(format: Schema) -> dict[str, Definition]:
    """Every kind of element of a version, under a name that is its own; sorted by that name."""
    found: dict[str, Definition] = {}
    waiting = [format.root]
    while waiting:
        definition = waiting.pop()
        key = name_of(definition)
        if key not in found:
            found[key] = definition
            waiting += definition.children.values()
    return dict(sorted(found.items()))


def name_of(definition: Definition) -> str:
    """``joint.axis.limit`` for what is at ``joint:joint/axis/limit``."""
    stem, _, path = definition.place.partition(":")
    _, *inner = path.split("/")
    required = ".required" if definition.needs_value and inner == [] else ""
    return ".".join((stem, *inner)) + required


def facets(bounds: Range) -> Iterator[tuple[str, str]]:
    """A range as the facets of XML Schema."""
    if bounds.low > -inf:
        yield ("minExclusive" if bounds.low_open else "minInclusive"), f"{bounds.low:.16g}"
    if bounds.high < inf:
        yield ("maxExclusive" if bounds.high_open else "maxInclusive"), f"{bounds.high:.16g}"


def documentation(place: Definition | AttributeDefinition) -> str:
    """Notes that a schema cannot check and an editor may show: default, unit, deprecation."""
    from sdfcheck.formats import history

    parts = []
    if place.default and place.default != "__default__":
        parts.append(f"default: {place.default}")
    if isinstance(place, Definition):
        if place.units:
            parts.append(f"unit: {place.units[0]}")
        if place.deprecated:
            successor = history.deprecation(place).successor
            parts.append("deprecated" + (f", use {successor}" if successor else ""))
    return "; ".join(parts)


def escaped(text: str) -> str:
    """A text as XML writes it."""
    return text.replace("&", "&amp;").replace("<", "&lt;").replace('"', "&quot;")

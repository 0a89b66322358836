"""Start tags, their attributes, and the names that XML allows."""

from __future__ import annotations

import re
from functools import cache
from itertools import islice

from sdfcheck.source.decode import ATTRIBUTE_LIMIT
from sdfcheck.source.problems import Problem, RepeatedAttribute
from sdfcheck.source.record import NamedTuple
from sdfcheck.source.text import Source

# Names as XML 1.0 defines them, to the letter.


_PLAIN = re.compile(r"[A-Za-z_:][A-Za-z0-9_:.\-]*")
_INITIAL = (
    r":A-Z_a-z\xc0-\xd6\xd8-\xf6\xf8-\u02ff\u0370-\u037d\u037f-\u1fff\u200c\u200d\u2070-\u218f"
    r"\u2c00-\u2fef\u3001-\ud7ff\uf900-\ufdcf\ufdf0-\ufffd\U00010000-\U000effff"
)
_FURTHER = rf"{_INITIAL}\-.0-9\xb7\u0300-\u036f\u203f\u2040"


def is_name(text: str) -> bool:
    """Is this a name for XML?"""
    return (_PLAIN if text.isascii() else _any_letters()).fullmatch(text) is not None


def made_name(text: str) -> str:
    """The nearest thing that is a name."""
    made = text if is_name(text) else re.sub(rf"[^{_FURTHER}]", "_", text)
    return made if is_name(made) else f"_{made}"


@cache
def _any_letters() -> re.Pattern[str]:
    """Compiled when needed: it takes 10 ms."""
    return re.compile(rf"[{_INITIAL}][{_FURTHER}]*")


# Start tags and their attributes.


BLANK = r"[ \t\r\n]"
# Not quite XML's: those that differ are not ASCII, and compiling XML's own takes 10 ms.
NAME = r"(?:[^\W\d]|:)[\w.\-:]*"
ATTRIBUTES = rf"""(?:{BLANK}+{NAME}{BLANK}*={BLANK}*(?:"[^"<]*"|'[^'<]*'))*"""
START = re.compile(rf"""<({NAME})({ATTRIBUTES}){BLANK}*(/?)>""")
"""A well-formed start tag: name, attributes, slash."""

BARE_START = re.compile(rf"""(?<![\w.\-:</])({NAME})({ATTRIBUTES}){BLANK}*(/?)>""")
"""The same without its ``<``."""

_ATTRIBUTE = re.compile(rf"""{BLANK}+({NAME}){BLANK}*={BLANK}*(?:"([^"<]*)"|'([^'<]*)')""")


class AttributePlace(NamedTuple):
    """Offsets of an attribute's name and of its value (inside the quotes)."""

    name: str
    name_start: int
    name_end: int
    value_start: int
    value_end: int


class StartTag(NamedTuple):
    """A start tag, parsed: ``end`` is after its ``>``."""

    name: str
    name_start: int
    name_end: int
    attributes: tuple[AttributePlace, ...]
    end: int
    empty: bool


def has_names(match: re.Match[str]) -> bool:
    """Are the names in a start tag such as XML allows, letters of all the world included?"""
    if match[0].isascii():
        return True

    tag = tag_of(match)
    return is_name(tag.name) and all(is_name(attribute.name) for attribute in tag.attributes)


def tag_of(match: re.Match[str]) -> StartTag:
    """The start tag that :data:`START` or :data:`BARE_START` matched, with one attribute past the limit at most."""
    attributes = []
    for found in islice(_ATTRIBUTE.finditer(match.string, match.end(1), match.end(2)), ATTRIBUTE_LIMIT + 1):
        group = 2 if found[2] is not None else 3
        attributes.append(
            AttributePlace(found[1], found.start(1), found.end(1), found.start(group), found.end(group))
        )
    return StartTag(match[1], match.start(1), match.end(1), tuple(attributes), match.end(), bool(match[3]))


def repeated_attributes(source: Source, tag: StartTag) -> list[Problem]:
    """Attributes given twice; doubled prefix declarations belong to the namespace analysis."""
    if len(tag.attributes) < 2:
        return []
    first: dict[str, AttributePlace] = {}
    problems: list[Problem] = []
    for attribute in tag.attributes:
        earlier = first.setdefault(attribute.name, attribute)
        if earlier is not attribute and attribute.name.partition(":")[0] != "xmlns":
            problems.append(
                RepeatedAttribute(
                    source.span(attribute.name_start, attribute.name_end),
                    source.span(earlier.name_start, earlier.name_end),
                )
            )
    return problems

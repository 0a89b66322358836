"""Start tags and their attributes."""

from __future__ import annotations

import re
from itertools import islice

from sdfcheck.source.limits import ATTRIBUTE_LIMIT
from sdfcheck.source.problems import Problem, RepeatedAttribute
from sdfcheck.source.record import NamedTuple
from sdfcheck.source.text import Source

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
    from sdfcheck.source.scanner.xml_names import is_name

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

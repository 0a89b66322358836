"""The facts about a place, as Markdown."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from pathlib import Path

from sdfcheck.formats.describe.description import HOW_OFTEN, Description
from sdfcheck.formats.describe.spot import Spot, describe_custom, spot
from sdfcheck.formats.describe.summary import summary
from sdfcheck.formats.sdf.version import NEWEST, Version
from sdfcheck.lint.diagnostic import Diagnostic
from sdfcheck.lsp.cursor import Cursor, at
from sdfcheck.lsp.facts import of_symbol
from sdfcheck.lsp.names.index import occurrences
from sdfcheck.lsp.outline import target_of
from sdfcheck.source.document import Document
from sdfcheck.source.element import Element
from sdfcheck.source.record import NamedTuple
from sdfcheck.source.sniff import Kind
from sdfcheck.source.text import Span

_MOST_CHOICES = 12


class Hover(NamedTuple):
    """A text about a place, in Markdown."""

    text: str
    span: Span


def hover(document: Document, offset: int, found: Sequence[Diagnostic] = ()) -> Hover | None:
    """The facts about a place; ``found`` are the diagnostics of the document."""
    cursor = at(document, offset)
    if cursor is None:
        return None
    sections: list[str] = []
    named = occurrences(document).at(offset)
    span = cursor.span
    if named is not None:
        sections.append("\n\n".join(of_symbol(document, named)))
        span = named.span
    elif cursor.value is not None and (target := target_of(document, cursor.value)) is not None:
        sections.append(f"`{target}`" + _size(target))
    description = describe_at(document, cursor)
    if description is not None:
        sections.append("\n\n".join(_described(description)))
    reactions = list(_reactions(cursor.span, found))
    if reactions:
        sections.append("\n".join(reactions))
    return Hover("\n\n---\n\n".join(filter(None, sections)), span) if any(sections) else None


def _size(path: Path) -> str:
    try:
        size = path.stat().st_size
    except OSError:
        return ""
    return "" if path.is_dir() else f" ({size / 1024:.1f} kB)"


def names_around(element: Element) -> list[str]:
    """The names of the elements that lead to one, from the root's to its own."""
    names = [element.name]
    while (parent := element.parent) is not None:
        element = parent
        names.append(element.name)
    return names[::-1]


def version_of(document: Document) -> Version:
    """The version of SDFormat as which a document is read."""
    return Version.parse(document.version or "") or NEWEST


def spot_of(element: Element) -> Spot | None:
    """The definition at the place of an element; of one that came or went, another version's."""
    names = names_around(element)
    found = spot(names, version_of(element.document))
    return found if found is not None else spot(names)


def describe_at(document: Document, cursor: Cursor) -> Description | None:
    """The definition of the element or attribute at a place."""
    element, attribute = cursor.element, cursor.attribute
    is_urdf = document.kind is not Kind.SDF
    names = names_around(element)
    if attribute and ":" in attribute and not attribute.startswith("xmlns"):
        return describe_custom(f"@{attribute}", names, is_urdf=is_urdf)
    if ":" in element.name:
        if element.name.startswith("xacro:"):
            return None
        if attribute:
            return describe_custom(f"{element.name}/@{attribute}", names[:-1], is_urdf=is_urdf)
        return describe_custom(element.name, names[:-1], is_urdf=is_urdf)
    if is_urdf and "ros2_control" in names:
        return _of_control(names, attribute)
    place = spot_of(element)
    return None if place is None else place.describe(attribute)


def _of_control(names: list[str], attribute: str) -> Description | None:
    """The facts about a place in a ``ros2_control`` block."""
    inner = names[names.index("ros2_control") :] + ([f"@{attribute}"] if attribute else [])
    text = summary("ros2_control", inner)
    what = "attribute" if attribute else "element"
    return Description("/".join(inner), "ros2_control", what, summary=text) if text else None


def _described(one: Description) -> Iterator[str]:
    nature = f"deprecated {one.what}" if one.deprecated else one.what
    yield f"**`{one.name}`** · {one.format} {nature}"
    if one.summary:
        yield one.summary
    facts = [
        f"`{one.type}`" if one.type else "",
        f"in {one.unit}" if one.unit else "",
        f"default `{one.default}`" if one.default else "",
        f"range {one.range}" if one.range else "",
        _often(one),
        f"since {one.since}" if one.since else "",
        f"until {one.until}" if one.until else "",
    ]
    if line := ", ".join(filter(None, facts)):
        yield line
    if one.choices:
        shown = ", ".join(f"`{choice}`" for choice in one.choices[:_MOST_CHOICES])
        yield f"one of {shown}" + (", …" if len(one.choices) > _MOST_CHOICES else "")
    if one.successor:
        yield f"use `{one.successor}` instead"
    yield from one.notes


def _often(one: Description) -> str:
    if len(one.parents) != 1:
        return ""
    often = one.parents[0].multiplicity
    if one.what == "attribute":
        return "required" if often == "1" else "optional"
    return HOW_OFTEN.get(often, "")


def _reactions(span: Span, found: Sequence[Diagnostic]) -> Iterator[str]:
    """The reaction of each consumer to the defects here."""
    known = dict.fromkeys(
        (consumer, reaction.words)
        for diagnostic in found
        if diagnostic.span.start <= span.end and span.start <= diagnostic.span.end
        for consumer, reaction in diagnostic.affects
    )
    for consumer, words in known:
        yield f"- {consumer}: {words}"

"""The facts about a place, as Markdown."""

from __future__ import annotations

import os
from collections.abc import Iterator, Sequence
from pathlib import Path

from sdfcheck.formats import plugins
from sdfcheck.formats.describe import HOW_OFTEN, Description, Spot, describe_custom, spot, summary
from sdfcheck.formats.vendor import known_tables
from sdfcheck.formats.version import NEWEST, Version
from sdfcheck.lint.diagnostic import Diagnostic
from sdfcheck.lsp.completion.likely import plain
from sdfcheck.lsp.cursor import Cursor, at
from sdfcheck.lsp.evaluated import expression_at, values
from sdfcheck.lsp.facts import of_symbol
from sdfcheck.lsp.names.index import is_made, occurrences
from sdfcheck.lsp.outline import target_of
from sdfcheck.lsp.workspace import Workspace
from sdfcheck.source.document import Document, Element
from sdfcheck.source.record import NamedTuple
from sdfcheck.source.sniff import Kind
from sdfcheck.source.text import Span
from sdfcheck.xacro.language import KEYWORDS, PREFIX

_MOST_CHOICES = 12
_FORMATS = {"srdf": "SRDF"}


class Hover(NamedTuple):
    """A text about a place, in Markdown."""

    text: str
    span: Span


def hover(
    document: Document, offset: int, found: Sequence[Diagnostic] = (), workspace: Workspace | None = None
) -> Hover | None:
    """The facts about a place; ``found`` are the diagnostics of the document, and a workspace has its expansions."""
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
    if workspace is not None and is_made(document):
        sections += _values(workspace, document, cursor, offset)
    description = describe_at(document, cursor)
    if description is not None:
        sections.append("\n\n".join(_described(description)))
    reactions = list(_reactions(cursor.span, found))
    if reactions:
        sections.append("\n".join(reactions))
    return Hover("\n\n---\n\n".join(filter(None, sections)), span) if any(sections) else None


def _values(workspace: Workspace, document: Document, cursor: Cursor, offset: int) -> Iterator[str]:
    """The values of the expression at a place, and of a whole name with expressions."""
    expression = expression_at(cursor, offset)
    places = [cursor.span] if expression is None and "$" in cursor.span.text else [expression]
    for place in places:
        if place is None or cursor.value is None:
            continue
        whole = cursor.span if place == cursor.span else place
        known = values(workspace, document, cursor, whole)
        if known:
            shown = ", ".join(f"`{value}`" for value in known)
            yield f"`{whole.text}` is {shown}"


def _size(path: Path) -> str:
    try:
        size = path.stat().st_size
    except OSError:
        return ""
    return "" if os.path.isdir(path) else f" ({size / 1024:.1f} kB)"


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
    names = list(plain(names_around(element)))
    if names[-1:] != [element.name]:
        names.append(element.name)
    if element.name.startswith(PREFIX):
        own = element.name[len(PREFIX) :]
        return _in_words("xacro", [own], attribute) if own in KEYWORDS else None
    if document.kind is Kind.SRDF:
        return _in_words("srdf", names, attribute)
    is_urdf, tables = names[0] == "robot", known_tables(document.library)
    if attribute and ":" in attribute and not attribute.startswith("xmlns"):
        return describe_custom(f"@{attribute}", names, tables, is_urdf=is_urdf)
    if ":" in element.name:
        name = f"{element.name}/@{attribute}" if attribute else element.name
        return describe_custom(name, names[:-1], tables, is_urdf=is_urdf)
    if is_urdf and "ros2_control" in names:
        return _in_words("ros2_control", names[names.index("ros2_control") :], attribute)
    if "plugin" in names[:-1]:
        return _of_plugin(element, names)
    place = spot_of(element)
    return None if place is None else place.describe(attribute)


def _in_words(dialect: str, names: list[str], attribute: str) -> Description | None:
    """The facts about a place that the descriptions alone know."""
    inner = [*names, *([f"@{attribute}"] if attribute else [])]
    text = summary(dialect, inner)
    what = "attribute" if attribute else "element"
    return Description("/".join(inner), _FORMATS.get(dialect, dialect), what, summary=text) if text else None


def _of_plugin(element: Element, names: list[str]) -> Description | None:
    """A parameter of one of Gazebo's plugins."""
    plugin = next((each for each in element.around if each.name == "plugin"), None)
    path = "/".join(names[len(names) - names[::-1].index("plugin") :])
    for facts in () if plugin is None else plugins.known(plugin.attributes.get("filename", "")):
        if path not in facts.parameters and not any(path == naming.path for naming in facts.namings):
            continue
        naming = next((each for each in facts.namings if each.path == path), None)
        text = f"A parameter of `{facts.file}` ({facts.generation})."
        if naming is not None:
            text += f" It names a {naming.kind}" + (" by its scoped name." if naming.is_scoped else ".")
        if path in facts.required:
            text += " The plugin does not run without it."
        return Description(path, facts.generation, "parameter", summary=text)
    return None


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

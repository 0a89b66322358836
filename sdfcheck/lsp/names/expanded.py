"""The names of the robots that xacro files make: for each place where one is written, all that it expands to."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Mapping

from sdfcheck.files.library import library_of
from sdfcheck.lsp.workspace import LiveExpander, Workspace
from sdfcheck.robot.naming.occurrences import Occurrence, robot_names
from sdfcheck.robot.semantics import Assistants, semantic_names, semantics_in
from sdfcheck.source.document import Document
from sdfcheck.source.record import NamedTuple
from sdfcheck.source.sniff import HEAD, Kind, sniff
from sdfcheck.source.text import Span
from sdfcheck.xacro.expansion import Expansion
from sdfcheck.xacro.language import matches
from sdfcheck.xacro.static.definitions import is_robot, visible_definitions
from sdfcheck.xacro.static.project import includers

MOST_ROOTS = 4
"""Of the robots that include a file, so many are expanded."""
MOST_ASSISTANTS = 2
"""A robot is expanded as so many packages for MoveIt do."""
MOST_SWITCHES = 4
"""So many arguments that are true or false by default are also tried the other way round."""

_SWITCHES = {"true": "false", "false": "true", "True": "False", "False": "True", "1": "0", "0": "1"}

Place = tuple[str, int, int]
"""Real path, start, end."""
Key = tuple[str, str]
"""Kind and name."""


def place_of(span: Span) -> Place:
    """The identity of a place, the same however often its file is read."""
    return span.source.real_path, span.start, span.end


class Expanded:
    """One expansion of one file: the places that name parts of the robot, and the names that they expand to."""

    def __init__(
        self, root: Document, arguments: Mapping[str, str], document: Document, *, is_partial: bool = False
    ) -> None:
        self.root = root
        self.arguments = arguments
        self.document = document
        self.is_partial = is_partial
        self.name = "" if document.root is None else document.root.attributes.get("name", "").strip()
        """The name of the robot."""
        self.all = tuple(rows_of(document))
        self.by_place: dict[Place, list[Occurrence]] = {}
        self.by_name: dict[Key, list[Occurrence]] = {}
        for each in self.all:
            self.by_place.setdefault(place_of(each.span), []).append(each)
            self.by_name.setdefault((each.symbol.kind, each.symbol.name), []).append(each)


def rows_of(document: Document) -> Iterator[Occurrence]:
    """The places that name parts of the robot in a document without expressions."""
    if document.root is None:
        return
    if document.kind is Kind.SRDF:
        for semantics in semantics_in(document):
            yield from semantic_names(semantics)
    else:
        yield from robot_names(document)


def plain(document: Document) -> Expanded:
    """A document that is not expanded, in the same form."""
    return document.view(_plain)


def _plain(document: Document) -> Expanded:
    return Expanded(document, {}, document)


def total(occurrence: Occurrence) -> str:
    """All that a place expands to, of which the name may be a part."""
    return f"{occurrence.before}{occurrence.symbol.name}{occurrence.after}"


class Piece(NamedTuple):
    """A piece of a text with expressions: its range there, and in what the text expands to."""

    is_literal: bool
    start: int
    end: int
    first: int
    last: int


def pieces(text: str, value: str | None = None) -> list[Piece]:
    """The literal pieces and the expressions of a text, beside the value that it expands to.

    Without a value their places in it are -1; empty where the text cannot expand to the value.
    """
    bounds: list[tuple[bool, int, int]] = []
    at = 0
    for match in matches(text):
        bounds += [(True, at, match.start()), (False, match.start(), match.end())]
        at = match.end()
    bounds.append((True, at, len(text)))
    bounds = [each for each in bounds if not each[0] or each[1] < each[2]]
    if value is None:
        return [Piece(*each, -1, -1) for each in bounds]
    pattern = "".join(f"({re.escape(text[start:end])})" if own else "(.*?)" for own, start, end in bounds)
    found = re.fullmatch(pattern, value, re.DOTALL)
    if found is None:
        return []
    return [Piece(*each, *found.span(n + 1)) for n, each in enumerate(bounds)]


def roots_of(document: Document) -> list[Document]:
    """The files that are expanded as robots and contain a document: itself, or those that include it."""
    library = library_of(document)
    found = [document] if is_robot(document) else []
    seen = {document.source.real_path}
    waiting: list[Document | None] = [document]
    while waiting and len(found) < MOST_ROOTS and library is not None:
        one = waiting.pop(0)
        for path in [] if one is None else includers(one):
            key = library.disk.real(path)
            if key not in seen:
                seen.add(key)
                other = library.document(path, Kind.XACRO)
                waiting.append(other)
                if other is not None and is_robot(other):
                    found.append(other)
    return found[:MOST_ROOTS]


def expansions(
    workspace: Workspace,
    roots: Iterable[Document],
    *,
    only_known: bool = False,
    turned: bool = True,
    lately: bool = False,
) -> list[Expanded]:
    """The expansions of files as they are configured, and with their switches ``turned``.

    ``only_known``: only those that need no work, for answers that cannot wait; ``lately``: those of earlier texts do.
    """
    found = []
    for root in roots:
        settings = workspace.settings_for(root.path)
        expander, sets = workspace.caches.xacro(settings, root.path)
        if not isinstance(expander, LiveExpander):
            continue
        wanted = [dict(each) for each in sets] or _usual_sets(root)
        if turned and not only_known:
            wanted += [{**wanted[0], **switch} for switch in _switches(root)]
        for arguments in wanted:
            earlier = expander.lately(root, arguments) if lately else None
            own = _expanded(expander, root, arguments, only_known=only_known, made=earlier)
            if own is not None:
                found.append(own)
    return found


def _usual_sets(root: Document) -> list[dict[str, str]]:
    """The arguments with which the project's packages for MoveIt expand a robot, and none."""
    library = library_of(root)
    assistants = None if library is None else library.of_project(root.path, Assistants)
    return [*(assistants.arguments(root.path)[:MOST_ASSISTANTS] if assistants is not None else ()), {}]


def _switches(root: Document) -> list[dict[str, str]]:
    """Each argument that is true or false by default, turned."""
    found: dict[str, str] = {}
    for read in visible_definitions(root).readings:
        for name, default in read.arguments.items():
            if default.strip() in _SWITCHES:
                found.setdefault(name, _SWITCHES[default.strip()])
    return [{name: value} for name, value in list(found.items())[:MOST_SWITCHES]]


def _expanded(
    expander: LiveExpander,
    root: Document,
    arguments: Mapping[str, str],
    *,
    only_known: bool,
    made: Expansion | None = None,
) -> Expanded | None:
    ask = expander.known if only_known else expander.expand
    made, is_partial = made or ask(root, arguments), False
    if made is not None and made.document is None:
        is_partial = True
        made = (
            expander.known(root, arguments, is_partial=True)
            if only_known
            else expander.expand_partly(root, arguments)
        )
    document = None if made is None else made.document
    if document is None or document.root is None:
        return None
    if sniff(document.source.text[:HEAD].encode("utf-8", "replace"), root.path) is Kind.SRDF:
        document.kind = Kind.SRDF
    document.library = root.library
    key = tuple(sorted(arguments.items()))
    known: dict[object, Expanded] = document.view(_no_rows)
    if key not in known:
        known[key] = Expanded(root, arguments, document, is_partial=is_partial)
    return known[key]


def _no_rows(_: Document) -> dict[object, Expanded]:
    return {}

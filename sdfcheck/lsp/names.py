"""The symbols of open texts and of those that belong to them: where each is defined and written."""

from __future__ import annotations

import os
import re
from bisect import bisect_left, bisect_right
from collections.abc import Callable, Collection, Iterable, Iterator, Mapping
from itertools import accumulate, islice
from pathlib import Path

from sdfcheck.files.library import library_of
from sdfcheck.files.regular import MEGABYTE, read_regular
from sdfcheck.lsp.workspace import LiveExpander, Workspace
from sdfcheck.lsp.xacro_names import Known, xacro_names
from sdfcheck.robot.naming.occurrences import Occurrence, Symbol, robot_names
from sdfcheck.robot.semantics import (
    MOST_ROBOTS,
    ROOT_JOINT,
    Assistants,
    Semantics,
    declared,
    descriptions_of,
    semantic_names,
    semantics_in,
)
from sdfcheck.robot.values import lazy
from sdfcheck.source import document as documents
from sdfcheck.source.document import Document
from sdfcheck.source.record import NamedTuple
from sdfcheck.source.sniff import HEAD, Kind, sniff
from sdfcheck.source.text import Span
from sdfcheck.xacro.expansion import Expander, Expansion
from sdfcheck.xacro.language import matches, may_become
from sdfcheck.xacro.static.definitions import is_robot, visible_definitions
from sdfcheck.xacro.static.launches import launched_arguments
from sdfcheck.xacro.static.project import includers

# The names of the robots that xacro files make: for each place where one is written, all that it expands to.


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
        self,
        root: Document,
        arguments: Mapping[str, str],
        document: Document,
        *,
        is_partial: bool = False,
        wanted: Collection[str] | None = None,
    ) -> None:
        self._wanted = wanted
        self.root = root
        self.arguments = arguments
        self.document = document
        self.is_partial = is_partial
        self.name = "" if document.root is None else document.root.attributes.get("name", "").strip()
        """The name of the robot."""

    @lazy
    def all(self) -> tuple[Occurrence, ...]:
        """The places that name parts of the robot."""
        return tuple(rows_of(self.document, self._wanted))

    @lazy
    def by_place(self) -> dict[Place, list[Occurrence]]:
        """The same, by place."""
        found: dict[Place, list[Occurrence]] = {}
        for each in self.all:
            found.setdefault(place_of(each.span), []).append(each)
        return found

    @lazy
    def by_name(self) -> dict[Key, list[Occurrence]]:
        """The same, by what is named."""
        found: dict[Key, list[Occurrence]] = {}
        for each in self.all:
            found.setdefault(each.symbol.called, []).append(each)
        return found


def rows_of(document: Document, wanted: Collection[str] | None = None) -> Iterator[Occurrence]:
    """The places that name parts of the robot in a document without expressions; of SRDF those of some names."""
    if document.root is None:
        return
    if document.kind is Kind.SRDF:
        for semantics in semantics_in(document):
            yield from semantic_names(semantics, wanted)
    else:
        yield from robot_names(document)


def as_written(document: Document, wanted: Collection[str] | None = None) -> Expanded:
    """A document that is not expanded, in the same form; of SRDF the places of some names."""
    if wanted is not None and document.kind is Kind.SRDF:
        return Expanded(document, {}, document, wanted=wanted)
    return document.view(_as_written)


def _as_written(document: Document) -> Expanded:
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
    return list(islice(filter(is_robot, _users_of(document)), MOST_ROOTS))


def parts_of(document: Document) -> list[Document]:
    """Files that contain a document, robots or not: itself, and some of those that include it."""
    return list(islice(_users_of(document), MOST_ROOTS + 1))


def _users_of(document: Document) -> Iterator[Document]:
    """A document, and the files that include it or one of its users."""
    library = library_of(document)
    seen: set[str] = set()
    waiting: list[Document | None] = [document]
    while waiting:
        one = waiting.pop(0)
        if one is None or one.source.real_path in seen:
            continue
        seen.add(one.source.real_path)
        yield one
        if library is not None:
            waiting += (library.document(path, Kind.XACRO) for path in includers(one))


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
        expander, wanted = _expander(workspace, root)
        if not isinstance(expander, LiveExpander):
            continue
        if turned and not only_known:
            wanted += [{**wanted[0], **switch} for switch in _switches(root)]
        for arguments in wanted:
            earlier = expander.lately(root, arguments) if lately else None
            own = _expanded(expander, root, arguments, only_known=only_known, made=earlier)
            if own is not None:
                found.append(own)
    return found


def _expander(workspace: Workspace, root: Document) -> tuple[Expander | None, list[dict[str, str]]]:
    expander, sets, _ = workspace.caches.xacro(workspace.settings_for(root.path), root.path)
    return expander, [dict(each) for each in sets] or _usual_sets(root)


def is_given(workspace: Workspace, root: Document, argument: str) -> bool:
    """Do launch files, the settings of MoveIt's assistant or the configuration give an argument to a file?"""
    return any(argument in each for each in (*launched_arguments(root), *_expander(workspace, root)[1]))


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


# The names in an SRDF file: its groups, and the links and joints that another file defines.

_FEWEST = 0.5
"""A file that defines fewer of the names is about another robot."""


def srdf_names(document: Document) -> Iterator[Occurrence]:
    """Every place in an SRDF document that names a group, or a link or joint of the robot."""
    known = descriptions(document)
    for each in semantic_names(document.view(Semantics)):
        symbol = each.symbol
        if symbol.span == each.span and not each.is_definition:
            found = (own.part((symbol.kind,), symbol.name, None) for own in known)
            symbol = next((own for own in found if own is not None), symbol)
        yield each._replace(symbol=symbol)


def descriptions(document: Document) -> list[Known]:
    """The names that the robot of an SRDF document defines; empty where none is found."""
    return document.view(_descriptions)


def _descriptions(document: Document) -> list[Known]:
    return [robot.view(_own_known) for robot in descriptions_for(document)]


def descriptions_for(document: Document) -> list[Document]:
    """The file that is about the robot of an SRDF document: of the first few the one that has the most names."""
    return document.view(_described)


def _described(document: Document) -> list[Document]:
    if document.kind is not Kind.SRDF or document.root is None:
        return []
    semantics = document.view(Semantics)
    wanted = {(part.kind, part.value.text.strip()) for part in semantics.named}
    wanted -= {("joint", name) for name in (ROOT_JOINT, *semantics.virtual_joints)}
    best: list[Document] = []
    most = _FEWEST * len(wanted)
    for robot in islice(descriptions_of(semantics), MOST_ROBOTS):
        known = robot.view(_own_known) if robot.root is not None else None
        fitting = sum(known.part((kind,), name, None) is not None for kind, name in wanted) if known else -1
        if fitting > most or (fitting >= most and not best):
            best, most = [robot], fitting
        if fitting == len(wanted):
            break
    return best


def _own_known(robot: Document) -> Known:
    return Known([visible_definitions(robot)])


MOST_FILES = 5_000
"""So many files of a project are searched for a name, no more."""
LARGEST = 16 * MEGABYTE
MOST_SEMANTICS = 100
"""So many SRDF files that name a part are looked at, no more."""
MOST_TRIED = 2
"""So many robots are expanded to find the one that SRDF is about."""

IN_XACRO = frozenset({"macro", "property", "parameter", "argument"})
"""The kinds of names that are xacro's own."""
_ROS = frozenset({Kind.URDF, Kind.SRDF})
_MADE = re.compile(r"<xacro:|\$[({]")
_COMPOSED = re.compile(r"[\"']([^\"'<>]*\$[({][^\"<>]*)[\"']")
_NAMING = frozenset({Kind.SDF, Kind.URDF, Kind.XACRO, Kind.SRDF})


class Occurrences:
    """The names in a document, in order of place; each place once. One may lie within another."""

    def __init__(self, document: Document) -> None:
        by_place: dict[tuple[int, int, str], Occurrence] = {}
        for each in _found(document):
            if each.span.source is document.source:
                by_place.setdefault((each.span.start, each.span.end, each.before), each)
        order = sorted(by_place, key=lambda place: (place[0], -place[1], place[2]))
        self.all = tuple(by_place[place] for place in order)
        self._starts = [each.span.start for each in self.all]
        self._reach = list(accumulate((each.span.end for each in self.all), max))

    def around(self, offset: int) -> list[Occurrence]:
        """The names at a place, the innermost first; of those in the same place the last."""
        found = []
        number = bisect_right(self._starts, offset) - 1
        while number >= 0 and self._reach[number] >= offset:
            if self.all[number].span.end >= offset:
                found.append(self.all[number])
            number -= 1
        return found

    def at(self, offset: int) -> Occurrence | None:
        """The innermost name at a place."""
        return next(iter(self.around(offset)), None)

    def within(self, span: Span) -> list[Occurrence]:
        """The names within that of a place."""
        first = bisect_left(self._starts, span.start)
        last = bisect_right(self._starts, span.end, first)
        return [each for each in self.all[first:last] if each.span.end <= span.end and each.span != span]


def _found(document: Document) -> Iterator[Occurrence]:
    if document.root is None:
        return
    if document.kind is Kind.XACRO or is_made(document):
        yield from xacro_names(document, known_in(document))
    elif document.kind in {Kind.SDF, Kind.URDF}:
        yield from robot_names(document)
    elif document.kind is Kind.SRDF:
        yield from srdf_names(document)


def known_in(document: Document) -> Known:
    """The names that a document and the robots that include it define."""
    return document.view(_known_in)


def _known_in(document: Document) -> Known:
    around = roots_of(document) or parts_of(document)[1:]
    return Known([visible_definitions(each) for each in (document, *around)], document)


def is_made(document: Document) -> bool:
    """Is a document to be expanded: a robot, or its semantics, written in xacro?"""
    is_srdf = document.kind is Kind.SRDF
    return document.kind is Kind.XACRO or (is_srdf and _MADE.search(document.source.text) is not None)


def occurrences(document: Document) -> Occurrences:
    """The names in a document, found once."""
    return document.view(Occurrences)


# A name, wherever it is


def definitions(workspace: Workspace, document: Document, named: Occurrence) -> list[Span]:
    """The places where what is named gets its name, or else what its expressions take; empty where nothing is known."""
    found = _places(workspace, document, named)
    inside = [] if found else occurrences(document).within(named.span)
    return found or [place for each in inside for place in _places(workspace, document, each)]


def _places(workspace: Workspace, document: Document, named: Occurrence) -> list[Span]:
    symbol = named.symbol
    is_open = symbol.span == named.span and not named.is_definition
    if symbol.kind in IN_XACRO:
        groups = (group for group in known_in(document).groups if group[0].key == symbol.key)
        return [each.span for each in next(groups, [symbol])]
    if is_made(document) or (is_open and document.kind in _ROS):
        for turned in (False, True):
            found = list(_definitions(workspace, document, named, turned=turned))
            if found:
                return list({place_of(span): span for span in found}.values())
    if not is_open or document.kind is not Kind.SRDF:
        return [] if is_open else [symbol.span]
    known = Known([visible_definitions(robot) for robot in robots_about(workspace, document)])
    alike = known.part((symbol.kind,), symbol.name, None)
    return [alike.span] if alike is not None else []


def _definitions(
    workspace: Workspace, document: Document, named: Occurrence, *, turned: bool
) -> Iterator[Span]:
    for root, names, rows in _shared(workspace, document, named, turned=turned):
        own = [each.span for each in rows if each.is_definition]
        robots = robots_about(workspace, root) if not own else []
        own += (each.span for each in _rows(_made(workspace, robots), names) if each.is_definition)
        yield from own


def references(workspace: Workspace, document: Document, named: Occurrence) -> list[Occurrence]:
    """Every place where the same is named, as it is written and as it is expanded."""
    found = everywhere(workspace, document, named.symbol)
    if named.symbol.kind not in IN_XACRO and (is_made(document) or document.kind in _ROS):
        for root, names, rows in _shared(workspace, document, named):
            wanted = {name for _, name in names}
            if any(one.document.kind is Kind.SRDF for one in _made(workspace, [root])):
                others = robots_about(workspace, root)
            else:
                others = [root]
            others += [each for robot in others for each in semantics_of(workspace, robot, wanted)[0]]
            found += [*rows, *_rows(_made(workspace, others, wanted=wanted), names)]
    return list({place_of(each.span): each for each in found}.values())


def _made(
    workspace: Workspace,
    roots: Iterable[Document],
    *,
    turned: bool = False,
    lately: bool = False,
    wanted: Collection[str] | None = None,
) -> list[Expanded]:
    """Files as they are expanded, or as they are; of SRDF that is not expanded the places of some names."""
    return [
        one
        for root in roots
        for one in (
            expansions(workspace, [root], turned=turned, lately=lately)
            if is_made(root)
            else [as_written(root, wanted)]
        )
    ]


def _rows(made: Iterable[Expanded], names: Iterable[Key]) -> list[Occurrence]:
    names = list(names)
    return [row for one in made for name in names for row in one.by_name.get(name, ())]


def _shared(
    workspace: Workspace, document: Document, named: Occurrence, *, turned: bool = True
) -> Iterator[tuple[Document, list[Key], list[Occurrence]]]:
    """The robots, or semantics, that a place is in: the names that it expands to, and where else they are."""
    for root in roots_of(document):
        made = _made(workspace, [root], turned=turned)
        names = list(dict.fromkeys(name for one in made for name in names_at(one, named.span)))
        yield root, names, _rows(made, names)


# Semantics and robots


def robots_about(workspace: Workspace, document: Document, *, lately: bool = False) -> list[Document]:
    """The robots that SRDF is about: that of a document, or those that it is included in.

    Of a part that nothing includes, the robots of its name. ``lately``: expansions of earlier texts do.
    """
    found: dict[str, Document] = {}
    roots = roots_of(document)
    made = [one[0].document if (one := _made(workspace, [root], lately=lately)) else root for root in roots]
    for semantics in made or [document]:
        if semantics.kind is Kind.SRDF and semantics.root is not None:
            for robot in descriptions_for(semantics) or _by_their_names(workspace, semantics):
                found.setdefault(robot.source.real_path, robot)
    return list(found.values())


def _by_their_names(workspace: Workspace, document: Document) -> list[Document]:
    """The first robot that expands to half of what an SRDF document names, by a file that does not show it.

    Of the robot for which MoveIt's assistant made it, packages may be missing: any of the names will do.
    """
    known, library = document.view(_no_robots), library_of(document)
    if not known and library is not None:
        semantics = document.view(Semantics)
        wanted = {(part.kind, part.value.text.strip()) for part in semantics.named}
        meant = {each.path for each in declared(document.path, library.packages(document.path))}
        candidates = islice(filter(is_made, descriptions_of(semantics)), MOST_TRIED)
        made = ((robot, _made(workspace, [robot])) for robot in candidates)
        shared = (
            (robot, max((len(wanted & one.by_name.keys()) for one in own), default=0)) for robot, own in made
        )
        found = (robot for robot, n in shared if 2 * n >= len(wanted) or (n and robot.path in meant))
        known.append([*islice(found, 1)])
    return known[0] if known else []


def _no_robots(_: Document) -> list[list[Document]]:
    return []


def semantics_of(
    workspace: Workspace, robot: Document, names: Collection[str]
) -> tuple[list[Document], bool]:
    """The SRDF files of a project that are about a robot and may name one of some parts of it; are these all?"""

    def may_refer(data: bytes, path: Path) -> bool:
        text = data.decode("utf-8", "replace")
        return sniff(data[:HEAD], path) is Kind.SRDF and bool(_MADE.search(text) or may_name(text, names))

    found: list[Document] = []
    looked_at = 0
    for path in project_files(workspace, robot.path, fits=may_refer) if names else ():
        each = _semantics(workspace, path, names)
        if each is not None:
            if looked_at == MOST_SEMANTICS:
                return found, False
            looked_at += 1
            about = robots_about(workspace, each)
            found += [each] if any(one.source.real_path == robot.source.real_path for one in about) else []
    return found, True


def _semantics(workspace: Workspace, path: Path, names: Collection[str]) -> Document | None:
    """The SRDF document at a path; None if others include it, or nothing that it is made of can name some parts.

    Only SRDF in xacro is kept: a project may have hundreds of other files, each larger than its robot.
    """
    data = b"" if workspace.key(path) in workspace.buffers else _read(workspace, path)
    if data and not _MADE.search(data.decode("utf-8", "replace")):
        each: Document | None = documents.read(data, path, Kind.SRDF)
        assert each is not None
        each.library = workspace.library(path)
        return each
    each = workspace.document(path)
    if each is None or any(".srdf" in one.name for one in includers(each)):
        return None
    read = visible_definitions(each).readings
    return each if any(may_name(one.document.source.text, names) for one in read) else None


def may_name(text: str, names: Iterable[str]) -> bool:
    """Does a text hold one of some names, or an expression that may come to it together with what is around it?"""
    composed = {match[1] for match in _COMPOSED.finditer(text)}
    return any(name in text or any(may_become(each, name) for each in composed) for name in names)


def names_at(one: Expanded, span: Span) -> list[Key]:
    """The names that a place expands to."""
    return list(dict.fromkeys(each.symbol.called for each in one.by_place.get(place_of(span), ())))


def everywhere(workspace: Workspace, document: Document, symbol: Symbol) -> list[Occurrence]:
    """Every place where a symbol is named: in a document, in the file that defines it, and in their project.

    A name that several files define is known by one definition in one of them, and by another in another. SRDF that
    is about the robot is for :func:`semantics_of`.
    """
    documents = list(_documents(workspace, document, symbol))
    groups = [
        {each.key for each in group}
        for other in documents
        if symbol.kind in IN_XACRO and is_made(other)
        for group in known_in(other).groups
        if group[0].name == symbol.name
    ]
    keys, number = {symbol.key}, 0
    while number < len(keys):
        number = len(keys)
        keys = keys.union(*(group for group in groups if not keys.isdisjoint(group)))
    return [each for other in documents for each in occurrences(other).all if each.symbol.key in keys]


def _documents(workspace: Workspace, document: Document, symbol: Symbol) -> Iterator[Document]:
    seen: set[str] = set()
    paths = [document.path, symbol.span.source.path, *_parts_naming(document, symbol)]
    wanted = symbol.name.encode("utf-8", "surrogatepass")
    word = re.compile(rb"(?<!\w)%s(?!\w)" % re.escape(wanted))

    def may_refer(data: bytes, path: Path) -> bool:
        kind = sniff(data[:HEAD], path)
        if symbol.kind not in IN_XACRO:
            return kind in _NAMING and kind is not Kind.SRDF
        is_xacro = kind is Kind.XACRO or (kind is Kind.SRDF and _MADE.search(data.decode("latin-1")))
        return bool(is_xacro and word.search(data))

    for path in (*paths, *project_files(workspace, document.path, wanted, may_refer)):
        key = workspace.key(path)
        if key in seen:
            continue
        seen.add(key)
        other = document if path is document.path else workspace.document(path)
        if other is not None:
            yield other


def _parts_naming(document: Document, symbol: Symbol) -> Iterator[Path]:
    """The files from which the semantics that a document takes part in are made, and which name a symbol."""
    if document.kind is not Kind.SRDF or not is_made(document) or symbol.kind in IN_XACRO:
        return
    word = re.compile(rf"[\"']\s*{re.escape(symbol.name)}\s*[\"']")
    for root in roots_of(document):
        for read in visible_definitions(root).readings:
            if word.search(read.document.source.text):
                yield read.document.path


def is_description(data: bytes, path: Path) -> bool:
    """Does a file describe a robot, a world or the semantics of a robot?"""
    return sniff(data[:HEAD], path) in _NAMING


def project_files(
    workspace: Workspace,
    path: Path,
    wanted: bytes = b"",
    fits: Callable[[bytes, Path], bool] = is_description,
) -> Iterator[Path]:
    """The descriptions of a project that hold some bytes, the open ones first."""
    for buffer in list(workspace.buffers.values()):
        if wanted in buffer.data and fits(buffer.data, buffer.path):
            yield buffer.path
    own = [folder for folder in workspace.folders if path.is_relative_to(folder)]
    if not own and not os.path.exists(path):
        return
    places = own[:1] or workspace.library(path).packages(path).places
    for file in workspace.listed(places)[:MOST_FILES]:
        if workspace.key(file) in workspace.buffers:
            continue
        data = _read(workspace, file)
        if data and wanted in data and fits(data, file):
            yield file


def _read(workspace: Workspace, path: Path) -> bytes:
    """The content of a file of a project; empty if it cannot be read."""
    try:
        return read_regular(path, LARGEST, workspace.library(path).around(path))
    except OSError:
        return b""

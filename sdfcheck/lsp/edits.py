"""Edits, commands and lines that go with a text, in the protocol's own types."""

from __future__ import annotations

import math
import os
import re
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from functools import partial
from pathlib import Path, PurePosixPath
from typing import Any, TypeVar

from lsprotocol import types

from sdfcheck.convert.loss import NotConvertible, to_diagnostic
from sdfcheck.formats.describe import spot
from sdfcheck.formats.sdf.survey import version_of
from sdfcheck.lint.fix import TextEdit
from sdfcheck.lsp.actions import canonical_edits, converted, expanded_text, extractions, keeps_expansion
from sdfcheck.lsp.cursor import Part, at, elements
from sdfcheck.lsp.hover import Signature, names_around, signature
from sdfcheck.lsp.names import everywhere, occurrences, project_files
from sdfcheck.lsp.outline import Link, links
from sdfcheck.lsp.speech import ProtocolTypes, path_of, plain
from sdfcheck.lsp.workspace import Buffer, Workspace
from sdfcheck.source.document import Document, Element, Value
from sdfcheck.source.errors import DescriptionError, WrongUsage
from sdfcheck.source.record import NamedTuple
from sdfcheck.source.sniff import Kind
from sdfcheck.source.text import Span

# The colors that a text writes, for the editor's color picker.


_TYPE = "color"
_CHANNELS = (3, 4)


class Color(NamedTuple):
    """A color in a text: red, green, blue and alpha from 0 to 1."""

    span: Span
    channels: tuple[float, float, float, float]


def colors(document: Document) -> Iterator[Color]:
    """The values that the format takes for colors and that can be shown as one."""
    if document.root is None:
        return
    is_color: dict[tuple[str, ...], bool] = {}
    for element in elements(document).all:
        for attribute, value in _values(element):
            channels = _channels(value.text)
            if channels is None:
                continue
            way = (*names_around(element), attribute)
            if way not in is_color:
                is_color[way] = _is_color(document, way[:-1], attribute)
            if is_color[way]:
                yield Color(value.span, channels)


def _values(element: Element) -> Iterator[tuple[str, Value]]:
    if not element.nodes and element.content:
        yield "", element.own_value
    for name in element.attributes:
        if (value := element.attribute(name)) is not None:
            yield name, value


def _channels(text: str) -> tuple[float, float, float, float] | None:
    words = text.split()
    if len(words) not in _CHANNELS:
        return None
    try:
        numbers = [float(word) for word in words]
    except ValueError:
        return None
    if not all(0 <= number <= 1 for number in numbers):  # also false for nan
        return None
    red, green, blue, alpha = (*numbers, 1.0)[:4]
    return red, green, blue, alpha


def _is_color(document: Document, names: Sequence[str], attribute: str) -> bool:
    place = spot(names, version_of(document)) or spot(names)
    described = None if place is None else place.describe(attribute)
    return described is not None and described.type == _TYPE


def written(before: str, channels: Sequence[float]) -> str:
    """The text for another color; three numbers stay three unless it is transparent."""
    count = 3 if len(before.split()) == 3 and math.isclose(channels[3], 1) else 4
    return " ".join(f"{round(channel, 3) + 0.0:g}" for channel in channels[:count])


# The tags around a place: the two names that are edited as one, and the ranges to which a selection grows.


NAME_PATTERN = r"[^\s<>/\"'=]+"
"""The names that stay linked while they are edited."""

_WORD = re.compile(r"\$\{[^}]*\}|\$\([^)]*\)|[\w.+:-]+")


def linked(document: Document, offset: int) -> tuple[Span, Span] | None:
    """The names in the start tag and the end tag of an element, at one of which a place is."""
    cursor = at(document, offset)
    if cursor is None or cursor.part is not Part.NAME:
        return None
    start, end = document.spans.name(cursor.element), document.spans.end_name(cursor.element)
    return (start, end) if end is not None and start.text == end.text else None


def selections(document: Document, offset: int) -> list[Span]:
    """The ranges around a place, the smallest first, each within the next."""
    found = [document.source.span(offset, offset)]
    for span in _around(document, offset):
        last = found[-1]
        if span.start <= last.start and last.end <= span.end and span != last:
            found.append(span)
    return found[1:] or found


def _around(document: Document, offset: int) -> Iterator[Span]:
    source = document.source
    if (cursor := at(document, offset)) is not None:
        if cursor.part in {Part.VALUE, Part.TEXT}:
            words = _WORD.finditer(source.text, cursor.span.start, cursor.span.end)
            yield from (source.span(*word.span()) for word in words if word.start() <= offset <= word.end())
        yield cursor.span
        if cursor.attribute:
            whole = document.spans.attribute_whole(cursor.element, cursor.attribute)
            yield source.span(whole.end - len(whole.text.lstrip()), whole.end)
    yield from (source.span(start, end) for start, end in document.scan.comments if start < offset < end)
    element = None if document.root is None else elements(document).around(offset)
    while element is not None:
        yield from _of_element(element)
        element = element.parent
    yield source.span(0, len(source.text))


def _of_element(element: Element) -> Iterator[Span]:
    """Its start tag, its end tag, what is between them, and all of it."""
    place = element.document.spans.place(element)
    source = element.document.source
    yield source.span(place.start, place.end)
    if place.close > place.end:
        yield source.span(place.end, place.close)
    yield source.span(place.close, place.close_end)
    yield source.span(place.start, place.close_end)


# Lines above definitions: how often a name is used, and which files include this one.


_COUNTED = frozenset({"macro", "model", "link", "joint", "frame"})
"""The kinds of names whose uses are counted."""


class Lens(NamedTuple):
    """A place above which there is a line; ``is_file``: it is about the whole file."""

    span: Span
    is_file: bool


class Count(NamedTuple):
    """The words of a line, and the places that it leads to."""

    title: str
    places: tuple[Span, ...]


def lenses(document: Document) -> Iterator[Lens]:
    """The places above which there are lines; what they say takes longer."""
    if document.root is None:
        return
    if document.kind in {Kind.XACRO, Kind.SDF}:
        yield Lens(document.root.span, True)
    for each in occurrences(document).all:
        if each.is_definition and each.symbol.kind in _COUNTED:
            yield Lens(each.span, False)


def counted(workspace: Workspace, document: Document, offset: int, *, is_file: bool) -> Count | None:
    """The line above a place; None where there is nothing to say."""
    if is_file:
        places = tuple(_inclusions(workspace, document))
        files = {span.source.path for span in places}
        return Count(f"included by {_number(len(files), 'file')}", places) if files else None
    named = occurrences(document).at(offset)
    if named is None:
        return None
    found = everywhere(workspace, document, named.symbol)
    uses = (each.span for each in found if not each.is_definition)
    places = tuple(span for span in uses if not span.source.text.startswith("</", _opening(span)))
    return Count(_number(len(places), "reference"), places)


def _opening(span: Span) -> int:
    return span.source.text.rfind("<", 0, span.start)


def _number(count: int, noun: str) -> str:
    return f"{count} {noun}{'' if count == 1 else 's'}"


def _inclusions(workspace: Workspace, document: Document) -> Iterator[Span]:
    """The elements that include a file, in the files of its project."""
    if document.kind is Kind.XACRO:
        yield from _of_xacro(workspace, document)
        return
    from sdfcheck.robot.includes.included import included, includes_of

    own = workspace.key(document.path)
    folder = Path(own).parent.name
    seen = {own}
    for path in project_files(workspace, document.path, folder.encode("utf-8", "surrogateescape")):
        other = workspace.document(path) if workspace.key(path) not in seen else None
        seen.add(workspace.key(path))
        if other is None or other.kind is not Kind.SDF:
            continue
        for include in includes_of(other):
            brought = included(other, include)
            if brought.file is not None and os.path.realpath(brought.file) == own:
                yield include.span if brought.uri is None else brought.uri.span


def _of_xacro(workspace: Workspace, document: Document) -> Iterator[Span]:
    from sdfcheck.xacro.static.definitions import reading, visible_definitions
    from sdfcheck.xacro.static.project import includers

    own = workspace.key(document.path)
    for path in includers(document):
        other = workspace.library(path).document(path, Kind.XACRO)
        if other is None:
            continue
        found = visible_definitions(other)
        elements = [include.element for include in reading(other).includes]
        targets = [(element, found.target(element)) for element in elements]
        sure = [element for element, target in targets if target is not None and workspace.key(target) == own]
        unknown = [element for element, target in targets if target is None]
        yield from (element.span for element in sure or unknown)


# Renaming and moving files: the texts that name them follow.


Moves = Mapping[Path, Path]
"""File or folder → its path after the move; absolute."""


def moved(workspace: Workspace, moves: Moves) -> list[TextEdit]:
    """The edits, before the files are moved, after which all links of the project lead to the same files."""
    edits: dict[tuple[str, int], TextEdit] = {}
    for path in _files(workspace, moves):
        document = workspace.document(path)
        if document is None or document.root is None:
            continue
        for link in links(document):
            text = _followed(document, link, moves)
            if text is not None and text != link.span.text:
                edits[workspace.key(path), link.span.start] = TextEdit(link.span, text)
    return list(edits.values())


def _files(workspace: Workspace, moves: Moves) -> Iterator[Path]:
    """The files that may name what is moved, and those that are moved themselves."""
    seen: set[str] = set()
    for old in moves:
        inside = project_files(workspace, old)
        naming = project_files(workspace, old, old.name.encode("utf-8", "surrogateescape"))
        for path in (*naming, *(each for each in inside if _after(each, moves) is not None)):
            key = workspace.key(path)
            if key not in seen:
                seen.add(key)
                yield path


def _after(path: Path, moves: Moves) -> Path | None:
    """The path of a file after the move; None for one that stays."""
    plain = Path(os.path.abspath(path))
    for old, new in moves.items():
        if plain == old or plain.is_relative_to(old):
            return new / plain.relative_to(old)
    return None


def _followed(document: Document, link: Link, moves: Moves) -> str | None:
    """The text of a link after the move; None if it can stay, or nobody knows it."""
    text, target = link.span.text, Path(os.path.abspath(link.target))
    home = Path(os.path.abspath(document.path))
    new_home, new_target = _after(home, moves), _after(target, moves)
    if new_home is None and new_target is None:
        return None
    if _is_relative(text):
        return _relative(text, target, new_target or target, (new_home or home).parent)
    if new_target is None:
        return None
    return _in_place(text, (target, new_target), (target.parent, new_target.parent))


def _is_relative(text: str) -> bool:
    return ":" not in text and "$" not in text and not text.startswith("/")


def _relative(text: str, old: Path, new: Path, folder: Path) -> str:
    """A path from a folder to a file; to the folder of a model where the text names that."""
    if PurePosixPath(text).name != old.name and PurePosixPath(text).name == old.parent.name:
        new = new.parent
    found = Path(os.path.relpath(new, folder)).as_posix()
    return f"./{found}" if text.startswith("./") and not found.startswith("../") else found


def _in_place(text: str, *pairs: tuple[Path, Path]) -> str | None:
    """A URI with another end: as much of it stays as is around the old and the new path."""
    words = text.split("/")
    for old, new in pairs:
        for count in range(1, min(len(words), len(old.parts))):
            if tuple(words[-count:]) != old.parts[-count:]:
                break
            base = old.parents[count - 1]
            if new.is_relative_to(base):
                return "/".join([*words[:-count], new.relative_to(base).as_posix()])
    return None


def moves_of(renames: Iterable[tuple[Path, Path]]) -> Moves:
    """The moves of paths, by their absolute names."""
    return {Path(os.path.abspath(old)): Path(os.path.abspath(new)) for old, new in renames}


T = TypeVar("T")

EXTRACT = f"{types.CodeActionKind.RefactorExtract.value}.sdfcheck"
REFERENCES = "sdfcheck.references"
"""The command of a client that shows places; one that has it lists it in ``experimental.commands``."""
MOVABLE = "**/*.{sdf,world,urdf,xacro,srdf,config,yaml,stl,obj,dae,glb,gltf,png,jpg,jpeg}"

_LANGUAGES = {"sdf": "sdformat", "urdf": "urdf"}


class Impossible(Exception):
    """A request that cannot be answered; the message says why."""


class Edits:
    """The answers about edits, request by request; all of it runs in the worker's thread."""

    def __init__(self, workspace: Workspace, speech: ProtocolTypes) -> None:
        self.workspace = workspace
        self.speech = speech

    def document(self, buffer: Buffer) -> Document:
        """The document of an open text, with its library."""
        document = self.workspace.document(buffer.path)
        assert document is not None, "an open text is a document"
        return document

    # While typing

    def linked(
        self, buffer: Buffer, params: types.LinkedEditingRangeParams
    ) -> types.LinkedEditingRanges | None:
        document = self.document(buffer)
        found = linked(document, self.speech.offset(document.source, params.position))
        if found is None:
            return None
        return types.LinkedEditingRanges([self.speech.range(span) for span in found], NAME_PATTERN)

    def selections(
        self, buffer: Buffer, params: types.SelectionRangeParams
    ) -> list[types.SelectionRange] | None:
        document = self.document(buffer)
        return [
            self._nested(selections(document, self.speech.offset(document.source, position)))
            for position in params.positions
        ]

    def _nested(self, spans: Sequence[Span]) -> types.SelectionRange:
        outer: types.SelectionRange | None = None
        for span in reversed(spans):
            outer = types.SelectionRange(self.speech.range(span), outer)
        assert outer is not None, "a place is within a range"
        return outer

    def signature(self, buffer: Buffer, params: types.SignatureHelpParams) -> types.SignatureHelp | None:
        found = signature(self.workspace, buffer, self.speech.offset(buffer.source, params.position))
        return None if found is None else types.SignatureHelp([_signature(found)], 0, found.active)

    def formatted(self, buffer: Buffer, _: Any) -> list[types.TextEdit]:
        return list(self.speech.text_edits(_tried(partial(canonical_edits, self.workspace, buffer))))

    # Colors

    def colors(self, buffer: Buffer, _: Any) -> list[types.ColorInformation]:
        return [
            types.ColorInformation(self.speech.range(color.span), types.Color(*color.channels))
            for color in colors(self.document(buffer))
        ]

    def presentations(
        self, buffer: Buffer, params: types.ColorPresentationParams
    ) -> list[types.ColorPresentation]:
        before = self.speech.span(buffer.source, params.range).text
        color = params.color
        text = written(before, (color.red, color.green, color.blue, color.alpha))
        return [types.ColorPresentation(text, types.TextEdit(params.range, text))]

    # Refactorings

    def extractions(self, buffer: Buffer, chosen: types.Range) -> list[types.CodeAction]:
        """The actions that give a name to what is selected."""
        span = self.speech.span(buffer.source, chosen)
        data = {"uri": buffer.uri, "extract": [span.start, span.end]}
        resolves = self.speech.is_able("text_document", "code_action", "resolve_support")
        return [
            types.CodeAction(
                found.title,
                kind=EXTRACT,
                data=data if resolves else None,
                edit=None if resolves else self.speech.workspace_edit(found.edits),
            )
            for found in extractions(self.document(buffer), span)
            if resolves or keeps_expansion(self.workspace, buffer, found.edits)
        ]

    def extracted(self, buffer: Buffer, action: types.CodeAction, wanted: Sequence[int]) -> types.CodeAction:
        """The edits of an extraction that was offered without them.

        Raises:
            Impossible: the expansion would be another one, or the text is another one now.
        """
        span = buffer.source.span(*wanted)
        for found in extractions(self.document(buffer), span):
            if found.title == action.title:
                if not keeps_expansion(self.workspace, buffer, found.edits):
                    raise Impossible("the robot would be expanded to something else")
                action.edit = self.speech.workspace_edit(found.edits)
                return action
        raise Impossible("the text has changed")

    # Lines above definitions

    def lenses(self, buffer: Buffer, _: Any) -> list[types.CodeLens]:
        if not self.workspace.choices.lenses:
            return []
        return [
            types.CodeLens(self.speech.range(lens.span), data={"uri": buffer.uri, "file": lens.is_file})
            for lens in lenses(self.document(buffer))
        ]

    def counted(self, buffer: Buffer, lens: types.CodeLens) -> types.CodeLens:
        """A line with its words."""
        document = self.document(buffer)
        place = lens.range.start
        is_file = bool(plain(lens.data)["file"])
        offset = self.speech.offset(document.source, place)
        found = counted(self.workspace, document, offset, is_file=is_file)
        if found is None:
            lens.command = types.Command("not included by a file" if is_file else "", "")
            return lens
        has_command = REFERENCES in _commands_of(self.speech.client)
        where = [self.speech.location(span) for span in found.places]
        arguments = [buffer.uri, place, where] if has_command and where else None
        lens.command = types.Command(found.title, REFERENCES if arguments else "", arguments=arguments)
        return lens

    # Files

    def moved(self, renames: Iterable[types.FileRename]) -> types.WorkspaceEdit | None:
        moves = moves_of((path_of(each.old_uri), path_of(each.new_uri)) for each in renames)
        edits = moved(self.workspace, moves)
        return self.speech.workspace_edit(edits) if edits else None

    # Commands

    def expanded(self, buffer: Buffer, arguments: Mapping[str, str]) -> dict[str, Any]:
        """The expanded text, and the place in the sources of each range of lines."""
        text, places = _tried(lambda: expanded_text(self.workspace, buffer, arguments))
        root = self.document(buffer).root
        return {
            "text": text,
            "language": _LANGUAGES["sdf" if root is not None and root.name == "sdf" else "urdf"],
            "places": [
                {"first": place.first, "last": place.last, "location": self.speech.location(place.span)}
                for place in places
            ],
        }

    def converted(self, buffer: Buffer, to: str, arguments: Mapping[str, str]) -> dict[str, Any]:
        """The text in another format, and what it lacks."""
        wanted = to or ("urdf" if self.document(buffer).kind is Kind.SDF else "sdf")
        if wanted not in _LANGUAGES:
            raise Impossible(f"`{wanted}` is not a format to convert to: use sdf or urdf")
        done = _tried(lambda: converted(self.workspace, buffer, wanted, arguments))
        lost = [to_diagnostic(loss) for loss in done.losses]
        return {
            "text": done.text,
            "language": _LANGUAGES[wanted],
            "verified": done.verification is not None and done.verification.is_equal,
            "verdict": "not verified" if done.verification is None else str(done.verification),
            "losses": [
                {"uri": self.speech.location(loss.span).uri, "diagnostic": self.speech.diagnostic(loss)}
                for loss in lost
            ],
        }


def _tried(job: Callable[[], T]) -> T:
    """The result of a job.

    Raises:
        Impossible: it cannot be done, for a reason that a person can change.
    """
    try:
        return job()
    except (WrongUsage, NotConvertible, DescriptionError) as error:
        raise Impossible(str(error)) from None


def _commands_of(client: types.ClientCapabilities) -> Sequence[Any]:
    known = plain(client.experimental)
    found = known.get("commands") if isinstance(known, dict) else None
    return found if isinstance(found, list) else ()


def _signature(found: Signature) -> types.SignatureInformation:
    parameters = [
        types.ParameterInformation(place, note)
        for place, note in zip(found.parameters, found.notes, strict=True)
    ]
    return types.SignatureInformation(found.label, found.story or None, parameters)

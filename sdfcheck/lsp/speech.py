"""From the project's own values and places to those of the protocol, and back."""

from __future__ import annotations

import os
import re
from collections.abc import Iterable, Mapping
from enum import Enum
from pathlib import Path
from typing import Any
from urllib.parse import unquote, urlsplit

from lsprotocol import types
from pygls.uris import from_fs_path, to_fs_path

from sdfcheck.lint.diagnostic import Diagnostic, Severity
from sdfcheck.lint.fix import TextEdit
from sdfcheck.lsp.workspace import Workspace
from sdfcheck.source.record import NamedTuple
from sdfcheck.source.text import Source, Span

# Places as editors count them: lines from 0, columns in the units that client and server agreed on.


class Units(Enum):
    """The units of a column, by the names of the protocol."""

    UTF8 = "utf-8"
    UTF16 = "utf-16"
    UTF32 = "utf-32"

    def width(self, text: str) -> int:
        """How many units a text takes."""
        if self is Units.UTF32 or text.isascii():
            return len(text)
        if self is Units.UTF8:
            return len(text.encode("utf-8", "surrogatepass"))
        return len(text.encode("utf-16-le", "surrogatepass")) // 2

    def cut(self, text: str, width: int) -> int:
        """How many characters of a text fill so many units; a character that is cut in two does not count."""
        if self is Units.UTF32 or text.isascii():
            return min(width, len(text))
        used = 0
        for number, character in enumerate(text):
            used += self.width(character)
            if used > width:
                return number
        return len(text)


class Place(NamedTuple):
    """A line and a column, both from 0."""

    line: int
    column: int


class Change(NamedTuple):
    """A new text for a range of the old one; without a range, for all of it."""

    text: str
    start: Place | None = None
    end: Place | None = None


def place_of(source: Source, offset: int, units: Units) -> Place:
    """Where a character is."""
    line, column = source.position(offset)
    if column == 1 or units is Units.UTF32:
        return Place(line - 1, column - 1)
    return Place(line - 1, units.width(source.text[offset - column + 1 : offset]))


def offset_of(source: Source, place: Place, units: Units) -> int:
    """The character at a place; past the end of a line, that end."""
    starts = source.line_starts
    if place.line >= len(starts):
        return len(source.text)
    if place.line < 0:
        return 0
    return starts[place.line] + units.cut(source.line(place.line + 1), max(0, place.column))


def changed(source: Source, changes: Iterable[Change], units: Units) -> tuple[Source, int]:
    """The text after changes, of which each counts on those before it; and how much of its beginning is as it was."""
    kept = len(source.text)
    for text, start, end in changes:
        if start is None or end is None:
            source, kept = Source(source.path, text), 0
            continue
        first, last = sorted((offset_of(source, start, units), offset_of(source, end, units)))
        source = source.edited(first, last, text)
        kept = min(kept, first)
    return source, kept


NAME = "sdfcheck"
_NOT_ENCODED = re.compile("[\ud800-\udfff]")

_SEVERITIES = {
    Severity.ERROR: types.DiagnosticSeverity.Error,
    Severity.WARNING: types.DiagnosticSeverity.Warning,
    Severity.INFO: types.DiagnosticSeverity.Information,
}


def path_of(uri: str) -> Path:
    """The file that a URI means; a text without a file is named after it."""
    try:
        parts = urlsplit(uri)
        path = to_fs_path(uri) if parts.scheme == "file" else None
    except ValueError:  # such as a malformed address of a computer
        return Path("untitled")
    # No file has the character NUL in its name, or one that cannot be encoded, such as half of a pair.
    name = (path or unquote(parts.path.rpartition("/")[2]) or "untitled").replace("\0", "\ufffd")
    try:
        os.fsencode(name)
    except UnicodeEncodeError:
        name = _NOT_ENCODED.sub("\ufffd", name)
    return Path(name)


def plain(value: Any) -> Any:
    """A mapping from an object that the protocol library made of it."""
    if hasattr(value, "_asdict"):
        value = value._asdict()
    if isinstance(value, Mapping):
        return {str(key): plain(each) for key, each in value.items()}
    if isinstance(value, list | tuple):
        return [plain(each) for each in value]
    return value


class Written:
    """A long answer as the protocol writes it; making objects of all of it would take long."""

    __slots__ = ("text",)

    def __init__(self, text: str) -> None:
        self.text = text


class ProtocolTypes:
    """The agreement of the client and the server: units, and the features of the client."""

    def __init__(self, workspace: Workspace) -> None:
        self.workspace = workspace
        self.units = Units.UTF16
        self.client = types.ClientCapabilities()

    # Places

    def uri(self, path: Path) -> str:
        """The name of a file for the client; of an open one as the client wrote it."""
        return self._uri(self.workspace.key(path), path)

    def _uri(self, key: str, path: Path) -> str:
        buffer = self.workspace.buffers.get(key)
        return buffer.uri if buffer is not None else str(from_fs_path(os.path.abspath(path)))

    def position(self, source: Source, offset: int) -> types.Position:
        return types.Position(*place_of(source, offset, self.units))

    def range(self, span: Span) -> types.Range:
        source = span.source
        return types.Range(self.position(source, span.start), self.position(source, span.end))

    def location(self, span: Span) -> types.Location:
        source = span.source
        return types.Location(self._uri(source.real_path, source.path), self.range(span))

    def offset(self, source: Source, position: types.Position) -> int:
        return offset_of(source, Place(position.line, position.character), self.units)

    def span(self, source: Source, given: types.Range) -> Span:
        return source.span(self.offset(source, given.start), self.offset(source, given.end))

    def changes(self, given: Iterable[types.TextDocumentContentChangeEvent]) -> list[Change]:
        """The changes of a text, as the client reports them."""
        return [
            Change(
                change.text,
                Place(change.range.start.line, change.range.start.character),
                Place(change.range.end.line, change.range.end.character),
            )
            if isinstance(change, types.TextDocumentContentChangePartial)
            else Change(change.text)
            for change in given
        ]

    # Edits

    def text_edits(self, edits: Iterable[TextEdit]) -> list[types.TextEdit]:
        return [types.TextEdit(self.range(edit.span), edit.text) for edit in edits]

    def workspace_edit(self, edits: Iterable[TextEdit]) -> types.WorkspaceEdit:
        """Edits in any number of files; with the versions that they are meant for, where the client takes them."""
        by_path: dict[str, list[TextEdit]] = {}
        for edit in edits:
            by_path.setdefault(self.workspace.key(edit.span.source.path), []).append(edit)
        able = self.client.workspace.workspace_edit if self.client.workspace else None
        if able is not None and able.document_changes:
            return types.WorkspaceEdit(
                document_changes=[self._versioned(Path(key), own) for key, own in sorted(by_path.items())]
            )
        return types.WorkspaceEdit(
            changes={self.uri(Path(key)): self.text_edits(own) for key, own in sorted(by_path.items())}
        )

    def _versioned(self, path: Path, edits: list[TextEdit]) -> types.TextDocumentEdit:
        buffer = self.workspace.buffers.get(self.workspace.key(path))
        identifier = types.OptionalVersionedTextDocumentIdentifier(
            uri=self.uri(path), version=buffer.version if buffer is not None else None
        )
        return types.TextDocumentEdit(identifier, list(self.text_edits(edits)))

    # Diagnostics

    def diagnostic(self, found: Diagnostic) -> types.Diagnostic:
        related = [(label.span, label.text) for label in found.labels]
        related += [(origin.span, origin.text) for origin in found.origins]
        message = found.message if found.help is None else f"{found.message}\nhelp: {found.help}"
        facts = self.workspace.facts(found.span.source.path).get(found.code)
        page = facts.page if facts is not None else None
        return types.Diagnostic(
            range=self.range(found.span),
            message=message,
            severity=_SEVERITIES[found.severity],
            code=found.code,
            code_description=types.CodeDescription(page) if page else None,
            source=NAME,
            tags=_tags(found) or None,
            related_information=[
                types.DiagnosticRelatedInformation(self.location(span), text) for span, text in related
            ]
            or None,
            data={"name": found.name},
        )

    def is_able(self, *steps: str) -> bool:
        """Does the client understand something? ``steps`` lead to it in its capabilities."""
        at: object = self.client
        for step in steps:
            at = getattr(at, step, None)
            if not at:
                return False
        return True


def _tags(found: Diagnostic) -> list[types.DiagnosticTag]:
    """Unused names are shown faded, old spellings struck through."""
    words = set(found.name.split("-"))
    tags = []
    if words & {"unused", "ignored", "redundant", "unread"}:
        tags.append(types.DiagnosticTag.Unnecessary)
    if words & {"deprecated", "outdated"}:
        tags.append(types.DiagnosticTag.Deprecated)
    return tags

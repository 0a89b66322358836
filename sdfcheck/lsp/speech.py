"""From the project's own values to those of the protocol, and back."""

from __future__ import annotations

import os
import re
from collections.abc import Iterable, Mapping
from pathlib import Path
from typing import Any
from urllib.parse import unquote, urlsplit

from lsprotocol import types
from pygls.uris import from_fs_path, to_fs_path

from sdfcheck.lint.diagnostic import Diagnostic, Severity
from sdfcheck.lint.fix import TextEdit
from sdfcheck.lsp.positions import Change, Place, Units, offset_of, place_of
from sdfcheck.lsp.workspace import Workspace
from sdfcheck.source.text import Source, Span

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


class Speech:
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

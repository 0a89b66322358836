"""The part of an editor in a session with the real server: texts, what it shows for them, edits that it applies."""

from __future__ import annotations

import asyncio
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

from lsprotocol import types
from pytest_lsp import LanguageClient

PATIENCE = 60.0
"""How long something may take before a test fails, in s."""


class Session:
    """One client and one server; ``folder`` is the workspace."""

    def __init__(self, client: LanguageClient, folder: Path) -> None:
        self.client = client
        self.folder = folder
        self.texts: dict[str, Text] = {}
        self.published: list[types.PublishDiagnosticsParams] = []
        self.registered: list[types.Registration] = []
        self.refreshed: list[str] = []
        """The requests that the server let the client make again."""
        self.answer: types.InitializeResult | None = None

    @property
    def encoding(self) -> str:
        """In what columns are counted."""
        assert self.answer is not None
        return str(self.answer.capabilities.position_encoding or "utf-16")

    @property
    def pulls(self) -> bool:
        """Does the client ask for the diagnostics of what is open?"""
        assert self.client.capabilities is not None
        able = self.client.capabilities.text_document
        return able is not None and able.diagnostic is not None

    @property
    def can_show(self) -> bool:
        """Does the client show documents when the server asks for it?"""
        assert self.client.capabilities is not None
        able = self.client.capabilities.window
        return able is not None and able.show_document is not None and able.show_document.support

    def open(self, path: Path, text: str, *, save: bool = True) -> Text:
        """Show a text."""
        if save:
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_bytes(text.encode())
        shown = self.texts[path.as_uri()] = Text(self, path, text)
        item = types.TextDocumentItem(shown.uri, "sdf", shown.version, text)
        self.client.text_document_did_open(types.DidOpenTextDocumentParams(item))
        return shown

    def close(self, text: Text) -> None:
        del self.texts[text.uri]
        self.client.text_document_did_close(types.DidCloseTextDocumentParams(text.identifier))

    def pushed(self, path: Path) -> list[types.Diagnostic]:
        """The last message about a file."""
        found = [params for params in self.published if params.uri == path.as_uri()]
        return list(found[-1].diagnostics) if found else []

    async def waited(self, test: Callable[[], bool]) -> None:
        """Come back when something is so."""
        end = time.monotonic() + PATIENCE
        while not test():
            assert time.monotonic() < end, "that did not happen"
            await asyncio.sleep(0.01)

    def notice(self, path: Path, kind: types.FileChangeType = types.FileChangeType.Changed) -> None:
        """Report that a file has changed."""
        event = types.FileEvent(path.as_uri(), kind)
        self.client.workspace_did_change_watched_files(types.DidChangeWatchedFilesParams([event]))

    async def raw(self, method: str, params: object) -> Any:
        """The answer to a request that the library would not send."""
        protocol = self.client.protocol
        future: Any = asyncio.get_running_loop().create_future()
        protocol._request_futures["raw"] = future
        protocol._send_data({"jsonrpc": "2.0", "id": "raw", "method": method, "params": params})
        return await asyncio.wait_for(future, PATIENCE)

    def choose(self, **settings: object) -> None:
        """Change the settings of the client."""
        self.client.set_configuration({"sdfcheck": settings})
        self.client.workspace_did_change_configuration(
            types.DidChangeConfigurationParams({"sdfcheck": settings})
        )

    def applied(self, edit: types.WorkspaceEdit | None) -> dict[str, str]:
        """The texts that edits make, by the names of their files."""
        assert edit is not None
        by_uri: dict[str, list[types.TextEdit]] = {
            uri: list(own) for uri, own in (edit.changes or {}).items()
        }
        for change in edit.document_changes or ():
            assert isinstance(change, types.TextDocumentEdit)
            shown = self.texts.get(change.text_document.uri)
            assert change.text_document.version in {None, shown.version if shown is not None else None}
            own = [each for each in change.edits if isinstance(each, types.TextEdit)]
            by_uri.setdefault(change.text_document.uri, []).extend(own)
        return {Path(uri.rpartition("/")[2]).name: self._edited(uri, own) for uri, own in by_uri.items()}

    def _edited(self, uri: str, edits: list[types.TextEdit]) -> str:
        shown = self.texts.get(uri)
        text = shown.text if shown is not None else Path(uri.removeprefix("file://")).read_bytes().decode()
        places = sorted(
            (offset(text, edit.range.start, self.encoding), offset(text, edit.range.end, self.encoding), edit)
            for edit in edits
        )
        for first, last, edit in reversed(places):
            text = text[:first] + edit.new_text + text[last:]
        return text


class Text:
    """A text that is shown."""

    def __init__(self, session: Session, path: Path, text: str) -> None:
        self.session = session
        self.client = session.client
        self.path = path
        self.uri = path.as_uri()
        self.text = text
        self.version = 1

    @property
    def identifier(self) -> types.TextDocumentIdentifier:
        return types.TextDocumentIdentifier(self.uri)

    def position(self, mark: str, skip: int = 0) -> types.Position:
        """Where a piece of the text begins."""
        return position(self.text, self.text.index(mark) + skip, self.session.encoding)

    def range(self, mark: str, skip: int = 0, length: int | None = None) -> types.Range:
        """Where a piece of the text is."""
        start = self.text.index(mark) + skip
        end = start + (len(mark) - skip if length is None else length)
        return types.Range(*(position(self.text, each, self.session.encoding) for each in (start, end)))

    def cut(self, given: types.Range) -> str:
        """The text in a range."""
        encoding = self.session.encoding
        return self.text[offset(self.text, given.start, encoding) : offset(self.text, given.end, encoding)]

    def at(self, mark: str, skip: int = 0) -> dict[str, Any]:
        """The parameters that most requests share."""
        return {"text_document": self.identifier, "position": self.position(mark, skip)}

    def change(self, old: str, new: str) -> None:
        """Type: the client sends only what changes."""
        where = self.range(old)
        self.text = self.text.replace(old, new, 1)
        self.version += 1
        self.client.text_document_did_change(
            types.DidChangeTextDocumentParams(
                types.VersionedTextDocumentIdentifier(self.version, self.uri),
                [types.TextDocumentContentChangePartial(range=where, text=new)],
            )
        )

    def replace(self, text: str) -> None:
        """Give it another text as a whole."""
        self.text = text
        self.version += 1
        self.client.text_document_did_change(
            types.DidChangeTextDocumentParams(
                types.VersionedTextDocumentIdentifier(self.version, self.uri),
                [types.TextDocumentContentChangeWholeDocument(text)],
            )
        )

    async def diagnostics(
        self, test: Callable[[list[types.Diagnostic]], object] = bool
    ) -> list[types.Diagnostic]:
        """The text that the client shows, once it is as expected."""
        end = time.monotonic() + PATIENCE
        while not test(found := await self._diagnostics()):
            assert time.monotonic() < end, found
            await asyncio.sleep(0.01)
        return found

    async def _diagnostics(self) -> list[types.Diagnostic]:
        if not self.session.pulls:
            return self.session.pushed(self.path)
        report = await self.client.text_document_diagnostic_async(
            types.DocumentDiagnosticParams(self.identifier)
        )
        assert isinstance(report, types.RelatedFullDocumentDiagnosticReport)
        return list(report.items)

    async def actions(self, where: types.Range, *kinds: str) -> list[types.CodeAction]:
        """The actions that are offered in a range, with the edits that the client has to ask for."""
        found = await self.client.text_document_code_action_async(
            types.CodeActionParams(
                self.identifier, where, types.CodeActionContext([], only=list(kinds) or None)
            )
        )
        actions = [action for action in found or () if isinstance(action, types.CodeAction)]
        return [
            action if action.edit is not None else await self.client.code_action_resolve_async(action)
            for action in actions
        ]

    async def hover(self, mark: str, skip: int = 0) -> str:
        """The hover text of a place."""
        found = await self.client.text_document_hover_async(types.HoverParams(**self.at(mark, skip)))
        if found is None:
            return ""
        assert isinstance(found.contents, types.MarkupContent)
        return found.contents.value

    async def completion(self, mark: str, skip: int = 0) -> dict[str, types.CompletionItem]:
        """The items that are offered at a place, by their labels."""
        found = await self.client.text_document_completion_async(
            types.CompletionParams(**self.at(mark, skip))
        )
        assert isinstance(found, types.CompletionList)
        return {item.label: item for item in found.items}

    async def rename(self, mark: str, skip: int, name: str) -> dict[str, str]:
        """The texts of the files in which something has another name."""
        edit = await self.client.text_document_rename_async(
            types.RenameParams(new_name=name, **self.at(mark, skip))
        )
        return self.session.applied(edit)


def position(text: str, at: int, encoding: str) -> types.Position:
    """The place of a character, as the protocol counts."""
    line = text.count("\n", 0, at)
    before = text[text.rfind("\n", 0, at) + 1 : at]
    column = {"utf-8": len(before.encode()), "utf-16": len(before.encode("utf-16-le")) // 2}
    return types.Position(line, column.get(encoding, len(before)))


def offset(text: str, at: types.Position, encoding: str) -> int:
    """The character at a place."""
    lines = text.split("\n")
    start = sum(len(line) + 1 for line in lines[: at.line])
    if encoding == "utf-32":
        return start + at.character
    width, codec = (1, "utf-8") if encoding == "utf-8" else (2, "utf-16-le")
    return start + len(lines[at.line].encode(codec)[: width * at.character].decode(codec))

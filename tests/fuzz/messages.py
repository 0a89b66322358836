"""Random messages to the language server: methods, parameters and addresses that it knows and that nobody has.

Every request must be answered, whatever came before, and memory must not grow with the number of messages.
"""

from __future__ import annotations

import json
import os
import time
from collections.abc import Iterator
from pathlib import Path
from random import Random
from typing import Any

from tests.fuzz.documents import NAMES, PIECES, fixtures
from tests.fuzz.language_server import Ended, LanguageServer

DEEP = 2000
"""The depth of the deepest folder whose files are opened, where the longest path of the system allows it."""
_LONGEST = 4096 - 32
BURST = 8
_ABOUT_A_TEXT = """
    hover completion definition references documentHighlight prepareRename rename diagnostic documentSymbol
    foldingRange documentLink semanticTokens/full semanticTokens/range inlayHint codeAction formatting nothing
""".split()
_ELSEWHERE = (
    *(
        "workspace/symbol",
        "workspace/executeCommand",
        "workspace/diagnostic",
        "codeAction/resolve",
        "nothing",
    ),
    *("$/nothing", "", "textDocument", "workspace/didChangeConfiguration"),
)
_NOTICES = """
    textDocument/didOpen textDocument/didOpen textDocument/didOpen textDocument/didOpen textDocument/didChange
    textDocument/didChange textDocument/didChange textDocument/didClose textDocument/didClose textDocument/didClose
    textDocument/didSave $/cancelRequest $/setTrace $/nothing
""".split()
_RARE_NOTICES = """
    workspace/didChangeWatchedFiles workspace/didChangeConfiguration workspace/didChangeWorkspaceFolders
""".split()
"""After these everything is read again."""
_NUMBERS: tuple[Any, ...] = (0, 1, 5, -1, 2**31 - 1, 2**31, 2**53, 10**30, 1.5, "1", None, [], True)
_ODD: tuple[Any, ...] = (None, 0, "text", [], {}, {"uri": 1}, {"uri": None}, [{}], "\ud83d", {"a": {"b": []}})
_RAW = (
    b"{",
    b"null",
    b"[]",
    b"7",
    b'{"jsonrpc":"2.0"}',
    b'{"jsonrpc":"2.0","method":"\xff\xfe","id":0}',
    b"\xc3",
)


class Storm:
    """A sequence of messages by a seed, about files in a folder, and some very deep beside it."""

    def __init__(self, folder: Path, seed: int) -> None:
        self.chance = Random(seed)
        self.folder = folder / "robots"
        self.folder.mkdir()
        depth = min(DEEP, (_LONGEST - len(os.fspath(folder))) // len("/d"))
        self.deep = _made(folder, depth)
        texts = [text for text in fixtures() if len(text.data) < 4000]
        self.texts = [each.data.decode("utf-8", "replace") for each in self.chance.sample(texts, 30)]
        self.uris = [
            *(
                (folder / f"{name}{suffix}").as_uri()
                for name in "abc"
                for suffix in (".sdf", ".urdf", ".xacro")
            ),
            *((each / "m.sdf").as_uri() for each in (self.deep, self.deep.parents[depth // 2])),
            *(
                "file:///a%00b/m.sdf",
                "file:///%00",
                "untitled:a%00b.sdf",
                "file:///a/%FF%C3.urdf",
                "file://[",
            ),
            *(
                "untitled:Untitled-1",
                "http://example.org/a.sdf",
                "",
                "\ud83d.sdf",
                "file:///" + "x" * 5000 + ".sdf",
            ),
            self.folder.as_uri(),
        ]

    def close(self) -> None:
        """Remove the deep folder: what removes whole trees calls itself."""
        at = self.deep
        while at != self.folder.parent:
            at.rmdir()
            at = at.parent

    def messages(self) -> Iterator[tuple[int | None, bytes]]:
        """The number of a request, None for what has no answer, and the message; without end."""
        number = 0
        while True:
            kind = self.chance.random()
            if kind < 0.03:
                yield None, self.chance.choice(_RAW)
            elif kind < 0.45:
                method = self._of(_RARE_NOTICES if self.chance.random() < 0.03 else _NOTICES)
                yield None, _written({"method": method, "params": self._params()})
            else:
                number += 1
                about = self.chance.random() < 0.9
                method = f"textDocument/{self._of(_ABOUT_A_TEXT)}" if about else self._of(_ELSEWHERE)
                yield number, _written({"id": number, "method": method, "params": self._params()})

    def _of(self, values: Any) -> Any:
        return self.chance.choice(values)

    def _params(self) -> Any:
        if self.chance.random() < 0.1:
            return self._of(_ODD)
        document = {
            "uri": self._of(self.uris),
            "languageId": "xml",
            "version": self._number(),
            "text": self._text(),
        }
        start, end = self._position(), self._position()
        params: dict[str, Any] = {
            "textDocument": document,
            "position": start,
            "range": {"start": start, "end": end},
            "context": {"diagnostics": [], "includeDeclaration": True, "triggerKind": 1},
            "newName": self._of(NAMES),
            "query": self._of(NAMES),
            "contentChanges": self._changes(start, end),
            "changes": [{"uri": self._of(self.uris), "type": self._number()}],
            "event": {"added": [self._root()], "removed": [self._root()]},
            "settings": self._of((*_ODD, {"sdfcheck": {"select": self._of((*_ODD, "ALL", "XML"))}})),
            "id": self.chance.randint(1, 100),
            "value": "off",
            "title": "",
            "command": "nothing",
        }
        if self.chance.random() < 0.15:
            params[self._of(sorted(params))] = self._of(_ODD)
        if self.chance.random() < 0.1:
            del params[self._of(sorted(params))]
        return params

    def _number(self) -> Any:
        return self.chance.randint(0, 40) if self.chance.random() < 0.8 else self._of(_NUMBERS)

    def _position(self) -> Any:
        return {"line": self._number(), "character": self._number()}

    def _root(self) -> dict[str, str]:
        return {"uri": self._of((self.folder.as_uri(), *self.uris[-8:])), "name": "x"}

    def _text(self) -> str:
        text: str = self._of(self.texts)
        if self.chance.random() < 0.5:
            at = self.chance.randint(0, len(text))
            text = text[:at] + self._of(PIECES)[:300] + text[at + self.chance.randint(0, 20) :]
        return text

    def _changes(self, start: Any, end: Any) -> list[Any]:
        if self.chance.random() < 0.3:
            return [{"text": self._text()}]
        return [{"range": {"start": start, "end": end}, "text": self._of(PIECES)[:300]}]


def _made(folder: Path, depth: int) -> Path:
    for _ in range(depth):
        folder = folder / "d"
        os.mkdir(folder)
    return folder


def _written(message: dict[str, Any]) -> bytes:
    return json.dumps({"jsonrpc": "2.0", **message}).encode()


class Unanswered(Exception):
    """Requests without an answer, or a server that has ended; the words say which."""


def weather(folder: Path, seed: int, count: int, marks: tuple[int, ...] = ()) -> list[int]:
    """Send so many messages; returns the memory of the server after some of them, in bytes. Raises Unanswered.

    After the last message the server must still answer a question about a sound text.
    """
    storm = Storm(folder, seed)
    server = LanguageServer(storm.folder)
    sizes: list[int] = []
    try:
        waiting: set[int] = set()
        for sent, (number, message) in zip(range(1, count + 1), storm.messages(), strict=False):
            server.send_raw(message)
            if number is not None:
                waiting.add(number)
            if sent % BURST == 0 or sent == count:
                _answers(server, waiting)
            if sent in marks:
                sizes.append(_memory(server))
        _still_works(server, folder)
    except Ended:
        code = server.process.poll()
        words = f"no answer to {sorted(waiting)[:5]}: the server has exit code {code}; {server.end}"
        raise Unanswered(words) from None
    finally:
        server.close()
        storm.close()
    if failure := server.complaint():
        raise Unanswered(failure.story[-3000:])
    return sizes


def _answers(server: LanguageServer, waiting: set[int]) -> None:
    """Wait for the answers to all requests."""
    server.expect()
    while waiting:
        message = server.next_message()
        if "method" not in message:
            waiting.discard(message.get("id"))
    server.expect(nothing=True)


def _still_works(server: LanguageServer, folder: Path) -> None:
    uri = (folder / "last.sdf").as_uri()
    text = '<sdf version="1.9"><model name="m"><link name="l"/></model></sdf>'
    opened = {"uri": uri, "languageId": "xml", "version": 1, "text": text}
    server.notify("textDocument/didOpen", {"textDocument": opened})
    asked = {"textDocument": {"uri": uri}}
    if not server.request("textDocument/documentSymbol", asked):
        raise Unanswered("a sound text has no symbols at the end")


def _memory(server: LanguageServer) -> int:
    """The memory of the server once it is idle, in bytes."""
    time.sleep(7)  # it collects garbage when nothing has come for 5 s
    return server.memory

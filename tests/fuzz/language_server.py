"""A language server that is asked about one text after the other."""

from __future__ import annotations

import json
import os
import subprocess
import sys
import threading
import time
from pathlib import Path
from typing import Any

import pytest

from tests.fuzz.commands import Failure

if sys.platform == "win32":
    pytest.skip("works on POSIX only", allow_module_level=True)

_AT_A_PLACE = (
    "hover",
    "completion",
    "definition",
    "references",
    "documentHighlight",
    "prepareRename",
    "rename",
)
_OF_A_TEXT = ("diagnostic", "documentSymbol", "foldingRange", "documentLink", "semanticTokens/full")
_CAPABILITIES: dict[str, object] = {"textDocument": {"diagnostic": {}, "publishDiagnostics": {}}}


SECONDS = 10
"""Processor time of one answer; what the clock shows may be much more on a busy machine."""
AT_MOST = 300


class Ended(Exception):
    """The server has gone."""


class LanguageServer:
    """A child process, and what it says."""

    def __init__(self, folder: Path, capabilities: dict[str, object] = _CAPABILITIES) -> None:
        command = [sys.executable, "-m", "sdfcheck", "server"]
        self.process = subprocess.Popen(
            command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL
        )
        self._number = 0
        self.received = self.spent = 0.0
        """When the last message was there, before it was decoded, of ``time.perf_counter``; ``computed`` then."""
        self.end = ""
        """Why the process was ended from outside."""
        self._complaints: list[str] = []
        self._asked: tuple[float, float] | None = None
        threading.Thread(target=self._watch, daemon=True).start()
        self.request(
            "initialize", {"processId": None, "rootUri": folder.as_uri(), "capabilities": capabilities}
        )
        self.notify("initialized", {})

    def close(self) -> None:
        self.process.kill()
        self.process.communicate()

    def _watch(self) -> None:
        """End the process if it does not answer."""
        while self.process.poll() is None:
            asked = self._asked
            if asked is not None:
                computed, passed = self._times()
                if computed - asked[0] > SECONDS or passed - asked[1] > AT_MOST:
                    self.end = f"ended after {computed - asked[0]:.0f} s of computing, {passed - asked[1]:.0f} s in all"
                    self.process.kill()
            time.sleep(1)

    @property
    def computed(self) -> float:
        """The processor time of the process so far, in s."""
        return self._times()[0]

    @property
    def memory(self) -> int:
        """The resident memory of the process, in bytes; Linux says it."""
        pages = int(Path(f"/proc/{self.process.pid}/statm").read_text().split()[1])
        return pages * os.sysconf("SC_PAGE_SIZE")

    def _times(self) -> tuple[float, float]:
        """The processor time of the process, where the system says it, and the clock, in s."""
        try:
            fields = Path(f"/proc/{self.process.pid}/stat").read_text().rpartition(")")[2].split()
        except OSError:
            return 0.0, time.monotonic()
        return sum(map(int, fields[11:13])) / os.sysconf("SC_CLK_TCK"), time.monotonic()

    def send(self, message: dict[str, Any]) -> None:
        self.send_raw(json.dumps({"jsonrpc": "2.0", **message}).encode())

    def send_raw(self, data: bytes) -> None:
        """Send a message that may be none."""
        assert self.process.stdin
        try:
            self.process.stdin.write(b"Content-Length: %d\r\n\r\n%s" % (len(data), data))
            self.process.stdin.flush()
        except OSError:
            raise Ended from None

    def receive(self) -> dict[str, Any]:
        assert self.process.stdout
        length = 0
        while (line := self.process.stdout.readline().strip()) or not length:
            if line.lower().startswith(b"content-length:"):
                length = int(line.partition(b":")[2])
            elif not line:
                raise Ended
        data = self.process.stdout.read(length)
        self.received, self.spent = time.perf_counter(), self.computed
        message: dict[str, Any] = json.loads(data)
        return message

    def notify(self, method: str, params: object) -> None:
        self.send({"method": method, "params": params})

    def request(self, method: str, params: object) -> Any:
        """The result of a request; what the server says meanwhile is looked at."""
        self._number += 1
        number = f"own {self._number}"
        self.expect()
        self.send({"id": number, "method": method, "params": params})
        while True:
            message = self.next_message()
            if message.get("id") == number and "method" not in message:
                error = message.get("error")
                if error is not None and error["code"] == -32603:
                    self._complaints.append(f"{method}: {json.dumps(error)}")
                self.expect(nothing=True)
                return message.get("result")

    def expect(self, *, nothing: bool = False) -> None:
        """From now on the process is ended if it computes for too long."""
        self._asked = None if nothing else self._times()

    def next_message(self) -> dict[str, Any]:
        """The next message of the server; its requests are answered, and its errors are kept."""
        message = self.receive()
        if "method" in message and "id" in message:
            self.send({"id": message["id"], "result": None})
        elif message.get("method") == "window/logMessage" and message["params"]["type"] == 1:
            self._complaints.append(message["params"]["message"])
        return message

    def complaint(self) -> Failure | None:
        """The failures that the server has logged since the last time."""
        found, self._complaints = "\n".join(self._complaints), []
        return Failure(f"server: {found.strip().splitlines()[-1][:80]}", found) if found else None


def converse(server: LanguageServer, file: Path, data: bytes) -> Failure | None:
    """Open a text, ask everything at some places, change it twice, close it."""
    text, uri = data.decode("utf-8", "replace"), file.as_uri()
    document = {"uri": uri}
    opened = {**document, "languageId": "xml", "version": 1, "text": text}
    try:
        server.notify("textDocument/didOpen", {"textDocument": opened})
        _ask(server, uri, text)
        lines = text.split("\n")
        end = {"line": len(lines) // 2, "character": 3}
        change = {"range": {"start": {"line": 0, "character": 1}, "end": end}, "text": '<model name="'}
        for version, edit in ((2, change), (3, {"text": text[: len(text) // 2]})):
            changed = {"textDocument": {**document, "version": version}, "contentChanges": [edit]}
            server.notify("textDocument/didChange", changed)
            _ask(server, uri, text)
        server.notify("textDocument/didClose", {"textDocument": document})
        return server.complaint()
    except Ended:
        return Failure("the server ends, or does not answer", "")


def _ask(server: LanguageServer, uri: str, text: str) -> None:
    document = {"uri": uri}
    for question in _OF_A_TEXT:
        server.request(f"textDocument/{question}", {"textDocument": document})
    lines = text.split("\n")
    for share in (0.3, 0.6, 0.95):
        number = int(len(lines) * share)
        position = {"line": number, "character": len(lines[number]) * 2 // 3}
        for question in _AT_A_PLACE:
            more = {"context": {"includeDeclaration": True}, "newName": "other"}
            params = {"textDocument": document, "position": position, **more}
            if question == "completion":
                params["context"] = {"triggerKind": 1}
            server.request(f"textDocument/{question}", params)
    everything = {"start": {"line": 0, "character": 0}, "end": {"line": len(lines), "character": 0}}
    asked = {"textDocument": document, "range": everything, "context": {"diagnostics": []}}
    server.request("textDocument/codeAction", asked)
    server.request("textDocument/inlayHint", {"textDocument": document, "range": everything})

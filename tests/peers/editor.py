"""An editor as small as can be: a process with the server, the texts that it opens, and what the server asks of it."""

from __future__ import annotations

import json
import subprocess
import sys
import threading
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

PATIENCE = 20.0
"""s"""


class Editor:
    """One session; ``shown`` are the parameters of ``window/showDocument``."""

    def __init__(self, server: subprocess.Popen[bytes]) -> None:
        assert server.stdin is not None
        assert server.stdout is not None
        self._to, self._from = server.stdin, server.stdout
        self._number = 0
        self._answers: dict[int, Any] = {}
        self._versions: dict[str, int] = {}
        self.shown: list[Any] = []
        threading.Thread(target=self._read, daemon=True).start()

    def begin(self, folder: Path) -> None:
        capabilities = {"window": {"showDocument": {"support": True}}}
        self.ask("initialize", processId=None, rootUri=folder.as_uri(), capabilities=capabilities)
        self.notify("initialized")

    def open(self, path: Path, text: str) -> None:
        path.write_text(text)
        self._versions[path.as_uri()] = 1
        item = {"uri": path.as_uri(), "languageId": "xml", "version": 1, "text": text}
        self.notify("textDocument/didOpen", textDocument=item)

    def change(self, path: Path, text: str) -> None:
        uri = path.as_uri()
        self._versions[uri] += 1
        document = {"uri": uri, "version": self._versions[uri]}
        self.notify("textDocument/didChange", textDocument=document, contentChanges=[{"text": text}])

    def command(self, name: str, path: Path, **given: Any) -> Any:
        return self.ask("workspace/executeCommand", command=name, arguments=[{"uri": path.as_uri(), **given}])

    def ask(self, method: str, **params: Any) -> Any:
        self._number += 1
        number = self._number
        self._send(id=number, method=method, params=params)
        waited(lambda: number in self._answers)
        answer = self._answers[number]
        assert "error" not in answer, answer
        return answer["result"]

    def notify(self, method: str, **params: Any) -> None:
        self._send(method=method, params=params)

    def _send(self, **message: Any) -> None:
        body = json.dumps({"jsonrpc": "2.0", **message}).encode()
        self._to.write(b"Content-Length: %d\r\n\r\n" % len(body) + body)
        self._to.flush()

    def _read(self) -> None:
        while line := self._from.readline():
            size = 0
            while line.strip():
                name, _, value = line.partition(b":")
                size = int(value) if name.lower() == b"content-length" else size
                line = self._from.readline()
            message = json.loads(self._from.read(size))
            if "method" not in message:
                self._answers[message["id"]] = message
                continue
            if message["method"] == "window/showDocument":
                self.shown.append(message["params"])
            if "id" in message:
                self._send(id=message["id"], result={"success": True})


def waited(test: Callable[[], object]) -> None:
    """Come back when something is so."""
    end = time.monotonic() + PATIENCE
    while not test():
        assert time.monotonic() < end, "that did not happen"
        time.sleep(0.01)


@contextmanager
def editor(folder: Path) -> Iterator[Editor]:
    """A session with the real server."""
    command = [sys.executable, "-m", "sdfcheck", "server"]
    with subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, cwd=folder) as server:
        try:
            found = Editor(server)
            found.begin(folder)
            yield found
        finally:
            server.kill()

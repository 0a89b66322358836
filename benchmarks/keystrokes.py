"""Types into a file that the language server has open, and measures what the person at the keyboard waits for.

``python -m benchmarks.keystrokes FILE [--rounds 10]`` prints the medians: from a keystroke to the last diagnostics that
it causes, outline, hover and completion after it, by the clock and in processor time of the server, and its memory.
"""

from __future__ import annotations

import argparse
import json
import os
import re
import statistics
import subprocess
import sys
import time
from itertools import count, cycle
from pathlib import Path
from queue import Empty, Queue
from threading import Thread
from typing import Any

QUIET = 1.0
"""Seconds without a message after which the server has said all about a keystroke."""
_VALUE = re.compile(r"(?<=>)\d+\.\d+(?=[ <])|(?<=\")\d+\.\d+(?=[ \"])")


class Server:
    """A server that was started for this, and the messages that it sends."""

    def __init__(self, folder: Path) -> None:
        self.process = subprocess.Popen(
            [sys.executable, "-m", "sdfcheck", "server"], stdin=subprocess.PIPE, stdout=subprocess.PIPE
        )
        self.inbox: Queue[dict[str, Any]] = Queue()
        self._asked = 0
        Thread(target=self._listen, daemon=True).start()
        able = {
            "textDocument": {
                "publishDiagnostics": {},
                "documentSymbol": {"hierarchicalDocumentSymbolSupport": True},
            }
        }
        self.ask("initialize", processId=None, rootUri=folder.as_uri(), capabilities=able)
        self.notify("initialized")

    def notify(self, method: str, **params: object) -> None:
        self._send({"method": method, "params": params})

    def ask(self, method: str, **params: object) -> tuple[float, float]:
        """Ask and wait for the answer; the time by the clock and in the processor, in seconds."""
        self._asked += 1
        begin, computed = time.perf_counter(), self.computed
        self._send({"id": self._asked, "method": method, "params": params})
        while (message := self.inbox.get()).get("id") != self._asked or "method" in message:
            pass
        if "error" in message:
            raise RuntimeError(f"{method}: {message['error']}")
        return message["received"] - begin, self.computed - computed

    def until_quiet(self) -> float:
        """Wait until nothing more comes; the time of the last diagnostics."""
        last = 0.0
        while True:
            try:
                message = self.inbox.get(timeout=QUIET)
            except Empty:
                return last
            if message.get("method") == "textDocument/publishDiagnostics":
                last = message["received"]

    @property
    def computed(self) -> float:
        """The processor time of the server so far, in seconds."""
        fields = Path(f"/proc/{self.process.pid}/stat").read_text().rpartition(")")[2].split()
        return sum(map(int, fields[11:13])) / os.sysconf("SC_CLK_TCK")

    @property
    def memory(self) -> int:
        """The resident memory of the server, in bytes."""
        pages = int(Path(f"/proc/{self.process.pid}/statm").read_text().split()[1])
        return pages * os.sysconf("SC_PAGE_SIZE")

    def close(self) -> None:
        self.process.kill()
        self.process.wait()

    def _send(self, message: dict[str, object]) -> None:
        data = json.dumps({"jsonrpc": "2.0", **message}).encode()
        assert self.process.stdin is not None
        self.process.stdin.write(b"Content-Length: %d\r\n\r\n%s" % (len(data), data))
        self.process.stdin.flush()

    def _listen(self) -> None:
        stream = self.process.stdout
        assert stream is not None
        while head := stream.readline():
            length = int(head.partition(b":")[2])
            while stream.readline().strip():
                pass
            data = stream.read(length)
            received = time.perf_counter()
            message = {**json.loads(data), "received": received}
            if "id" in message and "method" in message:
                self._send({"id": message["id"], "result": None})
            self.inbox.put(message)


class Typist:
    """Writes over one digit of a number in the middle of an open file, and asks."""

    def __init__(self, server: Server, file: Path) -> None:
        text = file.read_text(encoding="utf-8")
        numbers = list(_VALUE.finditer(text))
        at = numbers[len(numbers) // 2].end() - 1
        self.place = {"line": text.count("\n", 0, at), "character": at - text.rfind("\n", 0, at) - 1}
        self.file = {"uri": file.as_uri()}
        self.server = server
        self.seconds: dict[str, list[float]] = {}
        """The seconds of each round, by name of what was measured."""
        self._letters = cycle("1x23x4x56x7x89x0")
        self._versions = count(1)
        opened = {**self.file, "languageId": "xml", "version": next(self._versions), "text": text}
        server.notify("textDocument/didOpen", textDocument=opened)
        server.until_quiet()

    def type_one(self) -> None:
        over = {"start": self.place, "end": {**self.place, "character": self.place["character"] + 1}}
        self.server.notify(
            "textDocument/didChange",
            textDocument={**self.file, "version": next(self._versions)},
            contentChanges=[{"range": over, "text": next(self._letters)}],
        )

    def ask(self, name: str, method: str, **where: object) -> None:
        waited, computed = self.server.ask(f"textDocument/{method}", textDocument=self.file, **where)
        self.note(name, waited)
        self.note(f"{name}, processor", computed)

    def note(self, name: str, seconds: float) -> None:
        self.seconds.setdefault(name, []).append(seconds)

    def round(self) -> None:
        begin = time.perf_counter()
        self.type_one()
        if last := self.server.until_quiet():
            self.note("diagnostics", last - begin)
        self.ask("outline, unchanged", "documentSymbol")
        for name, method, where in (
            ("outline", "documentSymbol", {}),
            ("folding", "foldingRange", {}),
            ("hover", "hover", {"position": self.place}),
            ("completion", "completion", {"position": self.place}),
        ):
            self.type_one()
            self.ask(name, method, **where)
            self.server.until_quiet()


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("file", type=Path)
    parser.add_argument("--rounds", type=int, default=10)
    choice = parser.parse_args()
    file = choice.file.resolve()
    server = Server(file.parent)
    try:
        typist = Typist(server, file)
        for _ in range(choice.rounds):
            typist.round()
        for name, seconds in typist.seconds.items():
            print(f"{name:28} {statistics.median(seconds) * 1000:6.1f} ms, at most {max(seconds) * 1000:.1f}")
        print(f"{'memory':28} {server.memory / 1e6:6.1f} MB")
    finally:
        server.close()


if __name__ == "__main__":
    main()

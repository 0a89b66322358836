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
from itertools import cycle
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
        self.tell("initialized")

    def tell(self, method: str, **params: object) -> None:
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


def type_into(file: Path, rounds: int) -> dict[str, list[float]]:
    """Change one digit of a number in the middle of a file, and ask; seconds by name of what was measured."""
    text = file.read_text(encoding="utf-8")
    numbers = list(_VALUE.finditer(text))
    at = numbers[len(numbers) // 2].end() - 1
    line, column = text.count("\n", 0, at), at - text.rfind("\n", 0, at) - 1
    place = {"line": line, "character": column}
    of_file = {"uri": file.as_uri()}
    found: dict[str, list[float]] = {}

    def note(name: str, seconds: float) -> None:
        found.setdefault(name, []).append(seconds)

    server = Server(file.parent)
    try:
        server.tell(
            "textDocument/didOpen", textDocument={**of_file, "languageId": "xml", "version": 1, "text": text}
        )
        server.until_quiet()
        letters = cycle("1x23x4x56x7x89x0")

        def type_one(version: int) -> None:
            over = {"start": place, "end": {**place, "character": column + 1}}
            server.tell(
                "textDocument/didChange",
                textDocument={**of_file, "version": version},
                contentChanges=[{"range": over, "text": next(letters)}],
            )

        for number in range(rounds):
            begin = time.perf_counter()
            type_one(number)
            if last := server.until_quiet():
                note("diagnostics, whole", last - begin)
            for name, method in (("outline", "documentSymbol"), ("outline again", "documentSymbol")):
                waited, computed = server.ask(f"textDocument/{method}", textDocument=of_file)
                note(f"unchanged, {name}", waited)
                note(f"unchanged, {name}, processor", computed)
            for name, method, where in (
                ("outline", "documentSymbol", {}),
                ("folding", "foldingRange", {}),
                ("hover", "hover", {"position": place}),
                ("completion", "completion", {"position": place}),
            ):
                type_one(number)
                waited, computed = server.ask(f"textDocument/{method}", textDocument=of_file, **where)
                note(name, waited)
                note(f"{name}, processor", computed)
                server.until_quiet()
        note("memory, MB", server.memory / 1e6)
    finally:
        server.close()
    return found


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("file", type=Path)
    parser.add_argument("--rounds", type=int, default=10)
    choice = parser.parse_args()
    for name, values in type_into(choice.file.resolve(), choice.rounds).items():
        scale, unit = (1, "") if name.startswith("memory") else (1000, " ms")
        print(f"{name:24} {statistics.median(values) * scale:8.1f}{unit}   at most {max(values) * scale:.1f}")


if __name__ == "__main__":
    main()

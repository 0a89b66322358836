"""Types into a file that the language server has open, and measures what the person at the keyboard waits for.

``python -m benchmarks.keystrokes FILE [--rounds 10] [--edits 0]`` prints the outline when the file is opened, and the
medians: from a keystroke to the last diagnostics that it causes, outline, hover and completion after it, by the clock
and in processor time of the server. With ``--edits`` somebody then types so often without a pause, and asks between.
In the end the memory of the server is printed.
"""

from __future__ import annotations

import argparse
import re
import statistics
import time
from contextlib import suppress
from itertools import count, cycle
from pathlib import Path
from queue import Empty, Queue
from threading import Thread
from typing import Any, NamedTuple

from tests.fuzz.language_server import Ended, LanguageServer

QUIET = 1.0
"""Seconds without a message after which the server has said all about a keystroke."""
_CAPABILITIES: dict[str, object] = {
    "textDocument": {"publishDiagnostics": {}, "documentSymbol": {"hierarchicalDocumentSymbolSupport": True}}
}
_ASKED = ("hover", "completion")
_VALUE = re.compile(r"(?<=>)\d+\.\d+(?=[ <])|(?<=\")\d+\.\d+(?=[ \"])")


class Times(NamedTuple):
    """The time by the clock, and that in the processor, in seconds."""

    clock: float
    processor: float

    def since(self, begin: Times) -> Times:
        return Times(self.clock - begin.clock, self.processor - begin.processor)


class Server:
    """A server that was started for this, and the messages that it sends, each with the time when it came."""

    def __init__(self, folder: Path) -> None:
        self._server = LanguageServer(folder, _CAPABILITIES)
        self._inbox: Queue[tuple[Times, dict[str, Any]] | None] = Queue()
        """None: the server has gone."""
        self._asked = 0
        self._listener = Thread(target=self._listen, daemon=True)
        self._listener.start()

    def notify(self, method: str, **params: object) -> None:
        self._server.notify(method, params)

    def ask(self, method: str, **params: object) -> Times:
        """Ask and wait for the answer; the time that it took."""
        self._asked += 1
        begin = self.now
        self._server.send({"id": self._asked, "method": method, "params": params})
        while True:
            received, message = self._next()
            if message.get("id") == self._asked and "method" not in message:
                break
        if "error" in message:
            raise RuntimeError(f"{method}: {message['error']}")
        return received.since(begin)

    def until_quiet(self) -> Times | None:
        """Wait until nothing more comes; the time of the last diagnostics."""
        last = None
        while True:
            try:
                received, message = self._next(QUIET)
            except Empty:
                return last
            if message.get("method") == "textDocument/publishDiagnostics":
                last = received

    @property
    def now(self) -> Times:
        return Times(time.perf_counter(), self._server.computed)

    @property
    def memory(self) -> int:
        """The resident memory of the server, in bytes."""
        return self._server.memory

    def close(self) -> None:
        self._server.process.kill()
        self._listener.join()
        self._server.close()

    def _next(self, timeout: float | None = None) -> tuple[Times, dict[str, Any]]:
        item = self._inbox.get(timeout=timeout)
        if item is None:
            raise Ended
        return item

    def _listen(self) -> None:
        with suppress(Ended):
            while True:
                message = self._server.next_message()
                self._inbox.put((Times(self._server.received, self._server.spent), message))
        self._inbox.put(None)


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
        self.ask("outline, opening", "documentSymbol")
        server.until_quiet()

    def type_one(self) -> None:
        over = {"start": self.place, "end": {**self.place, "character": self.place["character"] + 1}}
        self.server.notify(
            "textDocument/didChange",
            textDocument={**self.file, "version": next(self._versions)},
            contentChanges=[{"range": over, "text": next(self._letters)}],
        )

    def ask(self, name: str, method: str, **where: object) -> None:
        self.note(name, self.server.ask(f"textDocument/{method}", textDocument=self.file, **where))

    def note(self, name: str, took: Times) -> None:
        self.seconds.setdefault(name, []).append(took.clock)
        self.seconds.setdefault(f"{name}, processor", []).append(took.processor)

    def hurry(self) -> None:
        """Type and ask without a pause."""
        self.type_one()
        for method, where in (("documentSymbol", {}), *((each, {"position": self.place}) for each in _ASKED)):
            self.server.ask(f"textDocument/{method}", textDocument=self.file, **where)

    def round(self) -> None:
        begin = self.server.now
        self.type_one()
        if last := self.server.until_quiet():
            self.note("diagnostics", last.since(begin))
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
    parser.add_argument("--edits", type=int, default=0)
    choice = parser.parse_args()
    file = choice.file.resolve()
    server = Server(file.parent)
    try:
        typist = Typist(server, file)
        for _ in range(choice.rounds):
            typist.round()
        for _ in range(choice.edits):
            typist.hurry()
        server.until_quiet()
        for name, seconds in typist.seconds.items():
            print(f"{name:28} {statistics.median(seconds) * 1000:6.1f} ms, at most {max(seconds) * 1000:.1f}")
        print(f"{'memory':28} {server.memory / 1e6:6.1f} MB")
    finally:
        server.close()


if __name__ == "__main__":
    main()

"""Runs commands on generated texts for a while, and keeps what fails."""

from __future__ import annotations

import hashlib
import json
from collections import Counter
from pathlib import Path

from hypothesis import HealthCheck, Phase, given, seed, settings
from hypothesis import strategies as st

from sdfcheck.source.record import NamedTuple
from tests.fuzz.commands import COMMANDS, Failure
from tests.fuzz.documents import Text, texts
from tests.fuzz.minimize import ATTEMPTS, minimize
from tests.fuzz.worker import SERVER, Worker

BATCH = 100
PER_TEXT = 4


class Case(NamedTuple):
    """A text, and the commands to run on it."""

    text: Text
    commands: tuple[str, ...]


def cases() -> st.SearchStrategy[Case]:
    """Any text with some commands; the server answers so many questions that it is asked rarely."""
    commands = st.lists(st.sampled_from((*COMMANDS, SERVER)), min_size=1, max_size=PER_TEXT, unique=True)
    return st.builds(Case, texts(), commands.map(tuple))


class Fuzzer:
    """The runs and the failures; findings are kept in a folder, one of each mark."""

    def __init__(self, folder: Path) -> None:
        self.folder = folder
        self.worker = Worker()
        self.ran: Counter[str] = Counter()
        self.documents = 0
        self.marks: Counter[str] = Counter()

    def run(self, minutes: float, first_seed: int) -> None:
        """Run for so many minutes of processor time, in batches with a seed each."""
        end = self.worker.seconds + 60 * minutes
        number = first_seed
        while self.worker.seconds < end:
            self._batch(number, end)
            number += 1
            self._write_figures(number - first_seed, first_seed)
        self.worker.stop()

    def _batch(self, number: int, end: float) -> None:
        @seed(number)
        @settings(
            max_examples=BATCH,
            database=None,
            deadline=None,
            phases=[Phase.generate],
            suppress_health_check=list(HealthCheck),
        )
        @given(cases())
        def each(case: Case) -> None:
            if self.worker.seconds < end:
                self.take(case, number)

        each()

    def take(self, case: Case, number: int) -> None:
        """Run the commands of a case."""
        self.documents += 1
        for command in case.commands:
            self.ran[command] += 1
            failure = self.worker.run(command, case.text)
            if failure is not None:
                self.keep(command, case.text, failure, number)

    def keep(self, command: str, text: Text, failure: Failure, number: int) -> None:
        """Write a finding that is new, made small."""
        mark = f"{command.split(maxsplit=1)[0]}: {failure.mark}"
        self.marks[mark] += 1
        if self.marks[mark] > 1:
            return

        def fails(data: bytes) -> bool:
            found = self.worker.run(command, Text(text.suffix, data))
            return found is not None and found.mark == failure.mark

        name = hashlib.sha256(mark.encode()).hexdigest()[:12]
        self.folder.mkdir(parents=True, exist_ok=True)
        self.folder.joinpath(f"{name}{text.suffix}").write_bytes(text.data)
        is_slow = any(word in failure.mark for word in ("time", "hang", "answer"))
        data = minimize(text.data, fails, 10 if is_slow else ATTEMPTS)
        self.folder.joinpath(f"{name}{text.suffix}").write_bytes(data)
        story = f"{command}\n{mark}\nseed {number}\n\n{failure.story}\n"
        self.folder.joinpath(f"{name}.txt").write_text(story, "utf-8", "backslashreplace")
        print(f"{mark}: {command} {self.folder / name}{text.suffix} ({len(data)} bytes)", flush=True)

    def _write_figures(self, batches: int, first_seed: int) -> None:
        figures = {
            "documents": self.documents,
            "commands": sum(self.ran.values()),
            "minutes": round(self.worker.seconds / 60, 1),
            "seeds": [first_seed, first_seed + batches - 1],
            "by command": dict(sorted(self.ran.items())),
            "findings": dict(sorted(self.marks.items())),
        }
        self.folder.mkdir(parents=True, exist_ok=True)
        self.folder.joinpath("figures.json").write_text(json.dumps(figures, indent=1))

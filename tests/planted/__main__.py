"""Plants mistakes in descriptions and counts those that are reported: ``python -m tests.planted --folder DIR``.

Each mistake is made at places that are drawn with a seed, on lines without a finding, in files
without errors. It counts as caught if there is a new warning or error, and as placed if one of
these, or a label, is on its line. Changes that make no difference must not change the
findings: their codes, and how many there are of each.
"""

from __future__ import annotations

import argparse
import random
import sys
from collections import Counter
from collections.abc import Iterator, Sequence
from pathlib import Path

import sdfcheck
from sdfcheck.lint.diagnostic import Diagnostic, Severity
from sdfcheck.source.record import NamedTuple
from sdfcheck.source.splice import replaced
from tests.planted.harmless import HARMLESS
from tests.planted.mistakes import MISTAKES
from tests.planted.page import Page

SUFFIXES = {".sdf", ".urdf", ".world", ".xacro"}
LARGEST = 200_000
"""Larger files are left out, so that many of them are tried."""


class Subject:
    """A file, and what is found in it as it is."""

    def __init__(self, path: Path, folder: Path) -> None:
        self.page = Page(path, path.read_bytes())
        self._folder = folder
        self._found: tuple[Diagnostic, ...] | None = None

    @property
    def found(self) -> tuple[Diagnostic, ...]:
        if self._found is None:
            self._found = self.lint(self.page.text)
        return self._found

    @property
    def is_clean(self) -> bool:
        return self.page.is_usable and all(each.severity is not Severity.ERROR for each in self.found)

    def lint(self, text: str) -> tuple[Diagnostic, ...]:
        folders = (self._folder,)
        data = text.encode("utf-8", "surrogatepass")
        return sdfcheck.lint(
            data, name=self.page.path, package_paths=folders, model_paths=folders, isolated=True
        ).diagnostics


class Outcome(NamedTuple):
    """The result of a change: whether it was reported, and on its line; where it was made."""

    kind: str
    is_caught: bool
    is_placed: bool
    place: str


def plant(subjects: Sequence[Subject], count: int, chance: random.Random) -> Iterator[Outcome]:
    """So many mistakes, of each kind as many as the files allow, at most one of a kind in a file at a time."""
    each = -(-count // len(MISTAKES))
    for mistake in MISTAKES:
        left = each
        before = 0
        while left not in {0, before}:
            before = left
            for subject in chance.sample(subjects, len(subjects)):
                changes = list(mistake(subject.page)) if left else []
                change = chance.choice(changes) if changes else None
                if change is None or not subject.is_clean:
                    continue
                line = subject.page.line(change.at)
                if any(each.span.begin.line == line for each in subject.found):
                    continue
                yield _outcome(mistake.__name__, subject, replaced(subject.page.text, change.edits), line)
                left -= 1


def _outcome(kind: str, subject: Subject, text: str, line: int) -> Outcome:
    known = Counter((each.code, each.message) for each in subject.found)
    new = []
    for each in subject.lint(text):
        known[each.code, each.message] -= 1
        if known[each.code, each.message] < 0 and each.severity is not Severity.INFO:
            new.append(each)
    spans = [span for each in new for span in (each.span, *(label.span for label in each.labels))]
    lines = [number for span in spans for number in (span.begin.line, span.finish.line)]
    return Outcome(kind, bool(new), line in lines, f"{subject.page.path}:{line}")


def change(subjects: Sequence[Subject], count: int, chance: random.Random) -> Iterator[Outcome]:
    """So many changes that make no difference; those that change a finding are caught."""
    each = -(-count // len(HARMLESS))
    for harmless in HARMLESS:
        left = each
        for subject in chance.sample(subjects, len(subjects)):
            if not left:
                break
            text = harmless(subject.page, chance) if subject.page.is_usable else subject.page.text
            if text != subject.page.text:
                codes = Counter(each.code for each in subject.found)
                other = Counter(each.code for each in subject.lint(text))
                place = f"{subject.page.path}: {dict(codes - other)} {dict(other - codes)}"
                yield Outcome(harmless.__name__, codes != other, False, place)
                left -= 1


def subjects_in(folder: Path) -> list[Subject]:
    """The descriptions below a folder; packages and models are looked for in its folders."""
    paths = [path for path in sorted(folder.rglob("*")) if path.suffix in SUFFIXES and path.is_file()]
    small = [path for path in paths if path.stat().st_size < LARGEST]
    found = [Subject(path, folder / path.relative_to(folder).parts[0]) for path in small]
    return [each for each in found if each.page.is_usable]


def main(arguments: Sequence[str]) -> int:
    parser = argparse.ArgumentParser(prog="python -m tests.planted")
    parser.add_argument("--folder", type=Path, required=True, help="descriptions: a repository a folder")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--mistakes", type=int, default=1000)
    parser.add_argument("--harmless", type=int, default=500)
    given = parser.parse_args(arguments)
    chance = random.Random(given.seed)
    subjects = subjects_in(given.folder)
    chance.shuffle(subjects)
    print(f"{len(subjects)} files")
    planted = list(plant(subjects, given.mistakes, chance))
    for kind in dict.fromkeys(each.kind for each in planted):
        own = [each for each in planted if each.kind == kind]
        print(f"{kind}: {_shares(own)}")
    for each in planted:
        if not each.is_placed:
            print(f"{'elsewhere' if each.is_caught else 'missed'}: {each.kind} {each.place}")
    changed = list(change(subjects, given.harmless, chance))
    for each in changed:
        if each.is_caught:
            print(f"changed: {each.kind} {each.place}")
    print(f"mistakes: {_shares(planted)}")
    print(f"harmless: {sum(each.is_caught for each in changed)} of {len(changed)} change a finding")
    return 0


def _shares(outcomes: Sequence[Outcome]) -> str:
    caught, placed = sum(each.is_caught for each in outcomes), sum(each.is_placed for each in outcomes)
    return f"{caught} of {len(outcomes)} caught, {placed} on the line"


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))

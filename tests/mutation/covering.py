"""Which tests run which lines, and how long they take: noted once, while all of them pass."""

from __future__ import annotations

import json
import subprocess
import sys
import time
from collections import defaultdict
from collections.abc import Collection, Iterator, Mapping
from pathlib import Path
from typing import NamedTuple

import pytest

_LINES = 10


class Covering(NamedTuple):
    """Tests by the lines that they run, and the seconds that they take."""

    tests: Mapping[str, Mapping[int, tuple[str, ...]]]
    """Path → line → tests."""
    seconds: Mapping[str, float]

    def of(self, path: Path, line: int) -> list[str]:
        """The tests that run a line, the quickest first."""
        lines = self.tests.get(path.as_posix(), {})
        # Of a statement of several lines some may not be noted.
        found = next((lines[at] for at in range(line, line - _LINES, -1) if lines.get(at)), ())
        return sorted(found, key=lambda test: (self.seconds.get(test, 0.0), test))

    def among(self, tests: Collection[str]) -> Covering:
        """Only what these tests cover. pytest fails at a test that is gone, as if the mutant were killed."""
        lines = {
            path: {line: tuple(name for name in names if name in tests) for line, names in at.items()}
            for path, at in self.tests.items()
        }
        return Covering(lines, self.seconds)


class _Recorder:
    """A plugin of pytest."""

    def __init__(self, measure: object) -> None:
        self.measure = measure
        self.seconds: dict[str, float] = {}

    @pytest.hookimpl(hookwrapper=True)
    def pytest_runtest_protocol(self, item: pytest.Item) -> Iterator[None]:
        self.measure.switch_context(item.nodeid)  # type: ignore[attr-defined]
        begin = time.monotonic()
        yield
        self.seconds[item.nodeid] = time.monotonic() - begin


def record(root: Path, tests: list[str], note: Path) -> None:
    """Run tests and write what they cover. Raises RuntimeError if one fails."""
    import coverage

    folders = [str(root / name / "*") for name in ("sdfcheck", "sdfcheck_rules", "rules")]
    measure = coverage.Coverage(data_file=None, include=folders, config_file=False)
    recorder = _Recorder(measure)
    measure.start()
    code = pytest.main(
        ["-q", "-n0", "-p", "no:randomly", "-p", "no:cacheprovider", *tests], plugins=[recorder]
    )
    measure.stop()
    if code != 0:
        raise RuntimeError("the tests fail without any change")
    data = measure.get_data()
    lines = {}
    for file in data.measured_files():
        found = data.contexts_by_lineno(file)
        name = Path(file).resolve().relative_to(root).as_posix()
        lines[name] = {line: sorted(filter(None, contexts)) for line, contexts in found.items()}
    note.write_text(json.dumps({"lines": lines, "seconds": recorder.seconds}))


def read(note: Path) -> Covering:
    """The coverage in a note."""
    known = json.loads(note.read_text())
    tests: dict[str, dict[int, tuple[str, ...]]] = defaultdict(dict)
    for path, lines in known["lines"].items():
        tests[path] = {int(line): tuple(names) for line, names in lines.items()}
    return Covering(tests, known["seconds"])


def collected(root: Path, tests: list[str]) -> frozenset[str]:
    """The tests that there are now."""
    options = ["--collect-only", "-q", "-n0", "-p", "no:randomly", "-p", "no:cacheprovider"]
    done = subprocess.run(
        [sys.executable, "-m", "pytest", *options, *tests],
        cwd=root,
        capture_output=True,
        text=True,
        check=True,
    )
    return frozenset(line for line in done.stdout.splitlines() if "::" in line)

"""Changes the code a little, many times, and says which changes no test notices: ``python -m tests.mutation``.

A sample of the mutants of each room is drawn with a seed. The tests that run the changed line
run on each, the quickest first. A mutant that all of them pass has survived: a test is missing,
or the change makes no difference; those of the second kind are listed with the reason in
``equivalent.txt``: as ``file: before → after``, or as ``file in function: before → after`` where
the line is in other functions, too.
"""

from __future__ import annotations

import argparse
import re
import sys
from collections.abc import Iterable, Iterator
from hashlib import sha256
from pathlib import Path

from tests.mutation.covering import Covering, collected, read, record
from tests.mutation.mutants import Mutant, make, marks
from tests.mutation.trial import survives

ROOT = Path(__file__).parents[2]
EQUIVALENT = Path(__file__).with_name("equivalent.txt")
ROOMS = {"robot": 80, "lint": 60, "convert": 80, "rules": 60}
"""Room → how many of its mutants are tried."""
RULES = 30
TESTS = (
    *("tests/unit/robot", "tests/unit/lint", "tests/unit/convert", "tests/unit/rules", "tests/test_rules.py"),
    *("tests/test_golden.py", "tests/test_golden_sdf_to_urdf.py", "tests/test_golden_urdf_to_sdf.py"),
    *(
        "tests/unit/report/test_manual.py",
        "tests/unit/test_api.py",
        "tests/unit/test_extensions.py",
        "tests/unit/cli/test_targets.py",
        "tests/unit/cli/test_nothing_lost.py",
        "tests/unit/cli/test_add_ignore.py",
        "tests/unit/cli/test_rules_test.py",
    ),
)
LEFT_OUT = (
    "tests/unit/lint/test_dask.py",
    "tests/unit/lint/test_parallel.py",
    "tests/unit/lint/test_conditions.py",
)
"""Tests of processes, and those that compare the code with what is generated from it."""
OWN = {"sdfcheck/lint/rulebook/conditions.py": ("tests/unit/lint/test_conditions.py",)}
"""A module → tests that are left out, and run for it alone."""
_SURVIVOR = re.compile(r"^(\S+\.py):\d+(?: in .*)?: .*\n  - (.*)\n  \+ (.*)$", re.MULTILINE)
PASS = 30.0
"""So many seconds of tests are run on a mutant at most."""


def drawn(candidates: Iterable[str], number: int, seed: int) -> list[str]:
    """So many of the candidates, each equally likely; others that come or go change few of them."""
    return sorted(candidates, key=lambda each: sha256(f"{seed} {each}".encode()).digest())[:number]


def files(room: str, seed: int) -> list[Path]:
    """The modules of a room; of the rules so many, with the conditions of all of them."""
    folder = ROOT / ("rules" if room == "rules" else f"sdfcheck/{room}")
    found = sorted(path.relative_to(ROOT) for path in folder.rglob("*.py") if path.name != "__init__.py")
    if room != "rules":
        return found
    rules = [path.as_posix() for path in found if len(path.parts) == 3]
    return [Path("rules/conditions.py"), *map(Path, sorted(drawn(rules, RULES, seed)))]


def sample(room: str, seed: int) -> Iterator[Mutant]:
    """Mutants of a room, each equally likely."""
    texts = {file: ROOT.joinpath(file).read_text("utf-8") for file in files(room, seed)}
    places = {
        f"{file.as_posix()} {mark}": (file, number)
        for file, text in texts.items()
        for number, mark in enumerate(marks(text))
    }
    for file, number in sorted(places[name] for name in drawn(places, ROOMS[room], seed)):
        yield make(file, texts[file], number)


def within(tests: list[str], covering: Covering) -> list[str]:
    """As many tests as may be run, the quickest first."""
    chosen: list[str] = []
    left = PASS
    for test in tests:
        left -= covering.seconds.get(test, 1.0)
        if left < 0 and chosen:
            break
        chosen.append(test)
    return chosen


def equivalent() -> dict[str, str]:
    """Mutants that make no difference, by key, and why."""
    entries = [line.partition(" # ") for line in EQUIVALENT.read_text("utf-8").splitlines()]
    return {key: reason for key, _, reason in entries if reason}


def listed(report: Path) -> set[str]:
    """The keys of the mutants that survived, by what an earlier run printed."""
    found = _SURVIVOR.findall(report.read_text("utf-8"))
    return {f"{path}: {before} → {after}" for path, before, after in found}


def main() -> int:
    parser = argparse.ArgumentParser(prog="python -m tests.mutation", description=__doc__)
    parser.add_argument("rooms", nargs="*", default=list(ROOMS), help=f"of {', '.join(ROOMS)}")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--note", type=Path, default=Path("build/covering.json"), help="what the tests cover")
    parser.add_argument("--anew", action="store_true", help="find out anew what the tests cover")
    parser.add_argument("--again", type=Path, metavar="REPORT", help="only what survived in an earlier run")
    parser.add_argument("--with", dest="also", nargs="*", default=[], metavar="TEST", help="run these, too")
    given = parser.parse_args()
    if given.anew or not given.note.exists():
        _record(given.note)
    covering, harmless = read(given.note).among(collected(ROOT, _tests())), equivalent()
    only = listed(given.again) if given.again is not None else None
    total = survived = 0
    for mutant in (mutant for room in given.rooms for mutant in sample(room, given.seed)):
        if harmless.keys() & {mutant.key, mutant.own_key} or (only is not None and mutant.key not in only):
            continue
        total += 1
        tests = [
            *given.also,
            *OWN.get(mutant.path.as_posix(), ()),
            *within(covering.of(mutant.path, mutant.line), covering),
        ]
        if not tests or survives(ROOT / mutant.path, mutant.text, tests):
            survived += 1
            change = f"  - {mutant.before}\n  + {mutant.after}"
            print(
                f"{mutant.path.as_posix()}:{mutant.line} in {mutant.function}: {len(tests)} tests\n{change}",
                flush=True,
            )
    print(f"{total - survived} of {total} mutants are killed: {100 * (1 - survived / max(1, total)):.1f} %")
    return int(survived > 0.05 * total)


def _tests() -> list[str]:
    return [
        *TESTS,
        *(f"--ignore={path}" for path in LEFT_OUT),
        "--deselect=tests/test_rules.py::test_the_conditions_are_up_to_date",
    ]


def _record(note: Path) -> None:
    """In a process of its own, so that this one has loaded nothing that is to be changed."""
    import multiprocessing

    process = multiprocessing.get_context("spawn").Process(target=record, args=(ROOT, _tests(), note))
    note.parent.mkdir(parents=True, exist_ok=True)
    process.start()
    process.join()


if __name__ == "__main__":
    sys.exit(main())

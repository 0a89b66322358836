"""Mutants are what they say, and tests kill them or do not."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import pytest

from tests.mutation.__main__ import ROOMS, drawn, equivalent, files, listed, sample, within
from tests.mutation.covering import Covering, collected
from tests.mutation.mutants import Mutant, make, marks

ROOT = Path(__file__).parents[2]
MODULE = Path("module.py")
CODE = '''"""A module."""
from typing import cast
LIMIT = 3


def f(a: int, names: list[str]) -> int | None:
    """Text 1."""
    if a < 3 and not names:
        return None
    for name in names:
        if name == "x":
            continue
        names.remove(name)
    return a + len(names)


def __repr__() -> str:
    return "x"
'''


def mutants() -> list[Mutant]:
    return [make(MODULE, CODE, number) for number in range(len(marks(CODE)))]


def test_the_changes_to_the_code() -> None:
    assert {(mutant.before, mutant.after) for mutant in mutants()} == {
        ("if a < 3 and (not names):", "if not (a < 3 and (not names)):"),
        ("if a < 3 and (not names):", "if a < 3 or not names:"),
        ("if a < 3 and (not names):", "if a <= 3 and (not names):"),
        ("if a < 3 and (not names):", "if a < 4 and (not names):"),
        ("if a < 3 and (not names):", "if a < 3 and names:"),
        ("if name == 'x':", "if name != 'x':"),
        ("if name == 'x':", "if name == 'xx':"),
        ("continue", "break"),
        ("names.remove(name)", "pass"),
        ("return a + len(names)", "return None"),
        ("return a + len(names)", "return a - len(names)"),
    }


def test_a_mutant_is_one_change_at_a_place() -> None:
    for mutant in mutants():
        assert CODE.splitlines()[mutant.line - 1].strip()
        compile(mutant.text, "module.py", "exec")
        assert mutant.key == f"module.py: {mutant.before} → {mutant.after}"


def test_a_line_that_is_in_several_places_differs_by_its_function() -> None:
    code = "class A:\n    def f(self):\n        if self.a:\n            return []\n        return []\n"
    code += "def f():\n    return []\n"
    made = [make(MODULE, code, number) for number in range(len(marks(code)))]
    assert [mutant.own_key for mutant in made if mutant.after == "return None"] == [
        "module.py in A.f: return [] → return None",
        "module.py in A.f 2: return [] → return None",
        "module.py in f: return [] → return None",
    ]


def test_a_sample_is_that_of_its_seed(monkeypatch: pytest.MonkeyPatch) -> None:
    some = files("lint", 1)[::6]
    monkeypatch.setattr("tests.mutation.__main__.files", lambda *_: some)
    monkeypatch.setitem(ROOMS, "lint", 12)
    first = [mutant.key for mutant in sample("lint", 1)]
    assert first == [mutant.key for mutant in sample("lint", 1)]
    assert first != [mutant.key for mutant in sample("lint", 2)]
    assert len(first) == 12


def test_a_change_elsewhere_leaves_a_sample_as_it_is() -> None:
    names = [*map(str, range(100))]
    assert set(drawn(names, 10, 1)) - set(drawn([*names, "more"], 10, 1)) <= {drawn(names, 10, 1)[-1]}
    longer = "def g():\n    return a == 5\n\n\n" + CODE
    assert set(marks(CODE)) < set(marks(longer))


def test_the_quickest_tests_come_first() -> None:
    covering = Covering({"a.py": {3: ("slow", "quick", "medium")}}, {"slow": 80, "quick": 1, "medium": 20})
    assert covering.of(Path("a.py"), 3) == ["quick", "medium", "slow"]
    assert covering.of(Path("a.py"), 5) == ["quick", "medium", "slow"]
    assert covering.of(Path("a.py"), 2) == []
    assert within(covering.of(Path("a.py"), 3), covering) == ["quick", "medium"]


def test_a_test_that_is_gone_is_not_run() -> None:
    covering = Covering({"a.py": {3: ("gone", "here")}}, {"gone": 1, "here": 2})
    assert covering.among({"here", "new"}).of(Path("a.py"), 3) == ["here"]
    this = f"tests/mutation/test_mutants.py::{test_a_test_that_is_gone_is_not_run.__name__}"
    assert this in collected(ROOT, ["tests/mutation/test_mutants.py"])


def test_survivors_are_read_from_a_report(tmp_path: Path) -> None:
    report = tmp_path / "report.txt"
    report.write_text("a/b.py:3 in f 2: 5 tests\n  - x = 1\n  + x = 2\n1 of 2 mutants are killed: 50.0 %\n")
    assert listed(report) == {"a/b.py: x = 1 → x = 2"}


def test_mutants_that_make_no_difference_have_a_reason() -> None:
    keys = equivalent()
    assert all(key.count(" → ") == 1 and reason.strip() for key, reason in keys.items())
    assert all((ROOT / key.partition(":")[0].partition(" in ")[0]).exists() for key in keys)


@pytest.mark.skipif(not hasattr(os, "fork"), reason="mutants are tried in copies of the process")
def test_a_mutant_is_killed_by_a_test_that_notices(tmp_path: Path) -> None:
    (tmp_path / "module.py").write_text("def double(a):\n    return a * 2\n")
    (tmp_path / "test_module.py").write_text(
        "from module import double\n\n"
        "def test_weak():\n    assert double(0) == 0\n\n"
        "def test_strong():\n    assert double(3) == 6\n"
    )
    text = make(Path("module.py"), (tmp_path / "module.py").read_text(), 1).text
    script = (
        "import sys; from pathlib import Path; from tests.mutation.trial import survives\n"
        f"sys.path.insert(0, {str(tmp_path)!r})\n"
        "for name in ('test_weak', 'test_strong'):\n"
        f"    test = {str(tmp_path / 'test_module.py')!r} + '::' + name\n"
        f"    print(survives(Path({str(tmp_path / 'module.py')!r}), {text!r}, [test]))"
    )
    done = subprocess.run(
        [sys.executable, "-c", script], cwd=ROOT, capture_output=True, text=True, check=True
    )
    assert done.stdout.split() == ["True", "False"]

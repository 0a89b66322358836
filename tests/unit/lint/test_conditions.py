"""The conditions of a pack are copied into one module that works without the modules of the rules."""

from __future__ import annotations

import importlib
import sys
from pathlib import Path
from types import ModuleType

import pytest

from sdfcheck.lint.rulebook.conditions import main, render
from sdfcheck.lint.rulebook.pack import PackError
from sdfcheck.lint.rulebook.packs import load_index
from sdfcheck.lint.rulebook.plugins import find_pack

LIMITS = """
import math
import re
from collections.abc import Iterator
from math import inf
from typing import Any, Final

from sdfcheck import Bad, Diagnostic, Element, Good, Rule, Severity
from {pack}.words import TALL, is_known

SMALL: Final = 1e-3
LEAST = (SMALL, -inf)
LIMIT = re.compile("LIMIT", flags=re.IGNORECASE)


def size(element: Element) -> float:
    '''How large it is.'''
    found: float = max(LEAST)
    return found if is_known(element.name) else size(element)


class OddLimit(Rule):
    '''A limit is odd.'''

    code = "XYZ001"
    name = "odd-limit"
    severity = Severity.WARNING
    selects = ("sdf:limit",)
    bad = (Bad("<limit/>"),)
    good = (Good("<limit/>"),)

    @staticmethod
    def applies(limit: Element) -> bool:
        '''Is it?'''
        sizes = [size(limit) for _ in range(2)]
        is_limit = re.search(LIMIT, limit.name) is not None
        return math.isfinite(sum(sizes)) and is_limit and limit.name != TALL

    def check(self, limit: Element) -> Iterator[Diagnostic]:
        yield self.diagnostic(limit, "odd")
"""
WORDS = """
TALL = "tall"
KNOWN = {"limit", TALL}


def is_known(name):
    return name in KNOWN
"""
EXPECTED = """
from math import inf as math_inf
import math as math_
import re as re_

odd_limit__SMALL = 0.001

odd_limit__LEAST = (odd_limit__SMALL, -math_inf)

words__TALL = 'tall'

words__KNOWN = {'limit', words__TALL}

def words__is_known(name):
    return name in words__KNOWN

def odd_limit__size(element):
    found = max(odd_limit__LEAST)
    return found if words__is_known(element.name) else odd_limit__size(element)

odd_limit__LIMIT = re_.compile('LIMIT', flags=re_.IGNORECASE)

def XYZ001_applies(limit):
    sizes = [odd_limit__size(limit) for _ in range(2)]
    is_limit = re_.search(odd_limit__LIMIT, limit.name) is not None
    return math_.isfinite(sum(sizes)) and is_limit and (limit.name != words__TALL)

CONDITIONS = {
    'XYZ001': XYZ001_applies,
}
"""


@pytest.fixture
def pack(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> Path:
    """A pack that can be imported under a name of its own."""
    folder = tmp_path / f"pack_{abs(hash(tmp_path))}"
    folder.mkdir()
    (folder / "__init__.py").write_text("")
    (folder / "odd_limit.py").write_text(LIMITS.format(pack=folder.name))
    (folder / "words.py").write_text(WORDS)
    monkeypatch.syspath_prepend(tmp_path)
    return folder


def changed(pack: Path, old: str, new: str) -> None:
    path = pack / "odd_limit.py"
    assert old in path.read_text()
    path.write_text(path.read_text().replace(old, new))


def conditions(pack: Path) -> ModuleType:
    assert main([pack.name]) == 0
    return importlib.import_module(f"{pack.name}.conditions")


def test_a_condition_is_copied_with_what_it_uses(pack: Path) -> None:
    text = render(find_pack(pack.name))
    assert text.partition("# mypy: ignore-errors\n\n")[2] == EXPECTED.removeprefix("\n")


def test_the_written_condition_runs_without_the_rule(pack: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    limit = type("Limit", (), {"name": "limit"})()
    written = conditions(pack)
    for name in ("odd_limit", "words"):
        monkeypatch.delitem(sys.modules, f"{pack.name}.{name}")
    assert written.CONDITIONS["XYZ001"](limit) is True
    limit.name = "tall"
    assert written.CONDITIONS["XYZ001"](limit) is False


def test_only_what_means_something_else_is_stale(pack: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["--check", pack.name]) == 1
    assert "conditions.py is stale" in capsys.readouterr().out
    written = Path(str(conditions(pack).__file__))
    written.write_text(written.read_text().replace("'tall'", '"tall"  # high'))
    assert main(["--check", pack.name]) == 0
    current = written.read_text()
    for text in ('"low"', "<<<<<<<"):
        written.write_text(current.replace('"tall"', text))
        assert main(["--check", pack.name]) == 1
    assert main([pack.name]) == 0
    assert main(["--check", pack.name]) == 0


def test_an_indexed_pack_is_asked_by_the_module(pack: Path) -> None:
    (facts,) = (f for f in load_index([pack.name]).facts if f.code == "XYZ001")
    assert load_index([pack.name]).condition(facts).__module__ == f"{pack.name}.odd_limit"
    conditions(pack)
    (pack / "rule_index.py").write_text("RULES = ()")
    assert load_index([pack.name]).condition(facts).__module__ == f"{pack.name}.conditions"


@pytest.mark.parametrize(
    ("old", "new", "says"),
    [
        (
            "LEAST = (SMALL, -inf)",
            "LEAST = []",
            "uses `LEAST`: not a constant, plain function or import",
        ),
        ("LEAST = (SMALL, -inf)", "LEAST = dict()", "uses `LEAST`: not a constant"),
        ("LEAST = (SMALL, -inf)", "LEAST = ()\nLEAST += (1,)", "uses `LEAST`: not a constant"),
        ("max(LEAST)", "len(OddLimit.name)", "uses `OddLimit`: not a constant"),
        ("max(LEAST)", "max(MOST)", "uses `MOST`: not defined in its module"),
        ("def size", "@__import__('functools').cache\ndef size", "uses `size`: not a constant"),
        ("import math\n", "import lxml as math\n", "cannot import `math` from `lxml`"),
        ("found: float = max(LEAST)", "global SMALL\n    found = 1", "holds no state"),
        ("sizes = [size(limit)", "SMALL = [size(limit)", "`SMALL` is a name of the module"),
        ("    @staticmethod\n", "    @classmethod\n", "`applies` of XYZ001 is to be a static method"),
    ],
)
def test_a_condition_that_cannot_be_copied_is_refused(
    pack: Path, old: str, new: str, says: str, capsys: pytest.CaptureFixture[str]
) -> None:
    changed(pack, old, new)
    assert main([pack.name]) == 1
    (line,) = capsys.readouterr().out.splitlines()
    assert says in line
    assert f"{pack / 'odd_limit.py'}:" in line
    assert not (pack / "conditions.py").exists()


def test_a_condition_from_elsewhere_is_refused(pack: Path) -> None:
    changed(pack, "    def check", "    applies = staticmethod(len)\n\n    def check")
    with pytest.raises(PackError, match="builtins: a condition cannot be in a module outside of the pack"):
        render(find_pack(pack.name))


def test_a_condition_may_use_the_classes_of_sdfcheck(pack: Path) -> None:
    changed(pack, "limit.name != TALL", "isinstance(limit, Element)")
    text = render(find_pack(pack.name))
    assert "import sdfcheck as sdfcheck_\n" in text
    assert "isinstance(limit, sdfcheck_.Element)" in text


def test_a_pack_that_cannot_be_imported_is_refused(pack: Path) -> None:
    changed(pack, "LEAST = (SMALL, -inf)", "LEAST = 1 / 0")
    with pytest.raises(PackError, match=r"odd_limit\.py.* division by zero"):
        render(find_pack(pack.name))

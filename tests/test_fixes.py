"""Fixes come to rest: applied to every rule's examples, they break nothing and leave nothing to fix."""

from __future__ import annotations

from pathlib import Path

import pytest

from sdfcheck.lint.diagnostic import Diagnostic
from sdfcheck.lint.example import Bad, fill, unmark
from sdfcheck.lint.fix.fixer import FixedFile, applicable, fix_file
from sdfcheck.lint.one_file import Selected
from sdfcheck.lint.rulebook.example_run import file_name
from sdfcheck.lint.rulebook.trial import Trial
from sdfcheck.source.sniff import Kind, sniff
from tests.test_rules import BENCH, TRIALS


def fixed_file(data: bytes, path: Path, example: Bad, folder: Path) -> FixedFile:
    def again(file: Selected) -> list[Diagnostic]:
        return BENCH.lint(file.data.decode(), example, folder)

    # A broken text may be anything; the parser decides.
    kind = sniff(data, path)
    known = {Kind.SDF, Kind.URDF, Kind.XACRO, Kind.MODEL_CONFIG}
    return fix_file(Selected(path, data, kind if kind in known else Kind.BROKEN_XML), again, unsafe=True)


@pytest.mark.parametrize("trial", [trial for trial in TRIALS if trial.kind == "bad"], ids=repr)
def test_fixing_comes_to_rest(trial: Trial, tmp_path: Path) -> None:
    rule, example = trial.rule, trial.example
    assert isinstance(example, Bad)
    text = unmark(fill(rule.scaffold, example))[0]
    data, path = text.encode(), Path(file_name(text, example))
    if example.files is not None:
        path = tmp_path / path
    once = fixed_file(data, path, example, tmp_path)
    assert not once.refusal
    assert (once.after != data) is (once.fixed > 0)
    assert once.fixed or example.fixed is None
    left = BENCH.lint(once.after.decode(), example, tmp_path)
    assert applicable(left, path, unsafe=True) == []
    if example.fixed is not None:
        assert [d.message for d in left if d.code == rule.code] == []

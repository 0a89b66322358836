"""Kinds of loss can be explained as rules are."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from sdfcheck.cli.main import main
from sdfcheck.convert.loss import LossKind
from sdfcheck.lint.diagnostic import Severity
from sdfcheck.lint.rulebook.packs import load_index
from tables import loss_table

ROOT = Path(__file__).parents[3]


def test_codes_and_names_are_nobody_elses() -> None:
    rules = load_index().facts
    names = [kind.title for kind in LossKind]
    codes = [kind.code for kind in LossKind]
    assert len(set(names)) == len(set(codes)) == len(names)
    assert not {*names, *codes} & {one for facts in rules for one in (facts.name, facts.code)}
    assert all(re.fullmatch(r"CNV\d{3}", code) for code in codes)


@pytest.mark.parametrize("kind", LossKind, ids=lambda kind: kind.title)
def test_each_says_what_is_lost_and_why(kind: LossKind, capsys: pytest.CaptureFixture[str]) -> None:
    summary = kind.facts.summary
    assert summary.endswith(".")
    assert len(summary) > 20
    assert main(["rule", kind.code, "--isolated", "--color", "never"]) == 0
    out = capsys.readouterr().out
    assert out.startswith(f"# {kind.title} ({kind.code})\n")
    assert summary in out


def test_none_is_graver_than_its_page_says() -> None:
    files = (ROOT / "fixtures" / "convert").rglob("losses.txt")
    lines = [line for file in files for line in file.read_text().splitlines()]
    said = [re.match(r"[\d:]+ (info|warning|error)\W([\w-]+)", line) for line in lines]
    highest = {name: kind.facts.severity for kind in LossKind for name in (kind.code, kind.title)}
    found = {(match[2], Severity(match[1])) for match in said if match}
    assert len(found) > 40
    assert [one for one in found if not highest[one[0]] >= one[1]] == []


def test_they_are_listed(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["rules", "CNV", "--isolated"]) == 0
    listed = [line.split()[0] for line in capsys.readouterr().out.splitlines()]
    assert listed == sorted(kind.code for kind in LossKind)


def test_the_guide_has_them() -> None:
    for path, mark, kinds in loss_table.GUIDES:
        guide = (ROOT / path).read_text(encoding="utf-8")
        assert loss_table.with_table(guide, mark, kinds) == guide
        assert all(f"| {kind.code} | {kind.title} |" in guide for kind in kinds)

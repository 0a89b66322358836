"""Planted mistakes are what they say, and are counted as caught or not."""

from __future__ import annotations

import random
from collections.abc import Callable
from itertools import islice
from pathlib import Path

import pytest

from sdfcheck.source.splice import replaced
from tests.planted.__main__ import Subject, change, main, plant, subjects_in
from tests.planted.harmless import HARMLESS
from tests.planted.mistakes import MISTAKES, Mistake, ring_of_joints
from tests.planted.page import Page

FIXTURES = Path(__file__).parents[2] / "fixtures"
ROBOTS = FIXTURES / "robots"
ARM = """\
<robot name="arm">
  <link name="base"/>
  <link name="upper"/>
  <link name="lower"/>
  <joint name="shoulder" type="fixed"><parent link="base"/><child link="upper"/></joint>
  <joint name="elbow" type="fixed"><parent link="upper"/><child link="lower"/></joint>
</robot>
"""


@pytest.fixture(scope="module")
def subjects() -> list[Subject]:
    return subjects_in(FIXTURES)


@pytest.mark.parametrize("mistake", MISTAKES, ids=lambda mistake: mistake.__name__)
def test_mistakes_change_one_place(mistake: Mistake, subjects: list[Subject]) -> None:
    found = list(islice(((each.page, change) for each in subjects for change in mistake(each.page)), 100))
    assert found
    for page, each in found:
        assert replaced(page.text, each.edits) != page.text
        assert list(each.edits) == sorted(each.edits)
        assert 0 <= each.at < len(page.text)


def test_a_ring_is_made_of_two_joints(tmp_path: Path) -> None:
    page = Page(tmp_path / "arm.urdf", ARM.encode())
    (change,) = ring_of_joints(page)
    assert 'name="shoulder" type="fixed"><parent link="lower"/>' in replaced(page.text, change.edits)
    assert page.line(change.at) == 5


def test_mistakes_are_caught_on_their_line(copied: Callable[[Path], Path]) -> None:
    planted = list(plant(subjects_in(copied(ROBOTS)), 2 * len(MISTAKES), random.Random(1)))
    assert len({each.kind for each in planted}) > 20
    assert [each for each in planted if not each.is_placed] == []


def test_harmless_changes_change_no_finding(copied: Callable[[Path], Path]) -> None:
    changed = list(change(subjects_in(copied(ROBOTS)), 3 * len(HARMLESS), random.Random(1)))
    assert len({each.kind for each in changed}) == len(HARMLESS)
    assert [each for each in changed if each.is_caught] == []


def test_a_missed_mistake_is_listed(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], tmp_path: Path
) -> None:
    (tmp_path / "arm").mkdir()
    (tmp_path / "arm" / "arm.urdf").write_text(ARM)
    monkeypatch.setattr(Subject, "lint", lambda self, text: ())
    assert main(["--folder", str(tmp_path), "--mistakes", "1", "--harmless", "1"]) == 0
    shown = capsys.readouterr().out
    assert f"missed: unclosed_tag {tmp_path / 'arm' / 'arm.urdf'}:" in shown
    assert "mistakes: 0 of " in shown

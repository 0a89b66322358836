"""The sample robots: not a word about the correct ones, an error in each of the others."""

from __future__ import annotations

from pathlib import Path

import pytest

from sdfcheck.lint.config.configuration import Configuration
from sdfcheck.lint.diagnostic import Diagnostic, Severity
from sdfcheck.lint.session import Options, run

ROBOTS = Path(__file__).parents[1] / "fixtures" / "robots"
MISTAKEN = ROBOTS / "with_mistakes"
SUFFIXES = {".sdf", ".world", ".urdf", ".xacro", ".config"}


def robots(*, mistaken: bool) -> list[Path]:
    files = sorted(path for path in ROBOTS.rglob("*") if path.suffix in SUFFIXES)
    return [path for path in files if (MISTAKEN in path.parents) == mistaken]


def lint(path: Path) -> tuple[Diagnostic, ...]:
    done = run([path], Options(Configuration(ROBOTS / "sdfcheck.toml")))
    assert done.files == (path,)
    return done.diagnostics


def name(path: Path) -> str:
    return path.relative_to(ROBOTS).as_posix()


@pytest.mark.parametrize("path", robots(mistaken=False), ids=name)
def test_correct_robots_raise_no_alarm(path: Path) -> None:
    assert not lint(path)


@pytest.mark.parametrize("path", robots(mistaken=True), ids=name)
def test_mistakes_are_errors(path: Path) -> None:
    assert any(diagnostic.severity is Severity.ERROR for diagnostic in lint(path))

"""The correct sample robots are correct: the consumers that are installed accept them."""

from __future__ import annotations

import shutil
import subprocess
from pathlib import Path

import pytest

from tests.peers import cmdcheck, libsdformat

ROBOTS = Path(__file__).parents[2] / "fixtures" / "robots"
MISTAKEN = ROBOTS / "with_mistakes"

pytestmark = pytest.mark.peers


def correct(*suffixes: str) -> list[Path]:
    files = sorted(path for suffix in suffixes for path in ROBOTS.rglob(f"*{suffix}"))
    return [path for path in files if MISTAKEN not in path.parents]


def check_urdf(path: Path) -> str:
    """The error of urdfdom about a file; empty without one."""
    if shutil.which("check_urdf") is None:
        pytest.skip("check_urdf is not installed")
    child = subprocess.run(["check_urdf", path], capture_output=True, text=True, check=False)
    return child.stderr if child.returncode else ""


def expand(path: Path, folder: Path) -> Path:
    import xacro

    target = folder / path.with_suffix("").name
    target.write_text(xacro.process_file(str(path)).toprettyxml(), encoding="utf-8")
    return target


@pytest.mark.parametrize("path", correct(".sdf", ".world", ".urdf"), ids=lambda path: path.name)
def test_libsdformat_accepts(path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    if libsdformat.library() is None:
        pytest.skip("libsdformat is not installed")
    monkeypatch.setenv("SDF_PATH", str(ROBOTS))
    opinion = cmdcheck.check(path)
    assert opinion.accepted, "\n".join(opinion.messages)


@pytest.mark.parametrize("path", correct(".urdf"), ids=lambda path: path.name)
def test_urdfdom_accepts(path: Path) -> None:
    assert not check_urdf(path)


@pytest.mark.parametrize("path", correct(".urdf.xacro"), ids=lambda path: path.name)
def test_urdfdom_accepts_the_expansion(path: Path, tmp_path: Path) -> None:
    assert not check_urdf(expand(path, tmp_path))

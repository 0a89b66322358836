"""Which ``model.config`` libsdformat can read, seen by including the model."""

from __future__ import annotations

from pathlib import Path

import pytest

import sdfcheck
from sdfcheck import Severity
from tests.peers.libsdformat import ask, library
from tests.unit.robot.files import write

pytestmark = [
    pytest.mark.peers,
    pytest.mark.skipif(library() is None, reason="libsdformat is not installed"),
]

MODEL = '<sdf version="1.6"><model name="m"><link name="l"/></model></sdf>'
WORLD = '<sdf version="1.6"><world name="w"><include><uri>model://m</uri></include></world></sdf>'
NAME = "<name>m</name>"


@pytest.mark.parametrize("name", [NAME, "<name/>", ""])
@pytest.mark.parametrize(
    ("root", "entry"),
    [
        ("modle", '<sdf version="1.6">model.sdf</sdf>'),
        ("model", '<sdf version="1.6">model.sdf</sdf>'),
        ("model", "<sdf>model.sdf</sdf>"),
        ("model", '<sdf version="">model.sdf</sdf>'),
        ("model", '<sdf version="9.9">model.sdf</sdf>'),
        ("model", '<sdf version="9.9">model.sdf</sdf><sdf version="1.6">model.sdf</sdf>'),
        ("model", '<sdf version="one">model.sdf</sdf>'),
        ("model", '<sdf version="1.6"/>'),
        ("model", '<sdf version="1.6">gone.sdf</sdf>'),
        ("model", ""),
    ],
)
def test_an_error_means_that_the_model_is_not_read(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, root: str, name: str, entry: str
) -> None:
    config = tmp_path / "m/model.config"
    write(
        tmp_path, {"m/model.config": f"<{root}>{name}{entry}</{root}>", "m/model.sdf": MODEL, "w.sdf": WORLD}
    )
    monkeypatch.setenv("SDF_PATH", str(tmp_path))
    answer = ask("cmdCheck", tmp_path / "w.sdf", tmp_path)
    found = sdfcheck.lint(config, isolated=True).diagnostics
    errors = [each.message for each in found if each.severity is Severity.ERROR]
    # Of what libsdformat 12 warns here, later versions make an error.
    assert bool(errors) == (answer.status != 0 or "Warning" in answer.errors), (errors, answer)

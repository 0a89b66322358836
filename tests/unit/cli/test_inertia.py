"""``sdfcheck inertia``."""

from __future__ import annotations

import io
import json
from pathlib import Path

import pytest

from sdfcheck.cli.inertia import draw, measure
from sdfcheck.cli.main import main
from sdfcheck.files.library import Library

ROBOTS = Path(__file__).parents[3] / "fixtures" / "robots"
WORKCELL = str(ROBOTS / "workcell" / "workcell.world")


def test_plain_text_in_a_pipe(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["inertia", str(ROBOTS / "two_link_arm" / "model.sdf"), "--isolated"]) == 0
    out, err = capsys.readouterr()
    assert err == ""
    rows = [line.split() for line in out.splitlines()]
    assert ["model", "two_link_arm"] in rows
    assert ["total", "5.9", "0", "0", "0.14644", "0.17743", "0.17743", "0.02795", "0", "0", "0"] in rows


def test_static_models_are_marked(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["inertia", WORKCELL, "--isolated"]) == 0
    out = capsys.readouterr().out
    assert "model floor (static)\n" in out
    assert "without 2 static models\n" in out
    assert "not written: what simulators take" in out


def test_json(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["inertia", WORKCELL, "--isolated", "--output-format", "json"]) == 0
    report = json.loads(capsys.readouterr().out)
    assert report["total"]["mass"] == pytest.approx(19.5)
    gantry = next(model for model in report["models"] if model["name"] == "gantry")
    assert [inner["name"] for inner in gantry["models"]] == ["gantry::head"]
    assert gantry["links"][0]["from"] == "written"


def test_one_model(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["inertia", WORKCELL, "--isolated", "--model", "gantry::head"]) == 0
    assert [line for line in capsys.readouterr().out.splitlines() if line.startswith("model")] == [
        "model gantry::head"
    ]


def test_an_unknown_model(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["inertia", WORKCELL, "--isolated", "--model", "gantry:head"]) == 2
    assert "did you mean `gantry::head`?" in capsys.readouterr().err


def test_xacro_is_expanded(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["inertia", str(ROBOTS / "rover" / "rover.urdf.xacro"), "--isolated"]) == 0
    assert "model rover\n" in capsys.readouterr().out


def test_a_faulty_number_has_a_place(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    file = tmp_path / "r.urdf"
    file.write_text(
        '<robot name="r">\n<link name="a"><inertial><mass value="1kg"/></inertial></link></robot>',
        encoding="utf-8",
    )
    assert main(["inertia", str(file), "--isolated"]) == 2
    assert "r.urdf:2:" in capsys.readouterr().err


@pytest.mark.parametrize("width", [200, 80, 20])
def test_a_terminal_cuts_no_number(width: int) -> None:
    from rich.console import Console

    file = ROBOTS / "desk_arm" / "desk_arm.urdf"
    document = Library().document(file)
    assert document is not None
    out = io.StringIO()
    draw(measure(document), Console(width=width, file=out))
    words = set(out.getvalue().split())
    assert {"desk_arm", "0.00019645", "5.6131e-06", "0.087079", "-0.026073"} <= words

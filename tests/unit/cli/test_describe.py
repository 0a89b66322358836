"""``sdfcheck describe``."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from sdfcheck.cli.main import main


def test_a_page(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["describe", "joint/axis/mimic"]) == 0
    assert capsys.readouterr().out.splitlines() == [
        "mimic (SDFormat 1.12)",
        "  Ties the position of this axis to that of another joint: multiplier × (leader - reference) +",
        "  offset.",
        "  element",
        "  since    1.11",
        "",
        "  found in",
        "    joint/axis  at most one",
        "",
        "  attributes",
        "    @axis   optional  string  default axis",
        "    @joint  required  string",
        "",
        "  elements",
        "    multiplier  exactly one  double  default 1.0",
        "    offset      exactly one  double  default 0",
        "    reference   exactly one  double  default 0",
    ]


def test_many_places_are_listed(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["describe", "noise"]) == 0
    lines = capsys.readouterr().out.splitlines()
    assert lines[0].startswith("noise is in ")
    assert "  camera/noise" in lines


def test_json(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["describe", "joint/@type", "--sdf-version", "1.4", "--output-format", "json"]) == 0
    output = json.loads(capsys.readouterr().out)
    (place,) = output["places"]
    assert output["version"] == 1
    assert place["what"] == "attribute"
    assert place["parents"] == [{"name": "joint", "multiplicity": "1"}]
    assert "fixed" not in place["choices"]


@pytest.mark.parametrize(
    ("arguments", "says"),
    [
        (["describe", "jiont"], "did you mean `joint`?"),
        (["describe", "joint", "--sdf-version", "1.13"], "choose from 1.2 to 1.12"),
    ],
)
def test_wrong_questions(arguments: list[str], says: str, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(arguments) == 2
    out, err = capsys.readouterr()
    assert out == ""
    assert says in err


def test_the_table_of_a_pack(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    table = "vendor\tAcme\thttps://example.org/acme\n\nforce\tdouble\t2\trange=[0,inf]\n urdf\trobot/joint\ttext\t0\n"
    (tmp_path / "tables").mkdir()
    (tmp_path / "tables" / "acme.vendor.txt").write_text(table, encoding="utf-8")
    (tmp_path / "sdfcheck.toml").write_text('plugins = ["tables/"]\n', encoding="utf-8")
    monkeypatch.chdir(tmp_path)
    assert main(["describe", "--trust-config", "acme:force"]) == 0
    assert capsys.readouterr().out.splitlines()[-7:] == [
        "acme:force (Acme, URDF)",
        "  element, of type double",
        "  default  2",
        "  range    at least 0",
        "",
        "  found in",
        "    robot/joint  at most one",
    ]
    assert main(["describe", "drake:mu_dynamic"]) == 0
    assert main(["describe", "--isolated", "acme:force"]) == 2

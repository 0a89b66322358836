from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest

from sdfcheck.cli.main import main
from sdfcheck.lint.diagnostic import Diagnostic, Severity
from sdfcheck.release import HOME
from sdfcheck.report import OutputFormat
from tests.unit.report.runs import diagnostic, facts, parsed, rich_diagnostic


def sarif_run(*diagnostics: Diagnostic, **fields: Any) -> Any:
    log = parsed(OutputFormat.SARIF, *diagnostics, **fields)
    assert log["version"] == "2.1.0"
    assert log["$schema"].endswith("sarif-2.1.0.json")
    (only,) = log["runs"]
    return only


def region(*numbers: int) -> dict[str, int]:
    return dict(zip(("startLine", "startColumn", "endLine", "endColumn"), numbers, strict=True))


def test_sarif_result() -> None:
    log = sarif_run(rich_diagnostic(), rules=(facts("AAA901", "other"), facts()))
    artifact = {"uri": "arm.sdf", "uriBaseId": "%SRCROOT%"}
    (result,) = log["results"]
    fingerprint = result.pop("partialFingerprints")["primaryLocationLineHash"]
    assert fingerprint.endswith(":1")
    assert result.pop("fixes")
    assert log["columnKind"] == "unicodeCodePoints"
    assert result == {
        "ruleId": "NAM901",
        "ruleIndex": 1,
        "level": "error",
        "message": {"text": "name `a` is taken"},
        "locations": [{"physicalLocation": {"artifactLocation": artifact, "region": region(2, 5, 2, 6)}}],
        "relatedLocations": [
            {
                "id": 1,
                "physicalLocation": {"artifactLocation": artifact, "region": region(2, 10, 2, 11)},
                "message": {"text": "here"},
            },
            {
                "id": 2,
                "physicalLocation": {
                    "artifactLocation": {"uri": "world.xacro", "uriBaseId": "%SRCROOT%"},
                    "region": region(1, 1, 1, 5),
                },
                "message": {"text": "included here"},
            },
        ],
    }


def test_sarif_fix() -> None:
    (result,) = sarif_run(rich_diagnostic())["results"]
    (fix,) = result["fixes"]
    assert fix == {
        "description": {"text": "write `c` (safe fix)"},
        "artifactChanges": [
            {
                "artifactLocation": {"uri": "arm.sdf", "uriBaseId": "%SRCROOT%"},
                "replacements": [{"deletedRegion": region(2, 5, 2, 6), "insertedContent": {"text": "c"}}],
            }
        ],
    }


def test_sarif_rules() -> None:
    log = sarif_run(rules=(facts(summary="s" * 2000, severity=Severity.INFO, default=False),))
    (rule,) = log["tool"]["driver"]["rules"]
    assert log["results"] == []
    assert rule["id"] == "NAM901"
    assert rule["name"] == "TakenName"
    assert rule["shortDescription"]["text"] == rule["fullDescription"]["text"] == "s" * 1024
    assert rule["help"]["text"].endswith(
        "\n- drake, SDF: aborts\n- gazebo: rejects it\n\nMore: sdfcheck rule taken-name"
    )
    assert rule["defaultConfiguration"] == {"enabled": False, "level": "note"}
    assert rule["properties"]["problem.severity"] == "recommendation"


def test_sarif_rules_in_preview_are_off() -> None:
    (rule,) = sarif_run(rules=(facts(preview=True),))["tool"]["driver"]["rules"]
    assert rule["defaultConfiguration"]["enabled"] is False


def test_sarif_lists_only_the_rules_of_the_run() -> None:
    log = sarif_run(diagnostic("«a»", code="INT901"), rules=(facts(),))
    assert [rule["id"] for rule in log["tool"]["driver"]["rules"]] == ["NAM901"]
    assert "ruleIndex" not in log["results"][0]


@pytest.mark.parametrize(
    ("path", "uri"),
    [
        ("my robots/ärm#1.sdf", "my%20robots/%C3%A4rm%231.sdf"),
        ("a:b.sdf", "a%3Ab.sdf"),
        ("100%.sdf", "100%25.sdf"),
    ],
)
def test_sarif_uris_are_escaped(path: str, uri: str) -> None:
    (result,) = sarif_run(diagnostic("«a»", path=path))["results"]
    assert result["locations"][0]["physicalLocation"]["artifactLocation"]["uri"] == uri


@pytest.mark.parametrize("is_relative", [True, False])
def test_sarif_uris_outside_the_sources_are_whole(
    is_relative: bool, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (tmp_path / "here").mkdir()
    monkeypatch.chdir(tmp_path / "here")
    path = "../arm.sdf" if is_relative else str(tmp_path / "arm.sdf")
    (result,) = sarif_run(diagnostic("«a»", path=path))["results"]
    assert result["locations"][0]["physicalLocation"]["artifactLocation"] == {
        "uri": (tmp_path / "arm.sdf").as_uri()
    }


def test_sarif_takes_two_readings_of_one_file() -> None:
    results = sarif_run(diagnostic("«a»"), diagnostic("b\n\n«c»"))["results"]
    hashes = [result["partialFingerprints"]["primaryLocationLineHash"] for result in results]
    assert len(set(hashes)) == 2


def test_sarif_links_built_in_rules_and_only_those() -> None:
    log = sarif_run(rules=(facts("AAA901", "other"), facts(module="sdfcheck_rules.nam.taken_name")))
    driver = log["tool"]["driver"]
    assert driver["informationUri"] == HOME
    of_a_pack, built_in = driver["rules"]
    assert "helpUri" not in of_a_pack
    assert built_in["helpUri"] == f"{HOME}/latest/rules/taken-name/"
    assert built_in["helpUri"] in built_in["help"]["text"]


def test_sarif_says_how_to_fix_what_was_found(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    file = tmp_path / "r.urdf"
    file.write_text('<robot name="r"><link name="a"/><link name="a"/></robot>')
    assert main(["lint", str(file), "--isolated", "--output-format", "sarif"]) == 1
    (log,) = json.loads(capsys.readouterr().out)["runs"]
    help_of = {each["id"]: each["help"]["markdown"] for each in log["tool"]["driver"]["rules"]}
    assert "How to fix it: " in help_of["NAM001"]
    assert "How to fix it: " not in help_of["JNT005"]

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

from sdfcheck import __version__
from sdfcheck.lint.diagnostic import Missing, MissingKind
from sdfcheck.release import HOME
from sdfcheck.report import OutputFormat, render
from tests.unit.report.runs import diagnostic, facts, parsed, rich_diagnostic, run


def spot(line: int, column: int, offset: int) -> dict[str, int]:
    return {"line": line, "column": column, "offset": offset}


def place(file: str, start: dict[str, int], end: dict[str, int]) -> dict[str, Any]:
    return {"file": file, "range": {"start": start, "end": end}}


def test_json_of_a_diagnostic() -> None:
    (found,) = parsed(OutputFormat.JSON, rich_diagnostic(), rules=(facts(),))["diagnostics"]
    here = place("arm.sdf", spot(2, 5, 8), spot(2, 6, 9))
    label = place("arm.sdf", spot(2, 10, 13), spot(2, 11, 14))
    origin = place("world.xacro", spot(1, 1, 0), spot(1, 5, 4))
    assert found == {
        "code": "NAM901",
        "name": "taken-name",
        "url": None,
        "severity": "error",
        "message": "name `a` is taken",
        **here,
        "related": [{**label, "message": "here"}],
        "origins": [{**origin, "message": "included here"}],
        "help": "rename it",
        "fix": {"applicability": "safe", "message": "write `c`", "edits": [{**here, "text": "c"}]},
        "affects": {
            "drake": {"verdict": "reject", "effect": "aborts"},
            "gazebo": {"verdict": "warn", "effect": "ignores it"},
        },
        "missing": None,
    }


def test_json_links_built_in_rules() -> None:
    built_in = facts(module="sdfcheck_rules.nam.taken_name")
    (found,) = parsed(OutputFormat.JSON, rich_diagnostic(), rules=(built_in,))["diagnostics"]
    assert found["url"] == f"{HOME}/latest/rules/taken-name/"


def test_json_of_a_run() -> None:
    skipped = ((Path("b.sdf"), "template"), (Path("a.sdf"), "empty"))
    log = parsed(OutputFormat.JSON, rich_diagnostic(), suppressed=2, skipped=skipped)
    assert len(log.pop("diagnostics")) == 1
    assert log == {
        "version": 1,
        "tool": {"name": "sdfcheck", "version": __version__},
        "skipped": [{"file": "a.sdf", "reason": "empty"}, {"file": "b.sdf", "reason": "template"}],
        "summary": {
            "files": 1,
            "errors": 1,
            "warnings": 0,
            "infos": 0,
            "safe_fixes": 1,
            "unsafe_fixes": 0,
            "fixed": 0,
            "suppressed": 2,
            "missing": 0,
            "failing": 1,
        },
    }


def test_json_says_what_is_only_not_on_this_computer() -> None:
    lacking = diagnostic("«a»", missing=Missing(MissingKind.PACKAGE, "arm_description", 3))
    log = parsed(OutputFormat.JSON, lacking, diagnostic("«b»"))
    assert [each["missing"] for each in log["diagnostics"]] == [
        {"kind": "package", "name": "arm_description", "uses": 3},
        None,
    ]
    assert (log["summary"]["missing"], log["summary"]["failing"]) == (1, 1)


def test_json_has_every_key_also_when_there_is_nothing_to_say() -> None:
    bare, full = (
        parsed(OutputFormat.JSON, d)["diagnostics"][0] for d in (diagnostic("«a»"), rich_diagnostic())
    )
    assert bare.keys() == full.keys()
    assert (bare["fix"], bare["help"], bare["related"], bare["affects"]) == (None, None, [], {})


def test_jsonl_prints_the_objects_of_json() -> None:
    sample = run(rich_diagnostic(), diagnostic("«a\nb»"), rules=(facts(),))
    lines = render(OutputFormat.JSONL, sample).splitlines()
    whole = json.loads(render(OutputFormat.JSON, sample))
    assert [json.loads(line) for line in lines] == whole["diagnostics"]
    assert render(OutputFormat.JSONL, run()) == ""

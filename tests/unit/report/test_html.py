"""The HTML report: its content, its policy, and that names stay text."""

from __future__ import annotations

import base64
import json
import re
from hashlib import sha256
from pathlib import Path
from typing import Any

import pytest

from sdfcheck.cli.main import main
from sdfcheck.lint.diagnostic import Diagnostic, Label, Missing, MissingKind, Origin, Severity
from sdfcheck.lint.fix import Fix, TextEdit
from sdfcheck.report import OutputFormat, content, render
from sdfcheck.report.content import DELETED, INSERTED, KEPT, TITLE, Hunk, hunks
from sdfcheck.report.formats.html import MOST_ROBOTS
from sdfcheck.source.text import Span
from tests.unit.report.runs import diagnostic, facts, fixed, marked, rich_diagnostic, run

EVIL = "</script><script>alert(1)</script><img src=x onerror=alert(1)>"


def page(*found: Diagnostic, **fields: Any) -> str:
    return render(OutputFormat.HTML, run(*found, **fields))


def data(*found: Diagnostic, **fields: Any) -> Any:
    (text,) = re.findall(
        r'<script type="application/json" id="data">(.*?)</script>', page(*found, **fields), re.DOTALL
    )
    return json.loads(text)


def test_a_finding_has_all_that_the_other_formats_have() -> None:
    shown = data(rich_diagnostic(), rules=(facts(),))
    (finding,) = shown["findings"]
    assert (finding["line"], finding["column"]) == (2, 5)
    assert finding["help"] == "rename it"
    assert finding["origins"] == ["included here: world.xacro:1:1"]
    assert finding["fix"]["hunks"][0]["pieces"][1:3] == [["-", "a"], ["+", "c"]]
    assert "\x1b[1;31m^\x1b[0m" in finding["frames"][0]["text"]
    assert shown["places"] == ["arm.sdf"]
    assert shown["rules"] == [
        {
            "code": "NAM901",
            "name": "taken-name",
            "summary": "Two things have one name.",
            "page": None,
            "remedy": "",
        }
    ]
    assert shown["reactions"][finding["affects"]] == [
        {"consumer": "Drake", "verdict": "reject", "words": "aborts"},
        {"consumer": "Gazebo", "verdict": "warn", "words": "ignores it"},
    ]


def test_findings_without_effects_refer_to_none() -> None:
    shown = data(diagnostic("«a»"))
    assert "affects" not in shown["findings"][0]
    assert shown["reactions"][0] == []


def test_safe_fixes_come_first() -> None:
    warning = diagnostic("«a»", code="SCH902", name="odd-thing", severity=Severity.WARNING)
    sections = data(fixed(warning, "b"), diagnostic("«a»"), diagnostic("«a»", path="b.sdf"))["sections"]
    assert [(section["fixable"], section["rows"]) for section in sections] == [
        (True, [{"rule": 0, "severity": "warning", "count": 1, "files": 1}]),
        (False, [{"rule": 1, "severity": "error", "count": 2, "files": 2}]),
    ]


def test_files_not_on_this_computer_are_apart() -> None:
    lacking = diagnostic("«a»", missing=Missing(MissingKind.PACKAGE, "my_robot"))
    shown = data(lacking)
    assert shown["findings"][0]["missing"] is True
    assert shown["sections"] == []
    assert "my_robot" in "\n".join(shown["missing"])


def test_the_policy_allows_the_own_style_and_script_only() -> None:
    text = page(diagnostic("«a»"))
    (policy,) = re.findall(r'http-equiv="Content-Security-Policy" content="([^"]*)"', text)
    for tag in ("style", "script"):
        (own,) = re.findall(rf"<{tag}>(.*?)</{tag}>", text, re.DOTALL)
        digest = base64.b64encode(sha256(own.encode()).digest()).decode()
        assert f"{tag}-src 'sha256-{digest}'" in policy
    assert policy.startswith("default-src 'none'; ")
    assert "unsafe" not in policy
    assert not re.search(r'\b(?:src|href)="(?!#main)', text.partition("<script")[0])


def test_names_are_text() -> None:
    span, _ = marked(f"«{EVIL}»", EVIL)
    found = fixed(diagnostic("«a»")._replace(span=span, message=EVIL, name=EVIL, help=EVIL), EVIL)
    found = found._replace(labels=(Label(span, EVIL),), origins=(Origin(span, EVIL),))
    text = page(found, rules=(facts(summary=EVIL),), skipped=((span.source.path, EVIL),))
    assert text.count("</script>") == 2
    assert "<img" not in text
    assert "alert(1)</script>" not in text


def test_past_a_number_findings_have_no_lines_of_code(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(content, "MOST_FRAMES", 2)
    found = data(*(diagnostic("«a»") for _ in range(3)))["findings"]
    assert ["frames" in each for each in found] == [True, True, False]


def lint(folder: Path, *options: str) -> str:
    out = folder / "out.html"
    main(["lint", str(folder), "--isolated", "-q", "--exit-zero", *options, "--output-format", f"html={out}"])
    return out.read_text(encoding="utf-8")


def robots_of(text: str) -> list[Any]:
    found = re.findall(r'<script type="application/json" id="robot-\d+">(.*?)</script>', text, re.DOTALL)
    return [json.loads(each) for each in found]


def test_robots_are_embedded_with_their_findings(tmp_path: Path) -> None:
    for name, mass in (("a", 1), ("b", -1)):
        (tmp_path / f"{name}.urdf").write_text(
            f'<robot name="{name}"><link name="{EVIL.replace("<", "&lt;")}"><inertial><mass value="{mass}"/>'
            '<inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/></inertial></link></robot>'
        )
    (tmp_path / "broken.urdf").write_text("no robot")
    text = lint(tmp_path)
    first, second = robots_of(text)
    assert [robot["scenes"][0]["models"][0]["name"] for robot in (first, second)] == ["a", "b"]
    assert "INR001" not in [found["code"] for found in first["findings"]]
    assert "INR001" in [found["code"] for found in second["findings"]]
    assert text.count("</script>") == 5
    (viewer,) = re.findall(r'<script type="application/json" id="viewer">(.*?)</script>', text, re.DOTALL)
    before, after = json.loads(viewer)
    policy = re.search(r'http-equiv="Content-Security-Policy" content="([^"]*)"', text)
    framed = re.search(r'http-equiv="Content-Security-Policy" content="([^"]*)"', before)
    assert policy
    assert framed
    assert set(re.findall("sha256-[^']*", framed[1])) < set(re.findall("sha256-[^']*", policy[1]))
    assert before.count(TITLE) == 2
    assert after.endswith("</html>\n")


def test_a_robot_has_the_gravest_findings_beside_it(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("sdfcheck.report.content._FINDINGS", 2)
    (tmp_path / "a.sdf").write_text(
        '<sdf version="1.9"><!-- -- --><model name="m"><link name="a"/><link name="a"/><link name="a"/></model></sdf>'
    )
    text = lint(tmp_path)
    (robot,) = robots_of(text)
    assert [found["severity"] for found in robot["findings"]] == ["error", "error"]


def test_many_files_and_those_not_expanded_show_no_robots(tmp_path: Path) -> None:
    for number in range(MOST_ROBOTS):
        (tmp_path / f"{number}.urdf").write_text('<robot name="a"><link name="b"/></robot>')
    assert len(robots_of(lint(tmp_path))) == MOST_ROBOTS
    assert robots_of(lint(tmp_path, "--no-expand")) == []
    (tmp_path / "more.urdf").write_text('<robot name="a"><link name="b"/></robot>')
    assert robots_of(lint(tmp_path)) == []


def test_robots_do_not_make_a_report_too_large(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    for name in "ab":
        (tmp_path / f"{name}.urdf").write_text(f'<robot name="{name}"><link name="b"/></robot>')
    size = len(json.dumps(robots_of(lint(tmp_path))[0]))
    monkeypatch.setattr("sdfcheck.report.content._BYTES", size + 10)
    assert len(robots_of(lint(tmp_path))) == 1


def hunks_of(text: str, *replacements: str) -> list[Hunk]:
    primary, others = marked(text)
    spans: list[Span] = [primary, *others]
    edits = tuple(TextEdit(span, new) for span, new in zip(spans, replacements, strict=True))
    return list(hunks(Fix("change it", edits)))


def test_changes_of_one_line_are_one_hunk() -> None:
    first, second = hunks_of("<a>\r\n<b x='«1»' y='{2}'/>\r\n{}</a>", "3", "4", "<c/>\n")
    change = ((KEPT, "<b x='"), (DELETED, "1"), (INSERTED, "3"))
    other = ((KEPT, "' y='"), (DELETED, "2"), (INSERTED, "4"), (KEPT, "'/>"))
    assert first == Hunk(2, (*change, *other))
    assert second == Hunk(3, ((INSERTED, "<c/>\n"), (KEPT, "</a>")))


def test_long_lines_are_cut_around_a_change() -> None:
    ((line, pieces),) = hunks_of("a" * 500 + "«x»" + "b" * 500 + "{y}" + "c" * 500, "1", "2" * 5000)
    assert line == 1
    texts = [text for _, text in pieces]
    assert texts[0] == "…" + "a" * 80
    assert texts[3] == "b" * 80 + "…" + "b" * 80
    assert texts[5] == "2" * 2000 + "…"
    assert texts[6] == "c" * 80 + "…"


def test_control_characters_are_spelled_out() -> None:
    ((_, pieces),) = hunks_of("\x1b[31m«\u202e»", "\x9b")
    assert [text for _, text in pieces] == ["␛[31m", "<U+202E>", "<U+009B>"]


def test_deleted_line_ends_bring_the_next_line() -> None:
    assert hunks_of("<a/>\n«<b/>\n»<c/>\n", "") == [Hunk(2, ((DELETED, "<b/>\n"), (KEPT, "<c/>")))]


def test_each_file_is_drawn_or_has_the_reason_and_no_name_is_a_whole_path(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    folder, elsewhere = tmp_path / "robots", tmp_path / "elsewhere"
    folder.mkdir()
    elsewhere.mkdir()
    (folder / "a.urdf").write_text('<robot name="r"><link name="l"/></robot>')
    (folder / "b.sdf").write_text('<sdf version="1.9"><world name="w"/></sdf>')
    (folder / "c.urdf.xacro").write_text('<robot name="r"><xacro:nothing/></robot>')
    monkeypatch.chdir(elsewhere)
    text = lint(folder)
    data = json.loads(re.findall(r'id="data">(.*?)</script>', text, re.DOTALL)[0])
    reasons = {each["file"]: each["reason"] for each in data["notDrawn"]}
    assert data["robots"] == ["a.urdf"]
    assert set(reasons) == {"b.sdf", "c.urdf.xacro"}
    assert reasons["b.sdf"] == "it has no links"
    assert str(tmp_path) not in text

import json
from pathlib import Path

import pytest

from sdfcheck.cli.main import main
from sdfcheck.cli.rules import listed, loaded, narrowed
from sdfcheck.lint.config.configuration import Configuration
from sdfcheck.report.manual import markdown

SHAPE = """
from sdfcheck import Bad, Good, Rule, Severity


class OddFlaw(Rule):
    '''A flaw is ``odd``.

    It matters.
    '''

    code = "XYZ001"
    name = "odd-flaw"
    severity = Severity.WARNING
    selects = ("sdf:model",)
    bad = (Bad("<model «odd»/>", fixed="<model/>"), Bad("<a/>"))
    good = (Good("<model/>", why="even"),)

    def check(self, model):
        return ()
"""


@pytest.fixture(autouse=True)
def pack(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    monkeypatch.chdir(tmp_path)
    monkeypatch.delenv("FORCE_COLOR", raising=False)
    folder = tmp_path / f"pack_{tmp_path.parent.name}"
    folder.mkdir()
    (folder / "odd_flaw.py").write_text(SHAPE)
    Path("sdfcheck.toml").write_text(f'plugins = ["{folder.name}"]')


def output(capsys: pytest.CaptureFixture[str], *arguments: str) -> str:
    trusting = [] if "--isolated" in arguments else ["--trust-config"]
    assert main([*arguments, *trusting]) == 0
    return capsys.readouterr().out


def test_rules_are_listed_with_those_of_plugins_and_the_engine(capsys: pytest.CaptureFixture[str]) -> None:
    lines = output(capsys, "rules").splitlines()
    codes = [line.split()[0] for line in lines]
    assert codes == sorted(codes)
    assert {"XYZ001", "SUP001", "SUP002", "INT001"} <= set(codes)
    (line,) = (line for line in lines if line.startswith("XYZ001"))
    assert line.split() == ["XYZ001", "odd-flaw", "warning", "safe", "fix", "A", "flaw", "is", "`odd`."]
    assert "XYZ001" not in output(capsys, "rules", "--isolated")


def test_rules_can_be_narrowed_and_read_by_machines(capsys: pytest.CaptureFixture[str]) -> None:
    listed = json.loads(output(capsys, "rules", "XYZ", "--output-format", "json"))
    assert listed["version"] == 1
    assert listed["rules"] == [
        {
            "code": "XYZ001",
            "name": "odd-flaw",
            "family": "XYZ",
            "severity": "warning",
            "summary": "A flaw is `odd`.",
            "fix": "safe",
            "default": True,
            "preview": False,
            "url": None,
            "affects": {},
        }
    ]


@pytest.mark.parametrize("selector", ["XYZ001", "xyz001", "odd-flaw", "XYZ"])
def test_a_rule_is_explained(capsys: pytest.CaptureFixture[str], selector: str) -> None:
    text = output(capsys, "rule", selector)
    assert text.startswith("# odd-flaw (XYZ001)\n\n**warning** · on by default · safe fix\n\nA flaw")
    assert "A flaw is `odd`.\n\nIt matters.\n\n" in text
    assert "```xml\n<model odd/>\n```\n\n" in text
    assert "Even:\n\n```xml" in text
    assert "<!-- sdfcheck:ignore[odd-flaw] reason -->" in text
    assert "How to fix it" not in text


def test_an_explanation_for_machines(capsys: pytest.CaptureFixture[str]) -> None:
    (page,) = json.loads(output(capsys, "rule", "odd-flaw", "--output-format", "json"))["rules"]
    assert page["documentation"] == "A flaw is `odd`.\n\nIt matters."
    assert [(bad["text"], bad["files"]) for bad in page["bad"]] == [("<model odd/>", {}), ("<a/>", {})]
    assert page["good"] == [{"name": "robot.sdf", "text": "<model/>", "files": {}, "why": "even"}]


def test_a_terminal_gets_a_laid_out_page(capsys: pytest.CaptureFixture[str]) -> None:
    text = output(capsys, "rule", "odd-flaw", "--color", "always")
    assert "\x1b[" in text
    assert "```" not in text


def test_the_engines_own_rules_are_explained(capsys: pytest.CaptureFixture[str]) -> None:
    text = output(capsys, "rule", "SUP001", "INT001")
    assert "# unused-suppression (SUP001)" in text
    assert "# internal-error (INT001)" in text
    assert text.count("## How to fix it\n\n") == 2
    assert "Turn it off" not in text


def test_an_unknown_rule_is_wrong_usage(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["rule", "od-flaw", "--trust-config"]) == 2
    assert capsys.readouterr().err == "error: unknown rule `od-flaw`; did you mean `odd-flaw`?\n"
    assert main(["rule"]) == 2


@pytest.mark.parametrize("width", [60, 80, 100])
def test_summaries_are_whole_on_narrow_terminals(width: int) -> None:
    rules = narrowed(loaded(Configuration(isolated=True))[1], ())
    lines = listed(rules, width=width, color=False)
    assert max(map(len, lines)) <= width
    assert len(lines) >= 1 + 2 * len(rules)
    text = " ".join(line.strip() for line in lines)
    assert [facts.code for facts in rules if markdown(facts.summary) not in text] == []


def test_suppressions_of_a_rule_that_fails_are_not_called_unused(
    capsys: pytest.CaptureFixture[str], tmp_path: Path
) -> None:
    (file,) = tmp_path.glob("pack_*/odd_flaw.py")
    file.write_text(SHAPE.replace("return ()", "raise ValueError(model.name)"))
    model = '<model name="m"><link name="l"/></model>'
    text = f'<sdf version="1.12"><!-- sdfcheck:ignore[odd-flaw] so it is -->{model}</sdf>'
    Path("m.sdf").write_text(text)
    assert main(["lint", "m.sdf", "--trust-config", "--fix", "--output-format", "concise"]) == 1
    out = capsys.readouterr().out
    assert "INT001" in out
    assert "SUP001" not in out
    assert Path("m.sdf").read_text() == text


def test_pages_of_simulations_do_not_call_their_findings_bugs(capsys: pytest.CaptureFixture[str]) -> None:
    assert "How to fix it" in output(capsys, "rule", "INT001")
    assert "How to fix it" not in output(capsys, "rule", "SIM004")

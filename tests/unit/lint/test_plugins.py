"""Packs from other authors: how they are found, and what happens when they are faulty."""

from __future__ import annotations

import json
import os
from collections.abc import Callable
from pathlib import Path

import pytest

import sdfcheck
from sdfcheck.cli.main import main
from sdfcheck.lint.rulebook.packs import load_index

HEAD = """
from sdfcheck import IN_MODEL, Bad, Diagnostic, Good, Rule, Severity, problems


class Sound(Rule):
    '''A link is called «bad».'''

    code = "TST001"
    name = "sound"
    severity = Severity.WARNING
    selects = ("sdf:link",)
    scaffold = IN_MODEL
    bad = (Bad('<link name="«bad»"/>'),)
    good = (Good('<link name="good"/>'),)

    def check(self, link):
        name = link.attribute("name")
        if name and name.text == "bad":
            yield self.diagnostic(name, "this link is called `bad`")
"""
FAULTY = """

class Faulty(Sound):
    '''Another rule.'''

    code = "TST002"
    name = "faulty"
"""
MODEL = '<sdf version="1.9"><model name="m"><link name="bad"/></model></sdf>'
SOUND = "model.sdf:1:48: warning: this link is called `bad` [TST001]"

Run = Callable[..., tuple[int, list[str], list[str]]]


@pytest.fixture(autouse=True)
def here(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    monkeypatch.chdir(tmp_path)
    monkeypatch.delenv("SDFCHECK_DEBUG", raising=False)
    Path("model.sdf").write_text(MODEL)


@pytest.fixture
def run(capsys: pytest.CaptureFixture[str]) -> Run:
    def lint(*arguments: str) -> tuple[int, list[str], list[str]]:
        code = main(["lint", "model.sdf", "--trust-config", "--output-format", "concise", *arguments])
        out, err = capsys.readouterr()
        return code, out.splitlines(), err.splitlines()

    return lint


def pack(*, name: str = "checks", **modules: str) -> Path:
    """A pack in a folder of that name, and a configuration with it."""
    folder = Path(name)
    folder.mkdir()
    for module, text in modules.items():
        (folder / f"{module}.py").write_text(text)
    Path("sdfcheck.toml").write_text(f'plugins = ["{name}"]\n')
    return folder


def line_of(text: str, part: str) -> int:
    return text[: text.index(part)].count("\n") + 1


@pytest.mark.parametrize(
    ("body", "place", "reason"),
    [
        ("bad = ()", "bad = ()", "has no `bad` example"),
        ("good = ()", "good = ()", "has no `good` example"),
        ("bad = Bad('x')", "bad = Bad", "`bad` should be a tuple of Bad(…): a comma is missing after it"),
        ("bad = ('x',)", "bad = ('x'", "`bad` should be a tuple of Bad(…)"),
        ("bad = (Bad(5),)", "bad = (Bad(5)", "`bad` has an example that is not a text: 5"),
        ("severity = 'high'", "severity = 'high'", "`severity` should be a Severity, such as"),
        ("severity = None", "severity = None", "has no `severity`"),
        ("code = 'tst2'", "code = 'tst2'", "`code` should be capitals and three digits"),
        ("name = 'Is Faulty'", "name = 'Is", "`name` should be lower-case words joined by hyphens"),
        ("selects = ('sdf:jiont',)", "selects = ('sdf:jiont'", "no `jiont`, did you mean `joint`?"),
        ("selects = ('urdf:link/pose',)", "selects = ('urdf", "`urdf:link/pose`, which is nowhere"),
        ("selects = ('mjcf:body',)", "selects = ('mjcf", "should begin with one of `sdf:`, `urdf:`"),
        (
            "selects = ('sdf:joint/@name',)",
            "selects = ('sdf:joint/",
            "should name an element after the colon",
        ),
        ("selects = 'sdf:link'", "selects = 'sdf:link'", "`selects` should be a tuple of selectors"),
        ("selects = ()", "class Faulty", "looks at nothing"),
        ("looks_at = (str,)", "looks_at = (str,)", "`looks_at` has `str`, which is not a part of a robot"),
        ("explains = (str,)", "explains = (str,)", "`explains` has `str`, which is not a kind of problem"),
        ("affects = {'gazebo': 5}", "affects = {", "`affects` should say what consumers do"),
        ("default = 'off'", "default = 'off'", "`default` should be True or False"),
        ("remedy = 1", "remedy = 1", "`remedy` should be a text in Markdown"),
        ("__doc__ = ''", "class Faulty", "has no docstring"),
        ("check = Rule.check", "class Faulty", "has no `check`"),
        ("code = 'TST001'", "code = 'TST001'\n    x", "TST001 is taken by checks/rules.py:"),
        ("name = 'zero-axis'", 'code = "TST002"', "zero-axis is taken by sdfcheck_rules."),
    ],
)
def test_a_faulty_rule_is_left_out_and_named_with_its_place(
    run: Run, body: str, place: str, reason: str
) -> None:
    text = f"{HEAD}{FAULTY}    {body}\n    x = 1\n"
    pack(rules=text)
    code, out, (line,) = run()
    assert code == 2
    assert out[0] == SOUND
    last = text.rindex(place)
    assert line.startswith(f"error: checks/rules.py:{text[:last].count(chr(10)) + 1}: "), line
    assert reason in line
    assert line.endswith("the rule is left out")
    assert "bug" not in line


def test_a_rule_without_a_code_is_not_ignored_in_silence(run: Run) -> None:
    pack(rules=HEAD + "class NoCode(Sound):\n    '''x'''\n\nclass _Part(Sound): ...\n")
    code, _, (line,) = run()
    assert code == 2
    assert "NoCode: has no `code` of its own" in line


@pytest.mark.parametrize(
    ("text", "place", "reason"),
    [
        ("import sys\nimport gone_for_good\n", 2, "ModuleNotFoundError: No module named 'gone_for_good'"),
        ("def f(:\n", 1, "SyntaxError"),
        ("\n\nimport sys\nsys.exit(3)\n", 4, "SystemExit: 3"),
        ("from sdfcheck import problems\nx = problems.Gone\n", 2, "no kind of problem is called 'Gone'"),
    ],
)
def test_a_module_that_fails_is_left_out(run: Run, text: str, place: int, reason: str) -> None:
    pack(broken=text, rules=HEAD)
    code, out, (line,) = run()
    assert (code, out[0]) == (2, SOUND)
    assert line.startswith(f"error: checks/broken.py:{place}: broken.py cannot be imported: ")
    assert reason in line


@pytest.mark.parametrize(
    ("body", "reason"),
    [
        ("        return [link.gone]", "AttributeError: 'Element' object has no attribute 'gone'"),
        ("        yield 'a text'", "`check` yielded 'a text', not a Diagnostic"),
        ("        return 'a text'", "`check` should yield diagnostics, and returned 'a text'"),
        ("        return None", "`check` should yield diagnostics, and returned None"),
        ("        return self.diagnostic(link, 'x')", "`check` returned a Diagnostic: yield it"),
        ("        raise SystemExit(3)", "SystemExit: 3"),
        ("        raise GeneratorExit", "GeneratorExit"),
        ("        return [self.diagnostic(link, 5)]", "with 5 as message: it should be a text"),
        ("        return [self.diagnostic(link, 'x', fix='y')]", "with 'y' as fix: it should be a Fix"),
        ("        return [self.diagnostic(link, 'x', severity='y')]", "with 'y' as severity"),
        ("        return [self.diagnostic(link, 'x')._replace(code='X')]", "a diagnostic of X faulty"),
        ("        return [self.diagnostic('x', 'y')]", "AttributeError: 'str' object has no"),
    ],
)
def test_a_check_that_fails_is_one_diagnostic_in_each_file(run: Run, body: str, reason: str) -> None:
    text = f"{HEAD}{FAULTY}    def check(self, link):\n{body}\n"
    pack(rules=text)
    Path("model.sdf").write_text(MODEL.replace('<link name="bad"/>', '<link name="bad"/><link name="b"/>'))
    code, (failure, sound, _), err = run()
    assert (code, sound, err) == (1, SOUND, [])
    lines = (line_of(text, "    def check(self, link):\n" + body), line_of(text, body))
    starts = tuple(f"model.sdf:1:1: error: rule TST002 faulty failed at checks/rules.py:{n}: " for n in lines)
    assert failure.startswith(starts), failure
    assert reason in failure
    assert "bug" not in failure


def test_prints_of_rules_are_not_in_the_report(capsys: pytest.CaptureFixture[str]) -> None:
    pack(
        rules="print('imported')\n"
        + HEAD.replace("        name =", "        print('called')\n        name =")
    )
    assert main(["lint", "model.sdf", "--trust-config", "--output-format", "json"]) == 1
    out, err = capsys.readouterr()
    assert [d["code"] for d in json.loads(out)["diagnostics"]] == ["TST001"]
    called = line_of(HEAD, "def check") + 1
    aside = " prints; this is not part of the report:"
    assert err.splitlines()[:4] == [
        f"warning: plugin {os.path.abspath('checks')}{aside}",
        "imported",
        f"warning: rule TST001 sound (checks/rules.py:{called}){aside}",
        "called",
    ]


def test_a_selector_of_a_rule_that_is_left_out_says_so(run: Run) -> None:
    pack(rules=f"{HEAD}{FAULTY}    bad = ()\n")
    code, _, (line,) = run("--select", "faulty")
    assert code == 2
    assert "unknown rule `faulty`" in line
    assert "has no `bad` example" in line


def test_the_list_of_rules_says_what_is_left_out(capsys: pytest.CaptureFixture[str]) -> None:
    pack(rules=f"{HEAD}{FAULTY}    bad = ()\n")
    for arguments in (["rules", "TST"], ["rule", "sound"]):
        assert main([*arguments, "--trust-config"]) == 2
        out, err = capsys.readouterr()
        assert "TST001" in out
        assert "has no `bad` example" in err


def test_programs_get_faults_as_an_exception() -> None:
    pack(rules=f"{HEAD}{FAULTY}    bad = ()\n")
    with pytest.raises(sdfcheck.WrongUsage, match=r"checks/rules\.py:\d+: Faulty: has no `bad` example"):
        sdfcheck.lint(Path("model.sdf"), trust_config=True)


@pytest.mark.parametrize(
    ("name", "reason"),
    [
        ("gone", "sdfcheck.toml:1: plugin gone: no folder, no entry point `sdfcheck.rules` and no package"),
        ("./gone", "plugin gone: no such folder"),
        ("empty", "there are neither rules nor tables (*.vendor.txt) in it"),
        ("./broken", "broken/__init__.py:2: ZeroDivisionError: division by zero"),
    ],
)
def test_a_plugin_that_cannot_be_loaded_at_all_stops_the_run(run: Run, name: str, reason: str) -> None:
    Path("empty").mkdir()
    Path("broken").mkdir()
    Path("broken/__init__.py").write_text("RATIO = 0\nRATIO = 1 / RATIO\n")
    Path("sdfcheck.toml").write_text(f'plugins = ["{name}"]\n')
    code, out, (line,) = run()
    assert (code, out) == (2, [])
    assert reason in line


def test_modules_of_a_folder_import_each_other_and_tests_are_left_alone(run: Run) -> None:
    folder = pack(rules="from .parts.names import HEAD\n" + HEAD, test_rules="import gone_for_good\n")
    (folder / "parts").mkdir()
    (folder / "parts" / "names.py").write_text("HEAD = 1\n")
    (folder / "tests").mkdir()
    (folder / "tests" / "conftest.py").write_text("import gone_for_good\n")
    code, out, err = run()
    assert (code, out[0], err) == (1, SOUND, [])


def test_two_folders_of_one_name_are_two_packs() -> None:
    other = HEAD.replace("TST001", "OTH001").replace('"sound"', '"other"')
    for parent, text in (("one", HEAD), ("two", other)):
        Path(parent, "checks").mkdir(parents=True)
        Path(parent, "checks", "rules.py").write_text(text)
    index = load_index((Path("one/checks"), Path("two/checks")))
    assert not index.faults
    assert {"TST001", "OTH001"} <= {facts.code for facts in index.facts}

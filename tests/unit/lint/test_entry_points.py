"""Installed packs: known by their entry points, loaded when they are asked for."""

from __future__ import annotations

import sys
from pathlib import Path

import pytest

from sdfcheck.cli.main import main
from sdfcheck.lint.rulebook.index import main as write_index
from sdfcheck.lint.rulebook.pack import PackError
from sdfcheck.lint.rulebook.packs import load_index
from sdfcheck.lint.rulebook.plugins import find_pack

RULES = """
from sdfcheck import IN_MODEL, Bad, Good, Rule, Severity


class BadName(Rule):
    '''A link is called «bad».'''

    code = "TST001"
    name = "bad-name"
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
MODEL = '<sdf version="1.9"><model name="m"><link name="bad"/></model></sdf>'


@pytest.fixture(autouse=True)
def here(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    monkeypatch.chdir(tmp_path)
    Path("model.sdf").write_text(MODEL)


def lint(capsys: pytest.CaptureFixture[str], *arguments: str) -> tuple[int, str, str]:
    code = main(["lint", "model.sdf", "--output-format", "concise", *arguments])
    out, err = capsys.readouterr()
    return code, out, err


@pytest.fixture
def installed(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> Path:
    """A folder of installed packages, with a pack that declares an entry point."""
    site = tmp_path / "site"
    package = site / f"acme_{tmp_path.parent.name}" / "robot_rules"
    package.mkdir(parents=True)
    (package / "rules.py").write_text(RULES)
    (site / "acme-1.0.dist-info").mkdir()
    (site / "acme-1.0.dist-info" / "METADATA").write_text("Metadata-Version: 2.1\nName: acme\nVersion: 1.0\n")
    declare(site, f"acme = {package.parent.name}.robot_rules")
    monkeypatch.syspath_prepend(site)
    return package


def declare(site: Path, line: str) -> None:
    (site / "acme-1.0.dist-info" / "entry_points.txt").write_text(f"[sdfcheck.rules]\n{line}\n")


def test_an_installed_pack_is_known_by_its_entry_point(
    capsys: pytest.CaptureFixture[str], installed: Path
) -> None:
    Path("sdfcheck.toml").write_text('plugins = ["acme"]\n')
    code, out, err = lint(capsys, "--trust-config")
    assert (code, err) == (1, "")
    assert "[TST001]" in out
    assert main(["rules", "--test", "acme"]) == 0


def test_nothing_is_loaded_unasked(capsys: pytest.CaptureFixture[str], installed: Path) -> None:
    Path("checks").mkdir()
    Path("checks", "rules.py").write_text(RULES)
    _, out, _ = lint(capsys, "--isolated")
    assert "TST001" not in out
    assert f"{installed.parent.name}.robot_rules.rules" not in sys.modules


def test_an_installed_pack_is_known_by_its_import_name(installed: Path) -> None:
    name = f"{installed.parent.name}.robot_rules"
    assert find_pack(name).folder == installed
    assert find_pack(f"{name}.rules").file == installed / "rules.py"
    index = load_index((f"{name}.rules",))
    assert not index.faults
    assert "TST001" in {facts.code for facts in index.facts}


@pytest.mark.parametrize(
    ("value", "reason"),
    [
        ("acme.robot:Rules", "its entry point `acme.robot:Rules` should name a package or module"),
        ("gone_for_good", "its entry point names `gone_for_good`, which cannot be imported"),
        ("gone_for_good.rules", "ModuleNotFoundError: No module named 'gone_for_good'"),
    ],
)
def test_a_faulty_entry_point(installed: Path, value: str, reason: str) -> None:
    declare(installed.parents[1], f"acme = {value}")
    with pytest.raises(PackError) as caught:
        find_pack("acme")
    assert reason in str(caught.value)


def test_two_installed_packs_of_one_name(installed: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    site = installed.parents[1]
    (site / "other-1.0.dist-info").mkdir()
    (site / "other-1.0.dist-info" / "METADATA").write_text("Metadata-Version: 2.1\nName: other\nVersion: 1\n")
    (site / "other-1.0.dist-info" / "entry_points.txt").write_text("[sdfcheck.rules]\nacme = other\n")
    with pytest.raises(PackError, match="several installed packages declare it"):
        find_pack("acme")


def test_an_index_is_taken_and_its_age_is_noticed(
    installed: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    name = f"{installed.parent.name}.robot_rules"
    index = installed / "rule_index.py"
    assert write_index(["--check", name]) == 1
    assert not index.exists()
    assert write_index([name]) == 0
    assert write_index(["--check", name]) == 0
    assert main(["rules", "--test", "acme"]) == 0
    index.write_text(index.read_text().replace("bad-name", "worse-name"))
    sys.modules.pop(f"{name}.rule_index")
    assert main(["rules", "--test", "acme"]) == 1
    assert "rule_index.py:1: the index is not up to date" in capsys.readouterr().out
    index.write_text("RULES = ({},)")
    sys.modules.pop(f"{name}.rule_index")
    with pytest.raises(PackError, match="its index cannot be read"):
        load_index(("acme",))

from pathlib import Path

import pytest

from sdfcheck.lint.rulebook.packs import RuleIndex, load_index
from tables import rule_pages
from tables.rule_pages import CONFIGURATION, OVERVIEW, README, RULE_PAGES, main, with_table

PROJECT = Path(__file__).parents[3]


@pytest.fixture
def docs(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.chdir(tmp_path)
    family = [facts for facts in load_index().facts if facts.family == "NS"]
    monkeypatch.setattr(rule_pages, "load_index", lambda: RuleIndex(family))
    CONFIGURATION.parent.mkdir()
    CONFIGURATION.write_text("<!-- keys -->\n<!-- /keys -->\n")
    README.write_text("# A\n\n<!-- rules -->\nold\n<!-- /rules -->\n\nrest\n")
    return tmp_path


def test_pages_are_written_and_then_up_to_date(docs: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert main([]) == 0
    assert main(["--check"]) == 0
    assert capsys.readouterr().out == ""
    pages = rule_pages.files()
    assert len(pages) > 13
    for path in pages:
        text = path.read_text(encoding="utf-8")
        if path.parent == RULE_PAGES:
            assert "python -m tables.rule_pages" in text
    overview = OVERVIEW.read_text(encoding="utf-8")
    for path in RULE_PAGES.glob("*-*.md"):
        assert f"({path.name})" in overview
    readme = README.read_text(encoding="utf-8")
    assert readme.startswith("# A\n\n<!-- rules -->\n| family | about | rules |\n")
    assert readme.endswith("|\n<!-- /rules -->\n\nrest\n")
    assert "(docs/rules/README.md#ns)" in readme


def test_stale_and_leftover_entries_are_reported(docs: Path, capsys: pytest.CaptureFixture[str]) -> None:
    main([])
    gone, old = RULE_PAGES / "internal-error.md", RULE_PAGES / "never-was.md"
    gone.unlink()
    old.write_text("")
    assert main(["--check"]) == 1
    assert capsys.readouterr().out == "".join(
        f"{path} is stale: run `make generate`\n" for path in (gone, old)
    )
    main([])
    assert gone.exists()
    assert not old.exists()


def test_a_readme_without_marks_stays() -> None:
    assert with_table("no marks\n", "rules", "| x |\n") == "no marks\n"


def test_the_readme_of_the_project_has_marks() -> None:
    assert (
        with_table((PROJECT / "README.md").read_text(encoding="utf-8"), "rules", "| new |\n").count("| new |")
        == 1
    )

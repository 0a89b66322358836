"""All addresses of the project come from one place."""

from __future__ import annotations

import re
from pathlib import Path

from sdfcheck.lint.rulebook.packs import load_index
from sdfcheck.release import HOME, REPOSITORY

ROOT = Path(__file__).parents[1]
PAGES = [ROOT / "README.md", *(ROOT / "docs").glob("*.md"), ROOT / "CONTRIBUTING.md", ROOT / "pyproject.toml"]
_OURS = re.compile(r"https?://(?:[\w.-]+\.)?(?:sdfcheck|github)\.example[^\s\"')>`]*")


def test_addresses_begin_at_home() -> None:
    found = [address for page in PAGES for address in _OURS.findall(page.read_text(encoding="utf-8"))]
    assert found
    assert [address for address in found if not address.startswith((HOME, REPOSITORY))] == []


def test_each_built_in_rule_has_a_page() -> None:
    for facts in load_index().facts:
        assert facts.page == f"{HOME}/latest/rules/{facts.name}/"
        assert (ROOT / "docs" / "rules" / f"{facts.name}.md").is_file()


def test_rules_of_packs_have_no_page() -> None:
    assert load_index().facts[0]._replace(module="my_pack.rule").page is None

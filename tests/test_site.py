"""The site keeps the pages of each release, and a selector leads from one to another."""

from __future__ import annotations

import importlib.util
import json
import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

from sdfcheck.release import HOME, rule_page

pytestmark = [
    pytest.mark.slow,
    pytest.mark.xdist_group(__name__),
    pytest.mark.skipif(
        importlib.util.find_spec("mike") is None,
        reason="mike is not installed (pip install 'sdfcheck[docs]')",
    ),
]

ROOT = Path(__file__).parents[1]
RULE = "inverted-limits"
"""The one rule whose page is built: two versions of all pages take a minute."""


def run(folder: Path, *command: str) -> str:
    programs = os.pathsep.join([str(Path(sys.executable).parent), os.environ["PATH"]])
    done = subprocess.run(
        command, cwd=folder, env={**os.environ, "PATH": programs}, capture_output=True, text=True, check=False
    )
    assert done.returncode == 0, done.stderr
    return done.stdout


@pytest.fixture(scope="module")
def published(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The branch of the site after two releases."""
    folder = tmp_path_factory.mktemp("project")
    for name in ("mkdocs.yml", "README.md", "CONTRIBUTING.md", "CHANGELOG.md", "tables/root_pages.py"):
        (folder / name).parent.mkdir(exist_ok=True)
        shutil.copy(ROOT / name, folder / name)
    shutil.copytree(ROOT / "docs", folder / "docs", ignore=_other_rules)
    settings = (folder / "mkdocs.yml").read_text("utf-8")
    (folder / "mkdocs.yml").write_text(settings.replace("strict: true", "strict: false"), "utf-8")
    run(folder, "git", "init", "--quiet")
    run(folder, "git", "config", "user.name", "a")
    run(folder, "git", "config", "user.email", "a@localhost")
    run(folder, "git", "commit", "--quiet", "--allow-empty", "--message", "a release")
    for release in ("0.1", "0.2"):
        run(folder, "mike", "--quiet", "deploy", "--update-aliases", release, "latest")
    run(folder, "mike", "--quiet", "set-default", "latest")
    site = folder / "site"
    run(folder, "git", "clone", "--quiet", "--branch", "gh-pages", ".", str(site))
    return site


def _other_rules(folder: str, names: list[str]) -> set[str]:
    return {*names} - {f"{RULE}.md", "README.md"} if Path(folder).name == "rules" else set()


def test_each_release_has_its_pages(published: Path) -> None:
    versions = json.loads((published / "versions.json").read_text("utf-8"))
    assert [(each["version"], each["aliases"]) for each in versions] == [("0.2", ["latest"]), ("0.1", [])]
    for name in ("0.1", "0.2", "latest"):
        assert (published / name / "tutorial" / "index.html").is_file()
    assert "latest/" in (published / "index.html").read_text("utf-8")


def test_links_of_reports_lead_to_pages(published: Path) -> None:
    page = rule_page(RULE).removeprefix(HOME + "/")
    assert "JNT005" in (published / page / "index.html").read_text("utf-8")


def test_pages_have_the_selector(published: Path) -> None:
    page = (published / "0.1" / "index.html").read_text("utf-8")
    assert '"provider": "mike"' in page.replace('":"', '": "')
    assert f'href="{HOME}/latest/"' in page, "search engines find the newest"


def test_tables_keep_their_tabs(published: Path) -> None:
    page = (published / "0.1" / "vendor-tables" / "index.html").read_text("utf-8")
    assert "vendor\tFlatland\t" in page

"""The workflow runs what the project promises, with actions that cannot change under it."""

from __future__ import annotations

import re
from pathlib import Path
from typing import Any

import pytest
import yaml

from sdfcheck.release import __version__

ROOT = Path(__file__).parents[1]
TEXT = (ROOT / ".github" / "workflows" / "ci.yml").read_text("utf-8")
JOBS: dict[str, Any] = yaml.safe_load(TEXT)["jobs"]
STEPS = [step for job in JOBS.values() for step in job["steps"]]


def test_every_python_that_is_promised_is_tried_on_every_system() -> None:
    matrix = JOBS["test"]["strategy"]["matrix"]
    promised = re.findall(
        r'"Programming Language :: Python :: (3\.\d+)"', (ROOT / "pyproject.toml").read_text()
    )
    assert matrix["python"] == promised
    assert [name.partition("-")[0] for name in matrix["system"]] == ["ubuntu", "macos", "windows"]


def test_actions_are_pinned() -> None:
    for action in re.findall(r"uses: (.*)", TEXT):
        assert re.fullmatch(r"[\w-]+/[\w-]+@[0-9a-f]{40} # v\d+\.\d+\.\d+", action), action


def test_a_job_may_read_and_nothing_else() -> None:
    assert yaml.safe_load(TEXT)["permissions"] == {"contents": "read"}
    assert not any("permissions" in job for job in JOBS.values())
    checkouts = [step for step in STEPS if "checkout" in step.get("uses", "")]
    assert len(checkouts) == len(JOBS)
    assert all(step["with"] == {"persist-credentials": False} for step in checkouts)


def test_the_commands_that_run_exist() -> None:
    commands = "\n".join(step.get("run", "") for step in STEPS)
    targets = set(re.findall(r"make ([\w-]+)", commands))
    assert targets >= {"fuzz", "package"}
    makefile = (ROOT / "Makefile").read_text("utf-8")
    assert all(re.search(rf"^{target}:", makefile, re.MULTILINE) for target in targets)
    assert (ROOT / ".ci" / "run").exists()


def test_only_the_site_is_written_for_a_tag() -> None:
    text = (ROOT / ".github" / "workflows" / "site.yml").read_text("utf-8")
    workflow: dict[Any, Any] = yaml.safe_load(text)  # `on` is a truth of YAML
    assert workflow[True] == {"push": {"tags": ["v*"]}}
    assert workflow["permissions"] == {"contents": "read"}
    assert [job["permissions"] for job in workflow["jobs"].values()] == [{"contents": "write"}]
    assert set(re.findall(r"uses: (.*)", text)) <= set(re.findall(r"uses: (.*)", TEXT))
    assert re.search("^publish-site:", (ROOT / "Makefile").read_text("utf-8"), re.MULTILINE)


def test_a_tag_is_compared_with_what_is_there() -> None:
    assert f'__version__ = "{__version__}"' in (ROOT / "sdfcheck" / "release.py").read_text("utf-8")


@pytest.mark.parametrize("name", JOBS)
def test_no_text_of_others_gets_into_a_shell(name: str) -> None:
    known = {"matrix.platform", "github.run_number"}
    for step in JOBS[name]["steps"]:
        assert set(re.findall(r"\$\{\{ ([\w.]+) \}\}", step.get("run", ""))) <= known

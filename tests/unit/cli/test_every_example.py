"""Every rule's examples go through every command that takes such a file, and none of them meets a bug.

Commands for one file get every eighth of them, those for many every fourth, each others; with ``--all-examples``
they get all.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from pathlib import Path

import pytest

from sdfcheck.cli.main import main
from sdfcheck.lint.example import Bad, Good, fill, unmark
from sdfcheck.lint.rulebook.packs import load_index
from sdfcheck.lint.rulebook.trial import file_name

pytestmark = pytest.mark.slow

EACH_ALONE = (
    "graph frames",
    "graph poses",
    "graph joints",
    "inertia",
    "print --expand-includes",
    "targets",
    "view",
)
ALL_AT_ONCE = (
    "lint --jobs 1 --diff --unsafe-fixes",
    "lint --jobs 1 --output-format json={}/report.json --output-format html={}/report.html",
    "convert urdf-to-sdf --no-lint --output-dir {}",
    "convert sdf-to-urdf --output-dir {}",
    "convert sdf-to-urdf --no-lint --output-dir {}",
    "convert sdf-to-sdf --no-lint --sdf-version 1.4 --output-dir {}",
    "convert sdf-to-sdf --no-lint --sdf-version 1.12 --output-dir {}",
)

PARTS = 4


def examples() -> Iterator[tuple[str, str, dict[str, str]]]:
    """The file, the text and the other files of each example, each text once."""
    index = load_index()
    seen = set()
    for facts in index.facts:
        rule = index.rule(facts)
        own: tuple[Bad | Good, ...] = (*rule.bad, *rule.good)
        for example in own:
            text = unmark(fill(rule.scaffold, example))[0]
            if text not in seen:
                seen.add(text)
                yield file_name(text, example), text, dict(example.files or {})


@pytest.fixture(autouse=True)
def _accounts() -> None:
    """Faulty sources, which only ``--no-lint`` converts, may have items without an outcome: a loss, as users get it."""


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder for each example, among the other files that it names; every fourth of them is in one folder."""
    top = tmp_path_factory.mktemp("examples")
    for number, (name, text, others) in enumerate(examples()):
        own = top / str(number % PARTS) / f"{number:04}"
        (own / ".git").mkdir(parents=True)  # a project, to which nothing around it belongs
        for file, content in {**others, name: text}.items():
            path = own / file
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(content, encoding="utf-8")
    return top


def files(folder: Path, *suffixes: str) -> list[Path]:
    found = sorted(path for path in folder.rglob("*") if path.suffix in suffixes)
    assert found
    return found


@pytest.mark.parametrize("command", EACH_ALONE)
def test_commands_for_one_file(
    folder: Path, command: str, stride: Callable[[int], int], capsys: pytest.CaptureFixture[str]
) -> None:
    step = stride(8)
    for path in files(folder, ".sdf", ".urdf")[EACH_ALONE.index(command) % step :: step]:
        assert main([*command.split(), "--isolated", str(path)]) in {0, 1, 2}
        check(capsys, path)


def test_schemas(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    for path in files(folder, ".sdf")[::20]:
        main(["schema", "--for", str(path)])
        check(capsys, path)


def test_expansions(folder: Path, stride: Callable[[int], int], capsys: pytest.CaptureFixture[str]) -> None:
    for path in files(folder, ".xacro")[:: stride(8)]:
        main(["expand", "--isolated", str(path)])
        check(capsys, path)


@pytest.mark.parametrize("command", ALL_AT_ONCE)
def test_commands_for_many_files(
    folder: Path,
    tmp_path: Path,
    command: str,
    stride: Callable[[int], int],
    capsys: pytest.CaptureFixture[str],
) -> None:
    words = [word.format(tmp_path) for word in command.split()]
    part = folder / str(ALL_AT_ONCE.index(command) % PARTS) if stride(PARTS) > 1 else folder
    assert main([*words, "--isolated", str(part)]) in {0, 1, 2}
    check(capsys, command)


def check(capsys: pytest.CaptureFixture[str], what: object) -> None:
    captured = capsys.readouterr()
    assert "internal error" not in captured.err + captured.out, f"{what}: {captured.err}"

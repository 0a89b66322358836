"""The house style where a machine can see it: sizes, names, leftovers."""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[1]
CODE = ("sdfcheck", "rules", "tests", "benchmarks", "tables")
TEXTS = {
    ".py",
    ".md",
    ".toml",
    ".yaml",
    ".yml",
    ".txt",
    ".json",
    ".sdf",
    ".world",
    ".urdf",
    ".xacro",
    ".config",
}

FUNCTION_LINES = 40
RULE_LINES = 80

LONG_FUNCTIONS: dict[str, str] = {}
"""Path:name → why it may be longer."""
LONG_RULES: dict[str, str] = {}
"""Path → why it may be longer."""

VAGUE_MODULES = {"base", "common", "data", "helper", "helpers", "info", "manager", "misc", "util", "utils"}
VAGUE_CLASS = re.compile(r"(Manager|Helper|Util|Utils|Base|Info|Data)$")
LEFTOVER = re.compile(r"\b(TO" r"DO|FIX" r"ME|XX" r"X|HA" r"CK)\b")
OWN_COMPUTER = re.compile(r"(?<![\w.:/*<])/(?:work|root|tmp|opt|mnt|Users)/\w")


def modules() -> list[Path]:
    return sorted(path for folder in CODE for path in (ROOT / folder).rglob("*.py"))


def texts() -> Iterator[Path]:
    folders = (*CODE, "fixtures", "docs", ".ci")
    inside = (
        path for folder in folders for path in (ROOT / folder).rglob("*") if "__pycache__" not in path.parts
    )
    for path in sorted((*ROOT.iterdir(), *inside)):
        if path.is_file() and (path.suffix in TEXTS or path.name in {"Makefile", "run"}):
            yield path


def name(path: Path) -> str:
    return path.relative_to(ROOT).as_posix()


def lines(node: ast.stmt) -> int:
    return (node.end_lineno or node.lineno) - node.lineno + 1


def functions(path: Path) -> Iterator[ast.FunctionDef | ast.AsyncFunctionDef]:
    for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
        if isinstance(node, ast.FunctionDef | ast.AsyncFunctionDef):
            yield node


def rule_length(path: Path) -> int:
    """Lines of the classes of a rule's module, without their examples and the way to fix them."""
    length = 0
    for node in ast.parse(path.read_text(encoding="utf-8")).body:
        if isinstance(node, ast.ClassDef):
            length += lines(node) - sum(lines(part) for part in node.body if is_for_the_page(part))
    return length


def is_for_the_page(node: ast.stmt) -> bool:
    targets = (
        node.targets
        if isinstance(node, ast.Assign)
        else [node.target]
        if isinstance(node, ast.AnnAssign)
        else []
    )
    return any(isinstance(target, ast.Name) and target.id in {"bad", "good", "remedy"} for target in targets)


def check(found: dict[str, int], limit: int, exceptions: dict[str, str]) -> None:
    """Nothing is longer than the limit but the exceptions, and each exception is needed."""
    long = {key: length for key, length in found.items() if length > limit}
    too_long = {key: length for key, length in long.items() if key not in exceptions}
    assert not too_long
    assert set(exceptions) <= set(long), "exceptions that nothing needs any more"
    assert all(reason.strip() for reason in exceptions.values())


def test_functions_are_short() -> None:
    found = {f"{name(path)}:{node.name}": lines(node) for path in modules() for node in functions(path)}
    assert found
    check(found, FUNCTION_LINES, LONG_FUNCTIONS)


def test_rules_are_short() -> None:
    found = {name(path): rule_length(path) for path in modules() if path.is_relative_to(ROOT / "rules")}
    check(found, RULE_LINES, LONG_RULES)


def test_names_say_what_things_are() -> None:
    vague_modules = [name(path) for path in modules() if path.stem in VAGUE_MODULES]
    assert not vague_modules
    vague_classes = [
        f"{name(path)}:{node.name}"
        for path in modules()
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8")))
        if isinstance(node, ast.ClassDef) and VAGUE_CLASS.search(node.name)
    ]
    assert not vague_classes


ASKED_OF_A_PATH = re.compile(r"(?<!\bentry)\.(?:is_dir|is_file|exists)\(\)")


def test_the_disk_is_asked_by_functions_that_raise_nothing() -> None:
    """Those of ``Path`` raise for names that are too long and folders that are closed, before Python 3.14."""
    asked = [
        f"{name(path)}:{number}"
        for path in modules()
        if path.is_relative_to(ROOT / "sdfcheck") or path.is_relative_to(ROOT / "rules")
        for number, line in enumerate(path.read_text("utf-8").splitlines(), 1)
        if ASKED_OF_A_PATH.search(line)
    ]
    assert asked == []


def test_no_function_rebinds_a_module_name() -> None:
    rebinding = [
        f"{name(path)}:{node.lineno}"
        for path in modules()
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8")))
        if isinstance(node, ast.Global)
    ]
    assert not rebinding


@pytest.mark.parametrize(("pattern", "what"), [(LEFTOVER, "leftover"), (OWN_COMPUTER, "absolute path")])
def test_texts_hold_nothing_left_over(pattern: re.Pattern[str], what: str) -> None:
    found = [
        f"{name(path)}:{number}: {what}: {line.strip()[:80]}"
        for path in texts()
        for number, line in enumerate(path.read_text(encoding="utf-8", errors="replace").splitlines(), 1)
        if pattern.search(line)
    ]
    assert not found, "\n".join(found)


def test_examples_do_not_count_as_length(tmp_path: Path) -> None:
    module = tmp_path / "rule.py"
    module.write_text("class Rule:\n    bad = (\n        1,\n    )\n    good = ()\n    code = 'A'\n")
    assert rule_length(module) == 2

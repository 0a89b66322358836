"""Imports point one way, rules see only the public side of the engine, and the engine names no rule."""

from __future__ import annotations

import ast
import re
import sys
from collections.abc import Iterator
from functools import cache
from pathlib import Path
from typing import NamedTuple

import pytest

pytestmark = pytest.mark.xdist_group(__name__)

ROOT = Path(__file__).parents[1]
ENGINE = ROOT / "sdfcheck"
RULES = ROOT / "rules"

_FLOORS = (
    ("source",),
    ("files", "formats"),
    ("bodies", "xacro"),
    ("robot",),
    ("consumers",),
    ("convert", "lint"),
    ("view",),
    ("lsp", "report"),
    ("cli",),
)
"""The rooms from the ground up; a room imports what lies below it."""

BELOW = {
    **{
        room: {below for floor in _FLOORS[:level] for below in floor}
        for level, rooms in enumerate(_FLOORS)
        for room in rooms
    },
    "formats": {"source", "files"},
    "bodies": {"source", "files"},
    "convert": {"source", "files", "formats", "xacro", "robot", "consumers", "lint"},
}
"""Layer → the layers that it may import in addition to itself."""


MOST_MODULES = 300
"""So many modules the engine has; it may have fewer."""


class Import(NamedTuple):
    line: int
    module: str
    names: tuple[str, ...]


def modules(folder: Path) -> list[Path]:
    return sorted(folder.rglob("*.py"))


@cache
def imports(path: Path) -> tuple[Import, ...]:
    """Every import of a module, also those inside functions and for annotations only."""
    return tuple(_imports(path))


def _imports(path: Path) -> Iterator[Import]:
    for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
        if isinstance(node, ast.Import):
            for alias in node.names:
                yield Import(node.lineno, alias.name, ())
        elif isinstance(node, ast.ImportFrom):
            yield Import(node.lineno, node.module or "", tuple(alias.name for alias in node.names))


def name(path: Path) -> str:
    return path.relative_to(ROOT).as_posix()


def rule_marks() -> set[str]:
    """The codes and names of the built-in rules, as their modules spell them."""
    marks: set[str] = set()
    for path in modules(RULES):
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
            if isinstance(node, ast.Assign) and isinstance(node.value, ast.Constant):
                target = node.targets[0]
                if isinstance(target, ast.Name) and target.id in {"code", "name"}:
                    marks.add(str(node.value.value))
    return marks


def test_every_layer_is_known() -> None:
    found = {path.parent.name for path in ENGINE.glob("*/__init__.py")}
    assert found
    assert found <= set(BELOW)


@pytest.mark.parametrize("layer", BELOW)
def test_layers_import_only_what_lies_below(layer: str) -> None:
    wrong: list[str] = []
    for path in modules(ENGINE / layer):
        for line, module, _ in imports(path):
            package, _, rest = module.partition(".")
            imported = rest.partition(".")[0]
            if package == "sdfcheck_rules" or module == "":
                wrong.append(f"{name(path)}:{line} imports {module or 'relatively'}")
            elif package == "sdfcheck" and imported in BELOW:
                if imported not in {layer, *BELOW[layer]}:
                    wrong.append(f"{name(path)}:{line} imports {module}")
            elif module == "sdfcheck":
                wrong.append(f"{name(path)}:{line} imports the public API")
    assert not wrong, "\n".join(wrong)


def graph(package: Path) -> dict[str, set[str]]:
    """Each module of a package → those of its modules that it imports, wherever it does so, also for types."""
    paths = {dotted(path, package.parent): path for path in modules(package)}
    found: dict[str, set[str]] = {}
    for module, path in paths.items():
        found[module] = set()
        for _, imported, names in imports(path):
            inner = {f"{imported}.{each}" for each in names} & paths.keys()
            found[module] |= inner
            if imported in paths and (len(inner) < len(names) or not names):
                found[module].add(imported)
    return found


def dotted(path: Path, root: Path) -> str:
    return ".".join(path.relative_to(root).with_suffix("").parts).removesuffix(".__init__")


def circles(imported: dict[str, set[str]]) -> set[tuple[str, ...]]:
    """The groups of modules that import one another, directly or by way of others."""
    reached = {module: reachable(imported, module) for module in imported}
    return {
        tuple(sorted(other for other in others if module in reached[other]))
        for module, others in reached.items()
        if module in others
    }


def reachable(imported: dict[str, set[str]], start: str) -> set[str]:
    found: set[str] = set()
    waiting = [start]
    while waiting:
        new = imported[waiting.pop()] - found
        found |= new
        waiting += new
    return found


def test_no_modules_import_one_another() -> None:
    assert circles(graph(ENGINE)) == set(), "they are one module, or one of them knows too much"


def test_circles_are_found(tmp_path: Path) -> None:
    package = tmp_path / "package"
    package.mkdir()
    (package / "above.py").write_text("from package.below import f\n")
    (package / "below.py").write_text("def f():\n    import package.between\n")
    (package / "between.py").write_text("if TYPE_CHECKING:\n    from package import above\n")
    (package / "user.py").write_text("import package.above\n")
    assert circles(graph(package)) == {("package.above", "package.below", "package.between")}


def test_rules_import_the_public_api_and_their_family_only() -> None:
    wrong: list[str] = []
    for path in modules(RULES):
        folders = path.relative_to(RULES).parts[:-1]
        family = ".".join(("sdfcheck_rules", *folders[:1]))
        for line, module, _ in imports(path):
            package, _, rest = module.partition(".")
            public = package == "sdfcheck" and rest.partition(".")[0] not in BELOW
            own = bool(folders) and (module == family or module.startswith(f"{family}."))
            written = name(path) == "rules/conditions.py" and module == "sdfcheck.source.text"
            if not (public or own or written or package in sys.stdlib_module_names):
                wrong.append(f"{name(path)}:{line} imports {module or 'relatively'}")
    assert not wrong, "\n".join(wrong)


def test_the_engine_names_no_rule() -> None:
    marks = rule_marks()
    families = {mark.rstrip("0123456789") for mark in marks if mark[-3:].isdigit()}
    code = re.compile(rf"\b(?:{'|'.join(sorted(families)) or '(?!)'})\d{{3}}\b")
    wrong: list[str] = []
    for path in modules(ENGINE):
        text = path.read_text(encoding="utf-8")
        wrong += [f"{name(path)} names {found}" for found in sorted(set(code.findall(text)))]
        for node in ast.walk(ast.parse(text)):
            if isinstance(node, ast.Constant) and node.value in marks:
                wrong.append(f"{name(path)}:{node.lineno} names {node.value}")
    assert not wrong, "\n".join(wrong)


def test_imports_inside_functions_are_seen(tmp_path: Path) -> None:
    module = tmp_path / "late.py"
    module.write_text("def f() -> None:\n    from sdfcheck.cli import main\n    import numpy.linalg\n")
    assert imports(module) == (Import(2, "sdfcheck.cli", ("main",)), Import(3, "numpy.linalg", ()))


def test_the_engine_does_not_fall_into_more_pieces() -> None:
    assert len(modules(ENGINE)) <= MOST_MODULES

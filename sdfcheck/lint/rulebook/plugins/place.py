"""Where something of a pack is written: file and line of a class, of its examples, of a failure."""

from __future__ import annotations

import ast
import os
import sys
from collections.abc import Iterator
from pathlib import Path
from types import TracebackType

from sdfcheck.lint.run import RuleFacts
from sdfcheck.source.relative import shown
from sdfcheck.source.wrong_usage import REPORT_IT

_LONGEST = 200
"""More of an error's text does not help on one line."""


class Misbehavior(Exception):
    """A rule does what rules must not do: where, and in words for its author."""

    def __init__(self, place: str, text: str) -> None:
        super().__init__(text)
        self.place = place


def described(error: BaseException) -> str:
    """An error on one line, whatever it is."""
    try:
        text = error.msg if isinstance(error, SyntaxError) else str(error)
    except Exception:
        text = ""
    text = " ".join(text.split())
    text = text if len(text) <= _LONGEST else f"{text[:_LONGEST]}…"
    if isinstance(error, Misbehavior):
        return text
    return f"{type(error).__name__}: {text}" if text else type(error).__name__


def at(path: Path | str, line: int) -> str:
    """A place as people and terminals understand it."""
    return f"{shown(Path(path))}:{line}"


def failure(facts: RuleFacts, error: BaseException) -> tuple[str, str]:
    """The failure of a rule, its place, and the way to fix it."""
    place = error.place if isinstance(error, Misbehavior) else place_of_error(error, facts.module)
    where = f" at {place}" if place else ""
    message = f"rule {facts.code} {facts.name} failed{where}: {described(error)}"
    if facts.is_built_in:
        return message, REPORT_IT
    return message, f'correct the rule, or leave it out with `ignore = ["{facts.name}"]`'


def place_of_error(error: BaseException, module: str, *folders: Path) -> str | None:
    """The innermost place within the package of a module, or within folders, at which an error came up."""
    roots = (*_roots(module), *(f"{folder}{os.sep}" for folder in folders))
    if isinstance(error, SyntaxError) and str(error.filename).startswith(roots):
        return at(str(error.filename), error.lineno or 1)
    places = [(file, line) for file, line in _frames(error.__traceback__) if file.startswith(roots)]
    return at(*places[-1]) if places else None


def place_of_check(rule: type) -> str:
    """Where the ``check`` of a rule begins; the class, if it is not a plain function."""
    code = getattr(getattr(rule, "check", None), "__code__", None)
    return at(code.co_filename, code.co_firstlineno) if code else place_of_class(rule)


def place_of_class(rule: type, attribute: str = "") -> str:
    """Where a class assigns an attribute; the class itself, if it does not."""
    node = _class(rule)
    line = 1 if node is None else node.lineno
    value = None if node is None else _assigned(node, attribute)
    return at(_file(rule), line if value is None else value.lineno)


def places_of_examples(rule: type, attribute: str, count: int) -> list[str]:
    """Where the examples in ``bad`` or ``good`` are, one by one as far as they are written so."""
    owner = next(base for base in rule.__mro__ if attribute in vars(base))
    node = _class(owner)
    value = None if node is None else _assigned(node, attribute)
    if isinstance(value, ast.Tuple | ast.List) and len(value.elts) == count:
        return [at(_file(owner), item.lineno) for item in value.elts]
    return [place_of_class(owner, attribute)] * count


def _roots(module: str) -> tuple[str, ...]:
    top = sys.modules.get(module.partition(".")[0])
    folders = tuple(f"{folder}{os.sep}" for folder in getattr(top, "__path__", ()))
    file = getattr(top, "__file__", None)
    return (*folders, file) if file else folders or ("\0",)


def _frames(trace: TracebackType | None) -> Iterator[tuple[str, int]]:
    while trace is not None:
        yield trace.tb_frame.f_code.co_filename, trace.tb_lineno
        trace = trace.tb_next


def _file(rule: type) -> str:
    return getattr(sys.modules.get(rule.__module__), "__file__", None) or rule.__module__


def _class(rule: type) -> ast.ClassDef | None:
    classes = [node for node in ast.walk(_tree(_file(rule))) if isinstance(node, ast.ClassDef)]
    return next((node for node in classes if node.name == rule.__name__), None)


def _tree(file: str) -> ast.Module:
    try:
        return ast.parse(Path(file).read_bytes())
    except (OSError, SyntaxError, ValueError):
        return ast.Module([], [])


def _assigned(node: ast.ClassDef, attribute: str) -> ast.expr | None:
    """The value that the body of a class gives an attribute."""
    for part in reversed(node.body):
        targets = part.targets if isinstance(part, ast.Assign) else [getattr(part, "target", None)]
        if any(isinstance(target, ast.Name) and target.id == attribute for target in targets):
            return getattr(part, "value", None)
    return None

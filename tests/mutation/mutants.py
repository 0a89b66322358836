"""The small changes that are made to the code: one each, at one place."""

from __future__ import annotations

import ast
from collections import Counter
from collections.abc import Iterator
from itertools import islice
from pathlib import Path
from typing import NamedTuple

_SWAPS: dict[type[ast.AST], type[ast.AST]] = {
    ast.Lt: ast.LtE,
    ast.LtE: ast.Lt,
    ast.Gt: ast.GtE,
    ast.GtE: ast.Gt,
    ast.Eq: ast.NotEq,
    ast.NotEq: ast.Eq,
    ast.Is: ast.IsNot,
    ast.IsNot: ast.Is,
    ast.In: ast.NotIn,
    ast.NotIn: ast.In,
    ast.And: ast.Or,
    ast.Or: ast.And,
    ast.Add: ast.Sub,
    ast.Sub: ast.Add,
    ast.Mult: ast.Div,
    ast.Div: ast.Mult,
    ast.Break: ast.Continue,
    ast.Continue: ast.Break,
}
Place = tuple[ast.expr | ast.stmt, str, int | None, ast.AST]
"""A node, the field that changes (empty: the node itself), the index in the field, and what comes there."""

_UNTOUCHED = {"__repr__", "__reduce__", "applies"}
"""Functions that nothing depends on; and conditions of rules, of which copies run."""


class Mutant(NamedTuple):
    """A changed module: its file, the line of the change, what it was and became, the whole text, and the function.

    A line that is in its function several times has its number there, from the second on: ``f 2``.
    """

    path: Path
    line: int
    before: str
    after: str
    text: str
    function: str

    @property
    def key(self) -> str:
        """How it is known wherever it is in the file."""
        return f"{self.path.as_posix()}: {self.before} → {self.after}"

    @property
    def own_key(self) -> str:
        """The same for it alone, where the same line is in other places, too."""
        return f"{self.path.as_posix()} in {self.function}: {self.before} → {self.after}"


def marks(text: str) -> list[str]:
    """The mutants of a module in their order, each by a mark that changes elsewhere leave as it is."""
    seen: Counter[str] = Counter()
    found = []
    for node, field, index, new in _places(ast.parse(text)):
        mark = f"{ast.dump(node)} {field} {index} {ast.dump(new)}"
        seen[mark] += 1
        found.append(f"{mark} {seen[mark]}")
    return found


def make(path: Path, text: str, number: int) -> Mutant:
    """One of the mutants of a module, by its number."""
    tree = ast.parse(text)
    before = ast.unparse(tree).splitlines()
    node, field, index, new = next(islice(_places(tree), number, None))
    if field and index is None:
        setattr(node, field, new)
    elif field:
        getattr(node, field)[index] = new
    else:
        _replace(tree, node, new)
    changed = ast.unparse(ast.fix_missing_locations(tree))
    after = changed.splitlines()
    at = next(i for i, (a, b) in enumerate(zip(before, after, strict=False)) if a != b)
    function = _function("\n".join(before), before, at)
    return Mutant(path, node.lineno, before[at].strip(), after[at].strip(), changed, function)


def _function(text: str, lines: list[str], at: int) -> str:
    """The innermost function around a line, and which of its lines that say the same it is."""
    around = [
        node
        for node in ast.walk(ast.parse(text))
        if isinstance(node, ast.FunctionDef | ast.AsyncFunctionDef | ast.ClassDef)
        and node.lineno <= at + 1 <= (node.end_lineno or 0)
    ]
    name = ".".join(node.name for node in sorted(around, key=lambda node: node.lineno))
    first = max(node.lineno for node in around) - 1
    number = sum(line.strip() == lines[at].strip() for line in lines[first : at + 1])
    return name if number == 1 else f"{name} {number}"


def _places(tree: ast.Module) -> Iterator[Place]:
    for node in _inside(tree):
        yield from ((node, *change) for change in _changes(node))


def _inside(tree: ast.Module) -> Iterator[ast.expr | ast.stmt]:
    """The nodes in functions that may be changed: no annotations, no docstrings."""
    waiting: list[tuple[ast.AST, bool]] = [(tree, False)]
    while waiting:
        node, is_inside = waiting.pop()
        if isinstance(node, ast.FunctionDef | ast.AsyncFunctionDef):
            if node.name in _UNTOUCHED:
                continue
            waiting += [(child, True) for child in reversed(node.body[_has_docstring(node) :])]
            waiting += [(child, True) for child in node.args.defaults]
            continue
        if is_inside and isinstance(node, ast.expr | ast.stmt):
            yield node
        if isinstance(node, ast.AnnAssign):
            waiting += [(node.value, is_inside)] if node.value is not None else []
        elif isinstance(node, ast.Call) and getattr(node.func, "id", "") in {"cast", "TypeVar"}:
            waiting += [(child, is_inside) for child in node.args[1:]]
        elif not isinstance(node, ast.JoinedStr | ast.Import | ast.ImportFrom | ast.Assert):
            waiting += [(child, is_inside) for child in reversed(list(ast.iter_child_nodes(node)))]


def _has_docstring(node: ast.FunctionDef | ast.AsyncFunctionDef) -> bool:
    return ast.get_docstring(node, clean=False) is not None


def _changes(node: ast.expr | ast.stmt) -> Iterator[tuple[str, int | None, ast.AST]]:
    """Field, index in it, and what comes there; a field of ``""`` is the node itself."""
    match node:
        case ast.Compare(ops=ops):
            yield from (("ops", number, _SWAPS[type(op)]()) for number, op in enumerate(ops))
        case ast.BoolOp(op=op) | ast.BinOp(op=op) | ast.AugAssign(op=op) if type(op) in _SWAPS:
            yield "op", None, _SWAPS[type(op)]()
        case ast.UnaryOp(op=ast.Not(), operand=operand):
            yield "", None, operand
        case ast.If(test=test) | ast.IfExp(test=test) if not isinstance(test, ast.Compare | ast.UnaryOp):
            yield "test", None, ast.UnaryOp(ast.Not(), test)
        case ast.Constant(value=value):
            yield from (("", None, ast.Constant(other)) for other in _other(value))
        case ast.Return(value=ast.expr() as value) if not isinstance(value, ast.Constant):
            yield "value", None, ast.Constant(None)
        case ast.Expr(value=ast.Call() | ast.Yield() | ast.YieldFrom()) | ast.Raise():
            yield "", None, ast.Pass()
        case ast.Break() | ast.Continue():
            yield "", None, _SWAPS[type(node)]()
    if isinstance(node, ast.AugAssign):
        yield "", None, ast.Pass()


def _other(value: object) -> Iterator[str | float]:
    if isinstance(value, bool):
        yield not value
    elif isinstance(value, int | float):
        yield value + 1
    elif isinstance(value, str) and value and " " not in value:
        yield f"{value}x"


def _replace(tree: ast.Module, node: ast.AST, new: ast.AST) -> None:
    for holder in ast.walk(tree):
        for name, value in ast.iter_fields(holder):
            if value is node:
                setattr(holder, name, new)
            elif isinstance(value, list):
                value[:] = [new if each is node else each for each in value]

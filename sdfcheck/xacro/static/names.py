"""The names that an expression needs from outside."""

from __future__ import annotations

import ast
from functools import lru_cache

from sdfcheck.xacro.language import replaced


@lru_cache(maxsize=4096)
def free_names(code: str) -> frozenset[str]:
    """The names that a piece of code reads and does not bind itself; none if it is not Python."""
    try:
        tree = ast.parse(replaced(code, lambda _: "0").strip(), mode="eval")
    except (SyntaxError, ValueError, RecursionError, MemoryError):
        return frozenset()
    read: set[str] = set()
    bound: set[str] = set()
    for node in ast.walk(tree):
        if isinstance(node, ast.Name):
            (read if isinstance(node.ctx, ast.Load) else bound).add(node.id)
        elif isinstance(node, ast.arg):
            bound.add(node.arg)
    return frozenset(read - bound)

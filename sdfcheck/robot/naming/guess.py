"""The name that was probably meant by one that is not defined."""

from __future__ import annotations

from collections import defaultdict
from typing import TYPE_CHECKING

from sdfcheck.source.record import NamedTuple

if TYPE_CHECKING:
    from sdfcheck.robot.node import Node
    from sdfcheck.robot.scope import Scope
    from sdfcheck.source.document import Document
    from sdfcheck.source.element import Element


class Guess(NamedTuple):
    """``meant``: a near miss, or the scoped name of what exists in a nested model.

    ``outside``: what an enclosing world or model has by that name, where no reference from
    here can reach it.
    """

    meant: str | None = None
    outside: Element | None = None


class _Reachable:
    """The names that each scope of a document can use, by their last parts."""

    __slots__ = ("_by_scope",)

    def __init__(self, document: Document) -> None:
        self._by_scope: dict[Scope, dict[str, list[str]]] = {}

    def names(self, scope: Scope) -> dict[str, list[str]]:
        if scope not in self._by_scope:
            reachable: defaultdict[str, list[str]] = defaultdict(list)
            for name in scope.names():
                reachable[_last(name)].append(name)
            self._by_scope[scope] = reachable
        return self._by_scope[scope]


def guess(scope: Scope, name: str, but: tuple[str, ...] = (), kind: str = "") -> Guess:
    """The intended name of a reference in a scope: none of ``but``, and of ``kind`` if one is given."""

    def fits(candidate: str) -> bool:
        if candidate in but:
            return False
        return not kind or ((node := scope.resolve(candidate)) is not None and node.kind == kind)

    document = scope.root.document
    reachable = document.view(_Reachable).names(scope)
    deeper = [n for n in reachable.get(_last(name), ()) if n.endswith(f"::{name}") and fits(n)]
    if len(deeper) == 1:
        return Guess(deeper[0])
    if (outside := _outside(scope, name)) is not None:
        return Guess(None, outside.place)
    from sdfcheck.formats.near_names import nearest

    candidates = (n for names in reachable.values() for n in names if fits(n))
    return Guess(nearest(name, candidates, document))


def _last(name: str) -> str:
    return name.rpartition("::")[2]


def _outside(scope: Scope, name: str) -> Node | None:
    at = scope.scope_around
    while at is not None:
        if (found := at.resolve(name)) is not None:
            return found
        at = at.scope_around
    return None

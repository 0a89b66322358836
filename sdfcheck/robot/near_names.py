"""What a name that reaches nothing was probably meant to be."""

from __future__ import annotations

from collections import defaultdict

from sdfcheck.robot.scopes import Frame, Scope
from sdfcheck.source.document import Document
from sdfcheck.source.element import Element
from sdfcheck.source.record import NamedTuple


class Guess(NamedTuple):
    """``meant``: a near miss, or the scoped name of what exists in a nested model.

    ``outside``: what an enclosing scope has by that name, out of reach.
    """

    meant: str | None = None
    outside: Element | None = None


class NearNames:
    """Guesses for one document."""

    __slots__ = ("_document", "_reachable")

    def __init__(self, document: Document) -> None:
        self._reachable: dict[Scope, dict[str, list[str]]] = {}
        self._document = document

    def guess(self, scope: Scope, name: str, but: tuple[str, ...] = (), kind: str = "") -> Guess:
        """What a reference in a scope was meant to be: none of ``but``, and of ``kind`` if one is given."""

        def fits(candidate: str) -> bool:
            if candidate in but:
                return False
            return not kind or ((frame := scope.find(candidate)) is not None and frame.kind == kind)

        reachable = self._names(scope)
        deeper = [n for n in reachable.get(_last(name), ()) if n.endswith(f"::{name}") and fits(n)]
        if len(deeper) == 1:
            return Guess(deeper[0])
        if (outside := _outside(scope, name)) is not None:
            return Guess(None, outside.element)
        from sdfcheck.formats.suggest import suggest_in

        candidates = (n for names in reachable.values() for n in names if fits(n))
        return Guess(suggest_in(self._document, name, candidates))

    def _names(self, scope: Scope) -> dict[str, list[str]]:
        """The names that a scope can use, by their last parts."""
        if scope not in self._reachable:
            reachable: defaultdict[str, list[str]] = defaultdict(list)
            for name in scope.names():
                reachable[_last(name)].append(name)
            self._reachable[scope] = reachable
        return self._reachable[scope]


def near_names(document: Document) -> NearNames:
    return document.view(NearNames)


def _last(name: str) -> str:
    return name.rpartition("::")[2]


def _outside(scope: Scope, name: str) -> Frame | None:
    at = scope.parent
    while at is not None:
        if (found := at.find(name)) is not None:
            return found
        at = at.parent
    return None

"""The children of nodes while xacro replaces one after the other. Runs in the process that expands."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, MutableSequence
from itertools import chain
from typing import Any, SupportsIndex
from xml.dom.minicompat import NodeList

MANY = 2048
"""With so many children a node is read into :class:`ManyChildren`."""
_WINDOW = 32


class Children(NodeList[Any]):
    """The children of a node; one is looked for where the last one was found.

    xacro replaces the nodes of a file one after the other, and would go through all before each.
    """

    __slots__ = ("_near",)

    def index(self, node: Any, *between: SupportsIndex) -> int:
        near = getattr(self, "_near", 0)
        try:
            found = super().index(node, *(between or (max(0, near - _WINDOW), near + _WINDOW)))
        except ValueError:
            found = super().index(node, *between)
        self._near = found
        return found

    def remove(self, node: Any) -> None:
        del self[self.index(node)]


class ManyChildren(MutableSequence[Any]):
    """Children in two lists, those before the last change and, turned around, those after it.

    A change next to the last one moves none of the others.
    """

    __slots__ = ("_after", "_before")

    def __init__(self, nodes: Iterable[Any]) -> None:
        self._before: list[Any] = []
        self._after = [*nodes][::-1]

    def __len__(self) -> int:
        return len(self._before) + len(self._after)

    def __iter__(self) -> Iterator[Any]:
        return chain([*self._before], self._after[::-1])

    def __getitem__(self, at: Any) -> Any:
        if isinstance(at, slice):
            return [*self][at]
        number = range(len(self))[at]
        inside = number - len(self._before)
        return self._before[number] if inside < 0 else self._after[-1 - inside]

    def __setitem__(self, at: Any, node: Any) -> None:
        if isinstance(at, slice):
            nodes = [*self]
            nodes[at] = node
            self._before, self._after = [], nodes[::-1]
        else:
            self._go_to(range(len(self))[at])
            self._after[-1] = node

    def __delitem__(self, at: Any) -> None:
        if isinstance(at, slice):
            self[at] = ()
        else:
            self._go_to(range(len(self))[at])
            self._after.pop()

    def insert(self, index: int, value: Any) -> None:
        self._go_to(min(index, len(self)))
        self._before.append(value)

    def index(self, value: Any, start: int = 0, stop: int | None = None) -> int:
        middle = len(self._before)
        for number in range(max(start, middle - _WINDOW), min(middle + _WINDOW, len(self))):
            if self[number] is value:
                return number
        return [*self].index(value, start, len(self) if stop is None else stop)

    def _go_to(self, number: int) -> None:
        """Let the two lists meet before the child of that number."""
        while len(self._before) > number:
            self._after.append(self._before.pop())
        while len(self._before) < number:
            self._before.append(self._after.pop())

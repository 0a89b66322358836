"""An included model as the parameters of its include change it: what is gone, new, replaced, renamed.

The included document itself never changes: another include may bring it as it is.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from itertools import islice

from sdfcheck.robot.includes.included import Included, included
from sdfcheck.source.element import Element
from sdfcheck.source.record import NamedTuple

Child = tuple[str, str, Element]
"""Kind, name and element of a named child."""

_MOST_IDS = 2000
_MOST_VISITS = 20_000
"""So many elements are looked into for one include: models in models can multiply without end."""
_DEEPEST = 20
"""So many models in models are looked into, which ends where a model includes itself."""


class Node(NamedTuple):
    """An element of the included model; ``via`` is the innermost include that brought it."""

    element: Element
    via: Element


class Alterations:
    """The changes of one include, in the order in which they are made."""

    __slots__ = ("_effort", "added", "complete", "removed", "renamed", "replaced", "root")

    def __init__(self, found: Included) -> None:
        self.root = Node(found.model, found.include) if found.model is not None else None
        self.added: dict[Node, list[Element]] = {}
        self.removed: set[Node] = set()
        self.replaced: dict[Node, Element] = {}
        self.renamed: dict[Node, str] = {}
        self.complete = self.root is not None and self.root.element.name != "robot"
        """False where not all of the model is known: a URDF is converted, an include may be missing."""
        self._effort = _MOST_VISITS

    def named(self, element: Element, via: Element, children: Iterable[Child]) -> Iterator[Child]:
        """The named children of an element after the changes; ``children`` are those before."""
        # A model that a parameter adds is where no walk goes.
        for kind, name, child in children or _named_children(element):
            node = Node(child, via)
            if node in self.removed:
                continue
            if (new := self.replaced.get(node)) is not None:
                yield new.name, new.attributes.get("name", ""), new
            else:
                yield kind, self.renamed.get(node, name), child
        for entry in self.added.get(Node(element, via), ()):
            yield entry.name, entry.attributes.get("name", ""), entry

    def children(self, node: Node, depth: int = 0) -> Iterator[tuple[str, str, Node]]:
        """Kind, name and node of what an element holds after the changes, included models as well."""
        element, via = node
        self._effort -= 1
        if self._effort < 0:
            self.complete = False
            return
        for kind, name, child in self.named(element, via, ()):
            if name:
                yield kind, name, Node(child, via)
        for include in element.children("include"):
            found = included(element.document, include)
            if found.model is None:
                self.complete = False
            elif found.merge:
                if depth < _DEEPEST:
                    yield from self.children(Node(found.model, include), depth + 1)
            elif found.name is not None:
                yield found.kind or "model", found.name, Node(found.model, include)

    def find(self, element_id: str, kind: str | None, start: Node | None = None) -> Node | None:
        """The element that an ``element_id`` names; the longest name that fits its beginning goes first."""
        start = start or self.root
        if start is None or element_id.count("::") > _DEEPEST:
            return None
        fitting = [
            (found, name, node)
            for found, name, node in self.children(start)
            if element_id == name or element_id.startswith(f"{name}::")
        ]
        fitting.sort(key=lambda entry: -len(entry[1]))
        for found, name, node in fitting:
            if element_id != name:
                deeper = self.find(element_id[len(name) + 2 :], kind, node)
                if deeper is not None:
                    return deeper
            elif kind is None or found == kind:
                return node
        return None

    def ids(self, kind: str | None) -> list[str]:
        """Every ``element_id`` that names an element, or one of a kind; not all of very many."""
        return list(islice(self._ids(kind, self.root), _MOST_IDS))

    def parts(self, node: Node, name: str) -> list[Node]:
        """The child elements of one name after the changes."""
        found = []
        for child in node.element.children(name):
            part = Node(child, node.via)
            if part not in self.removed:
                found.append(Node(self.replaced.get(part, child), node.via))
        found += [Node(entry, node.via) for entry in self.added.get(node, ()) if entry.name == name]
        return found

    def _ids(self, kind: str | None, node: Node | None, depth: int = 0) -> Iterator[str]:
        for found, name, child in self.children(node) if node is not None else ():
            if kind is None or found == kind:
                yield name
            if depth < _DEEPEST:
                yield from (f"{name}::{deeper}" for deeper in self._ids(kind, child, depth + 1))


def _named_children(element: Element) -> Iterator[Child]:
    for child in element.children():
        name = child.attributes.get("name")
        if name is not None:
            yield child.name, name, child

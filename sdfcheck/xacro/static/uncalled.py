"""What of a xacro file no expansion shows."""

from __future__ import annotations

from collections.abc import Iterator

from sdfcheck.source.document import Document
from sdfcheck.source.element import Element
from sdfcheck.xacro.static.definitions import Definitions, visible_definitions
from sdfcheck.xacro.static.reading import reading


def unexpanded(document: Document, *, is_expanded: bool) -> Iterator[Element]:
    """The macros of a document that nothing calls; without an expansion all of them, and the root."""
    if document.root is None:
        return
    if not is_expanded:
        yield document.root
    called = _called(visible_definitions(document)) if is_expanded else frozenset()
    for macro in reading(document).macros:
        if macro.name not in called:
            yield macro.element


def _called(visible: Definitions) -> frozenset[str]:
    """The names of the macros that are called from outside of macros, or from one that is called."""
    waiting = [
        call.name
        for read in visible.readings
        for call in read.calls
        if all(above.name != "xacro:macro" for above in _above(call.element))
    ]
    called: set[str] = set()
    while waiting:
        name = waiting.pop().rpartition(".")[2]
        if name not in called:
            called.add(name)
            waiting += [inner for macro in visible.macros.get(name, ()) for inner in macro.calls]
    return frozenset(called)


def _above(element: Element) -> Iterator[Element]:
    parent = element.parent
    while parent is not None:
        yield parent
        parent = parent.parent

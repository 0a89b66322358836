"""The parts of a xacro file that no expansion shows."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from sdfcheck.source.document import Document, Element
from sdfcheck.xacro.language import PREFIX
from sdfcheck.xacro.origins import ExpandedDocument
from sdfcheck.xacro.static.definitions import Definitions, reading, visible_definitions

_BRANCHES = frozenset({"xacro:if", "xacro:unless"})


def unexpanded(document: Document, expansions: Sequence[ExpandedDocument]) -> Iterator[Element]:
    """The macros of a document that nothing calls, and the branches that no expansion takes.

    Without an expansion all macros, and the root.
    """
    if document.root is None:
        return
    if not expansions:
        yield document.root
    called = _called(visible_definitions(document)) if expansions else frozenset()
    uncalled = [macro.element for macro in reading(document).macros if macro.name not in called]
    yield from uncalled
    if expansions:
        yield from _not_taken(document, expansions, {*uncalled})


def _not_taken(
    document: Document, expansions: Sequence[ExpandedDocument], done: set[Element]
) -> Iterator[Element]:
    """The branches of which nothing is in an expansion, outside of the elements that are ``done``."""
    branches = [element for element, _ in reading(document).elements if element.name in _BRANCHES]
    if not branches:
        return
    shown = set().union(*(expansion.provenance.offsets_in(document.path) for expansion in expansions))
    for branch in branches:
        if done.isdisjoint(branch.around):
            starts = {content.span.start - 1 for content in _content(branch)}
            if starts and shown.isdisjoint(starts):
                done.add(branch)
                yield branch


def _content(branch: Element) -> Iterator[Element]:
    """The elements that a branch puts into the robot itself."""
    for child in branch.children():
        if not child.name.startswith(PREFIX):
            yield child
        if child.name not in {"xacro:macro", "xacro:property"}:
            yield from _content(child)


def _called(visible: Definitions) -> frozenset[str]:
    """The names of the macros that are called from outside of macros, or from one that is called."""
    waiting = [
        call.name
        for read in visible.readings
        for call in read.calls
        if all(each.name != "xacro:macro" for each in call.element.around)
    ]
    called: set[str] = set()
    while waiting:
        name = waiting.pop().rpartition(".")[2]
        if name not in called:
            called.add(name)
            waiting += [inner for macro in visible.macros.get(name, ()) for inner in macro.calls]
    return frozenset(called)

"""Elements of xacro and calls of macros that lack the prefix ``xacro:``."""

from __future__ import annotations

from collections.abc import Callable, Sequence

from sdfcheck.formats import history
from sdfcheck.formats.urdf import schema as table
from sdfcheck.source.document import Document, Element
from sdfcheck.xacro.problems import MissingXacroPrefix
from sdfcheck.xacro.static.definitions import (
    Definitions,
    is_free,
    is_in_include,
    lacks_prefix,
    visible_definitions,
)

_KNOWN: dict[str, Callable[[str], Sequence[str]]] = {
    "robot": table.known_parents,
    "sdf": history.known_parents,
}
"""Name of the root → the elements that may hold one of a name."""


def missing_prefixes(document: Document) -> list[MissingXacroPrefix]:
    """One problem for each name of the elements that lack the prefix."""
    return document.view(_missing)


def _missing(document: Document) -> list[MissingXacroPrefix]:
    problems: list[MissingXacroPrefix] = []
    visible = visible_definitions(document)
    found: dict[str, list[Element]] = {}
    for element in document.elements[1:]:
        if (lacks_prefix(element) or is_plain_call(element, visible)) and not is_in_include(element):
            found.setdefault(element.name, []).append(element)
    for name, alike in found.items():
        first, *others = (element.span for element in alike)
        ends = (document.spans.end_name(element) for element in alike)
        places = (first, *others, *(end for end in ends if end is not None))
        problems.append(MissingXacroPrefix(first, name, tuple(others), places))
    return problems


def is_plain_call(element: Element, visible: Definitions) -> bool:
    """Is an element that its format does not know the call of a macro but for the prefix?"""
    name = element.name
    if name not in visible.macros or is_free(element):
        return False
    root = element.document.root
    knows = _KNOWN.get(root.name) if root is not None else None
    if knows is None or knows(name):
        return False
    given = element.attributes.keys()
    for macro in visible.macros[name]:
        taken = [each for each in macro.parameters if not each.is_block]
        needed = {each.name for each in taken if each.default is None and not each.forwards}
        if needed <= given <= {each.name for each in taken}:
            return True
    return False

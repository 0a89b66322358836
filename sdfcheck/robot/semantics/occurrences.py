"""The names in SRDF: its own, and those of the links and joints of the robot that it is about."""

from __future__ import annotations

from collections.abc import Iterator

from sdfcheck.formats.srdf import references
from sdfcheck.robot.naming.occurrences import Occurrence, Symbol, steps
from sdfcheck.robot.semantics.semantics import Semantics
from sdfcheck.source.document import Element
from sdfcheck.source.text import is_expression


def own_kind(element: Element) -> str:
    """The kind of thing to which an element of SRDF gives its name; empty where it names what is elsewhere.

    A virtual joint is a joint. States of two groups may have one name, so that their kinds differ.
    """
    if element.name == "group_state":
        return f"state of {element.attributes.get('group', '').strip() or 'no group'}"
    is_group = element.name == "group" and (element.parent is None or element.parent.name != "group")
    return _KINDS.get(element.name, "") if is_group or element.name != "group" else ""


_KINDS = {"group": "group", "virtual_joint": "joint", "end_effector": "end effector"}


def semantic_names(semantics: Semantics) -> Iterator[Occurrence]:
    """Every place that names something, also in elements of others; the parts of the robot have no definition."""
    known: dict[tuple[str, str], Symbol] = {}
    for element in semantics.element.children():
        value, kind = element.attribute("name"), own_kind(element)
        if kind and value is not None and value.text.strip():
            span, name = steps(value)[0][0], value.text.strip()
            yield Occurrence(span, known.setdefault((kind, name), Symbol(kind, name, span)), True)
    named = references()
    for element in semantics.document.elements:
        for attribute in element.attributes:
            kind, value = named.get((element.name, attribute), ""), element.attribute(attribute)
            if not kind or value is None or (attribute == "name" and own_kind(element)):
                continue
            span, name = steps(value)[0][0], value.text.strip()
            symbol = known.get((kind, name))
            if symbol is not None or (kind != "group" and name and not is_expression(name)):
                yield Occurrence(span, symbol or Symbol(kind, name, span))

"""The names in SRDF: its own, of groups, and those of the links and joints of the robot that it is about."""

from __future__ import annotations

from collections.abc import Iterator

from sdfcheck.robot.naming.occurrences import Occurrence, Symbol, steps
from sdfcheck.robot.semantics.semantics import Semantics


def semantic_names(semantics: Semantics) -> Iterator[Occurrence]:
    """Every place that names a group, or a link or joint; those of the robot are symbols without a definition."""
    for name, group in semantics.groups.items():
        value = group.attribute("name")
        assert value is not None
        span = steps(value)[0][0]
        yield Occurrence(span, Symbol("group", name, span), True)
    definitions = {name: group.attribute("name") for name, group in semantics.groups.items()}
    for kind, value in semantics.references:
        defined = definitions.get(value.text.strip()) if kind == "group" else None
        if defined is not None:
            symbol = Symbol("group", value.text.strip(), steps(defined)[0][0])
            yield Occurrence(steps(value)[0][0], symbol)
    for kind, value in semantics.named:
        span = steps(value)[0][0]
        yield Occurrence(span, Symbol(kind, value.text.strip(), span))

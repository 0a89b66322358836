"""Where the values in an expression come from: properties, parameters and arguments."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence

from sdfcheck.source.document import Document
from sdfcheck.source.record import NamedTuple
from sdfcheck.source.scanner.parse_tag import parse_start_tag
from sdfcheck.source.text import Span, Step
from sdfcheck.xacro.language import BUILT_IN, expressions, substitutions
from sdfcheck.xacro.static.definitions import Definitions, Macro, free_names, visible_definitions
from sdfcheck.xacro.static.likely_mistakes import parameter_place

# Where the values in an expression come from: properties, parameters and arguments, with their places.


MOST = 3
"""So many are named."""

_CALL = re.compile(r"in macro `([^`]+)`")
_ARGUMENT = re.compile(r"arg\s+(\S+)\s*$")


class Giver(NamedTuple):
    """The text that gives a name its value, and its place."""

    name: str
    text: str
    span: Span


def givers(span: Span, origins: Sequence[Step], document: Document) -> list[Giver]:
    """The texts that give their values to the names at a place, and to the names in these values."""
    visible = visible_definitions(document)
    found: list[Giver] = []
    waiting = [(span.text, tuple(origins))]
    while waiting and len(found) < MOST:
        text, way = waiting.pop(0)
        for name in _names(text):
            giver = giver_of(name, way, visible)
            if giver is not None and all(giver[0].span != known.span for known in found):
                found.append(giver[0])
                waiting.append((giver[0].text, giver[1]))
    return found[:MOST]


def _names(text: str) -> Iterator[str]:
    for _, code in expressions(text):
        yield from sorted(free_names(code) - BUILT_IN, key=code.find)
    for _, command in substitutions(text):
        if match := _ARGUMENT.match(command):
            yield f"$(arg {match[1]})"


def giver_of(name: str, way: tuple[Step, ...], visible: Definitions) -> tuple[Giver, tuple[Step, ...]] | None:
    """The text that gives a name its value inside some calls, and the scope that it is evaluated in."""
    if name.startswith("$(arg "):
        return _argument(name, visible)
    for depth, step in enumerate(way):
        call = _CALL.match(step.text)
        macros = visible.macros.get(call[1].rpartition(".")[2], []) if call else []
        if len(macros) == 1:
            given, is_of_caller = _inside(name, step, macros[0], visible)
            if given is not None:
                return given, way[depth + is_of_caller :]
    values = [each for each in visible.given.get(name, ()) if each.macro is None and each.value is not None]
    if len(values) != 1:
        return None
    value = values[0].element.attribute("value") or values[0].element.attribute("default")
    return None if value is None else (Giver(name, value.text, value.span), ())


def _inside(name: str, step: Step, macro: Macro, visible: Definitions) -> tuple[Giver | None, bool]:
    """The text that gives a name its value in a macro's body, and whether that is the call itself."""
    for each in visible.given.get(name, ()):
        value = each.element.attribute("value")
        if each.macro is macro.element and value is not None:
            return Giver(name, value.text, value.span), False
    for parameter in macro.parameters:
        if parameter.name != name:
            continue
        source = step.span.source
        tag = parse_start_tag(source, step.span.start - 1)[0]
        for attribute in tag.attributes:
            if attribute.name == name:
                span = source.span(attribute.value_start, attribute.value_end)
                return Giver(name, span.text, span), True
        if parameter.default is not None:
            return Giver(name, parameter.default, parameter_place(macro, parameter)), False
    return None, False


def _argument(name: str, visible: Definitions) -> tuple[Giver, tuple[Step, ...]] | None:
    """The default of an argument."""
    own = name[len("$(arg ") : -1]
    homes = [read for read in visible.readings if own in read.argument_elements]
    value = homes[0].argument_elements[own].attribute("default") if len(homes) == 1 else None
    return None if value is None else (Giver(name, value.text, value.span), ())

"""The arguments that a xacro file takes, and those that it lacks."""

from __future__ import annotations

import re
from collections.abc import Collection, Iterator

from sdfcheck.source.document import Document
from sdfcheck.source.record import NamedTuple
from sdfcheck.xacro.problems import ExpansionFailure, Failure
from sdfcheck.xacro.static.definitions import (
    Command,
    Definitions,
    is_conditional,
    is_outside,
    place,
    visible_definitions,
)

_ASKED = re.compile(r"arg\s+([^\s${}]+)\s*$")
_CALLED = re.compile(r"\barg\(\s*['\"]([^'\"]+)['\"]\s*\)")


class Taken(NamedTuple):
    """The arguments that a file declares or asks for; ``is_complete``: it takes no others."""

    names: frozenset[str]
    is_complete: bool


def taken_arguments(document: Document) -> Taken:
    """The arguments that a file takes, itself and in what it includes."""
    visible = visible_definitions(document)
    names = {name for read in visible.readings for name in read.arguments}
    for read in visible.readings:
        names.update(match[1] for command in read.commands if (match := _ASKED.match(command.text)))
        names.update(name for found in read.expressions for name in _CALLED.findall(found.code))
    return Taken(frozenset(names), not visible.is_open)


def missing_arguments(document: Document, given: Collection[str]) -> Iterator[ExpansionFailure]:
    """The first use of each argument that an expansion asks for and nobody gives a value."""
    visible = visible_definitions(document)
    known = {*given, *(name for read in visible.readings for name in read.arguments)}
    for read in visible.readings:
        if read.document in visible.conditional:
            continue
        for command in read.commands:
            match = _ASKED.match(command.text)
            if match and match[1] not in known and _is_asked(command, visible):
                known.add(match[1])
                whole = f"$({command.text})"
                span = place(command.element, command.attribute, whole)
                yield ExpansionFailure(span, Failure.ARGUMENT, match[1], whole)


def _is_asked(command: Command, visible: Definitions) -> bool:
    """Whether an expansion asks for what a command gives; for a property if somebody reads it."""
    element = command.element
    if command.certain or element.name != "xacro:property":
        return command.certain
    return (
        is_outside(element)
        and not is_conditional(element)
        and element.attributes.get("name") in visible.words
    )

"""The names in an SRDF file: its groups, and the links and joints that another file defines."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import islice

from sdfcheck.lsp.names.xacro_names import Known
from sdfcheck.robot.naming.occurrences import Occurrence
from sdfcheck.robot.semantics.occurrences import semantic_names
from sdfcheck.robot.semantics.robots import MOST_ROBOTS, descriptions_of
from sdfcheck.robot.semantics.semantics import Semantics
from sdfcheck.source.document import Document
from sdfcheck.source.sniff import Kind
from sdfcheck.xacro.static.definitions import visible_definitions

_FEWEST = 0.5
"""A file that defines fewer of the names is about another robot."""


def srdf_names(document: Document) -> Iterator[Occurrence]:
    """Every place in an SRDF document that names a group, or a link or joint of the robot."""
    known = descriptions(document)
    for each in semantic_names(document.view(Semantics)):
        symbol = each.symbol
        if symbol.span == each.span and not each.is_definition:
            found = (own.part((symbol.kind,), symbol.name, None) for own in known)
            symbol = next((own for own in found if own is not None), symbol)
        yield each._replace(symbol=symbol)


def descriptions(document: Document) -> list[Known]:
    """The names that the robot of an SRDF document defines; empty where none is found."""
    return document.view(_descriptions)


def _descriptions(document: Document) -> list[Known]:
    return [Known([visible_definitions(robot)]) for robot in descriptions_for(document)]


def descriptions_for(document: Document) -> list[Document]:
    """The file that is about the robot of an SRDF document: of the first few the one that has the most names."""
    return document.view(_described)


def _described(document: Document) -> list[Document]:
    if document.kind is not Kind.SRDF or document.root is None:
        return []
    semantics = document.view(Semantics)
    wanted = {
        (part.kind, part.value.text.strip()) for part in semantics.named if not semantics.is_added(part)
    }
    best: list[Document] = []
    most = _FEWEST * len(wanted)
    for robot in islice(descriptions_of(semantics), MOST_ROBOTS):
        known = Known([visible_definitions(robot)]) if robot.root is not None else None
        fitting = sum(known.part((kind,), name, None) is not None for kind, name in wanted) if known else -1
        if fitting > most or (fitting >= most and not best):
            best, most = [robot], fitting
        if fitting == len(wanted):
            break
    return best

"""The names of links and joints in an SRDF file, which another file defines."""

from __future__ import annotations

from collections.abc import Iterator

from sdfcheck.lsp.names.xacro_names import robot_symbols
from sdfcheck.robot.naming.occurrences import Occurrence, Symbol, robot_names, steps
from sdfcheck.robot.semantics.find import semantics_in
from sdfcheck.robot.semantics.robots import descriptions_of
from sdfcheck.robot.semantics.semantics import Semantics
from sdfcheck.source.document import Document
from sdfcheck.source.sniff import Kind

_FEWEST = 0.5
"""A file that defines fewer of the names is about another robot."""


def srdf_names(document: Document) -> Iterator[Occurrence]:
    """Every place in an SRDF document that names a link or joint of the robot."""
    for semantics in semantics_in(document):
        known = _symbols(semantics)
        for part in semantics.named:
            symbol = known.get((part.kind, part.value.text.strip()))
            if symbol is not None:
                yield Occurrence(steps(part.value)[0][0], symbol)


def _symbols(semantics: Semantics) -> dict[tuple[str, str], Symbol]:
    """The definitions of the nearest file that is about the robot."""
    wanted = {(part.kind, part.value.text.strip()) for part in semantics.named}
    for document in descriptions_of(semantics):
        known = _defined(document)
        if len(wanted & known.keys()) >= _FEWEST * len(wanted):
            return known
    return {}


def _defined(document: Document) -> dict[tuple[str, str], Symbol]:
    if document.root is None:
        return {}
    if document.kind is Kind.XACRO:
        return robot_symbols(document)
    symbols = (each.symbol for each in robot_names(document) if each.is_definition)
    return {(symbol.kind, symbol.name): symbol for symbol in symbols}

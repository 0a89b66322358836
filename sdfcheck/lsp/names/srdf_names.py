"""The names in an SRDF file: its groups, and the links and joints that another file defines."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from sdfcheck.files.library import library_of
from sdfcheck.lsp.names.xacro_names import Known
from sdfcheck.robot.naming.occurrences import Occurrence
from sdfcheck.robot.semantics.occurrences import semantic_names
from sdfcheck.robot.semantics.robots import MOST_FILES, descriptions_of
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
        if symbol.kind != "group":
            found = (own.part((symbol.kind,), symbol.name, None) for own in known)
            symbol = next((own for own in found if own is not None), symbol)
        yield each._replace(symbol=symbol)


def descriptions(document: Document) -> list[Known]:
    """The names that the robot of an SRDF document defines; empty where none is found."""
    return document.view(_descriptions)


def _descriptions(document: Document) -> list[Known]:
    return [Known([visible_definitions(robot)]) for robot in descriptions_for(document)]


def descriptions_for(document: Document) -> list[Document]:
    """The nearest file that is about the robot of an SRDF document."""
    return document.view(_described)


def _described(document: Document) -> list[Document]:
    if document.kind is not Kind.SRDF or document.root is None:
        return []
    semantics = document.view(Semantics)
    wanted = {(part.kind, part.value.text.strip()) for part in semantics.named}
    for robot in descriptions_of(semantics):
        if robot.root is None:
            continue
        known = Known([visible_definitions(robot)])
        fitting = sum(known.part((kind,), name, None) is not None for kind, name in wanted)
        if fitting >= _FEWEST * len(wanted):
            return [robot]
    return []


def semantics_of(document: Document, robots: Sequence[Document]) -> list[Document]:
    """The SRDF files of a project that are about some robots."""
    library = library_of(document)
    if library is None:
        return []
    packages = library.packages(document.path)
    paths = [
        *packages.files(".srdf", MOST_FILES),
        *(path for path in packages.files(".xacro", MOST_FILES) if ".srdf" in path.name),
    ]
    wanted = {robot.source.real_path for robot in robots}
    found = [library.document(path, Kind.SRDF) for path in paths]
    return [
        each
        for each in found
        if each is not None and any(robot.source.real_path in wanted for robot in descriptions_for(each))
    ]

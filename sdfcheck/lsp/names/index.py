"""Finding names: what is named at a place, and where else."""

from __future__ import annotations

import os
from bisect import bisect_right
from collections.abc import Iterator
from pathlib import Path

from sdfcheck.files.discover import discover
from sdfcheck.files.packages import project_root
from sdfcheck.files.regular import MEGABYTE, read_regular
from sdfcheck.lsp.names.srdf_names import srdf_names
from sdfcheck.lsp.names.xacro_names import xacro_names
from sdfcheck.lsp.workspace import Workspace
from sdfcheck.robot.naming.occurrences import Occurrence, Symbol, robot_names
from sdfcheck.source.document import Document
from sdfcheck.source.sniff import HEAD, Kind, sniff

MOST_FILES = 5_000
"""So many files of a project are searched for a name, no more."""
LARGEST = 16 * MEGABYTE

_NAMING = frozenset({Kind.SDF, Kind.URDF, Kind.XACRO, Kind.SRDF})


class Occurrences:
    """The names in a document, in order of place; each place once."""

    def __init__(self, document: Document) -> None:
        found: list[Occurrence] = []
        if document.root is not None and document.kind is Kind.XACRO:
            found = list(xacro_names(document))
        elif document.root is not None and document.kind in {Kind.SDF, Kind.URDF}:
            found = list(robot_names(document))
        elif document.kind is Kind.SRDF:
            found = list(srdf_names(document))
        by_place: dict[tuple[int, int, str], Occurrence] = {}
        for each in found:
            if each.span.source is document.source:
                by_place.setdefault((each.span.start, each.span.end, each.before), each)
        self.all = tuple(by_place[place] for place in sorted(by_place))
        self._starts = [each.span.start for each in self.all]

    def at(self, offset: int) -> Occurrence | None:
        """The name at a place; of a place that holds several the last."""
        number = bisect_right(self._starts, offset) - 1
        while number >= 0 and self.all[number].span.end < offset and self._starts[number] == offset:
            number -= 1
        if number < 0 or self.all[number].span.end < offset:
            return None
        return self.all[number]


def occurrences(document: Document) -> Occurrences:
    """The names in a document, found once."""
    return document.view(Occurrences)


def everywhere(workspace: Workspace, document: Document, symbol: Symbol) -> list[Occurrence]:
    """Every place where a symbol is named: in a document, in the file that defines it, and in their project."""
    found: list[Occurrence] = []
    for other in _documents(workspace, document, symbol):
        found += (each for each in occurrences(other).all if each.symbol.key == symbol.key)
    return found


def _documents(workspace: Workspace, document: Document, symbol: Symbol) -> Iterator[Document]:
    seen: set[str] = set()
    paths = [document.path, symbol.span.source.path]
    wanted = symbol.name.encode("utf-8", "surrogatepass")
    for path in (*paths, *project_files(workspace, document.path, wanted)):
        key = workspace.key(path)
        if key in seen:
            continue
        seen.add(key)
        other = document if path is document.path else workspace.document(path)
        if other is not None:
            yield other


def project_files(workspace: Workspace, path: Path, wanted: bytes = b"") -> Iterator[Path]:
    """The descriptions of a project that hold some bytes, the open ones first."""
    for buffer in list(workspace.buffers.values()):
        if wanted in buffer.data:
            yield buffer.path
    own = [folder for folder in workspace.folders if path.is_relative_to(folder)]
    folder = own[0] if own else project_root(path)
    if not folder.is_dir() or (not own and not os.path.exists(path)):
        return
    found = discover([folder], exclude=lambda each: workspace.settings_for(each).excludes(each))
    for file in found.files[:MOST_FILES]:
        if workspace.key(file.path) in workspace.buffers:
            continue
        try:
            data = read_regular(file.path, LARGEST)
        except OSError:
            continue
        if wanted in data and sniff(data[:HEAD], file.path) in _NAMING:
            yield file.path

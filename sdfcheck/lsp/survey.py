"""The parts of a whole project that have a name, found without reading its files as trees."""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path

from sdfcheck.files.regular import read_regular
from sdfcheck.lsp.names.index import LARGEST, project_files
from sdfcheck.lsp.workspace import Workspace
from sdfcheck.source.decode import decode
from sdfcheck.source.record import NamedTuple
from sdfcheck.source.text import Source, Span

_NAMED = re.compile(
    r"<(world|model|link|joint|frame|sensor|robot|xacro:macro|xacro:property|xacro:arg)\b"
    r"[^<>]*?\sname\s*=\s*([\"'])(.*?)\2",
    re.DOTALL,
)
_MOST = 500


class Found(NamedTuple):
    """A part of the project: the name of its element, its own, and where that is."""

    kind: str
    name: str
    span: Span


def survey(workspace: Workspace, query: str) -> list[Found]:
    """The parts whose names have the letters of a query, in their order; not all of very many."""
    letters = re.compile(".*?".join(map(re.escape, query.strip())), re.IGNORECASE | re.DOTALL)
    found: list[Found] = []
    for path in _paths(workspace):
        source = _source(workspace, path)
        if source is None:
            continue
        found += (
            Found(match[1], match[3], source.span(match.start(3), match.end(3)))
            for match in _NAMED.finditer(source.text)
            if letters.search(match[3])
        )
        if len(found) >= _MOST:
            break
    return sorted(found[:_MOST], key=lambda each: (len(each.name), each.name))


def _paths(workspace: Workspace) -> Iterator[Path]:
    seen: set[str] = set()
    starts = [folder / "all" for folder in workspace.folders]
    starts += [buffer.path for buffer in workspace.buffers.values()]
    for start in starts[:20]:
        for path in project_files(workspace, start):
            key = workspace.key(path)
            if key not in seen:
                seen.add(key)
                yield path


def _source(workspace: Workspace, path: Path) -> Source | None:
    buffer = workspace.buffers.get(workspace.key(path))
    if buffer is not None:
        return buffer.source
    try:
        return decode(read_regular(path, LARGEST), path)[0]
    except OSError:
        return None

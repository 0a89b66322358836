"""Lines above definitions: how often a name is used, and which files include this one."""

from __future__ import annotations

import os
from collections.abc import Iterator
from pathlib import Path

from sdfcheck.lsp.names.index import everywhere, occurrences, project_files
from sdfcheck.lsp.workspace import Workspace
from sdfcheck.source.document import Document
from sdfcheck.source.record import NamedTuple
from sdfcheck.source.sniff import Kind
from sdfcheck.source.text import Span

_COUNTED = frozenset({"macro", "model", "link", "joint", "frame"})
"""The kinds of names whose uses are counted."""


class Lens(NamedTuple):
    """A place above which there is a line; ``is_file``: it is about the whole file."""

    span: Span
    is_file: bool


class Count(NamedTuple):
    """The words of a line, and the places that it leads to."""

    title: str
    places: tuple[Span, ...]


def lenses(document: Document) -> Iterator[Lens]:
    """The places above which there are lines; what they say takes longer."""
    if document.root is None:
        return
    if document.kind in {Kind.XACRO, Kind.SDF}:
        yield Lens(document.root.span, True)
    for each in occurrences(document).all:
        if each.is_definition and each.symbol.kind in _COUNTED:
            yield Lens(each.span, False)


def counted(workspace: Workspace, document: Document, offset: int, *, is_file: bool) -> Count | None:
    """The line above a place; None where there is nothing to say."""
    if is_file:
        places = tuple(_inclusions(workspace, document))
        files = {span.source.path for span in places}
        return Count(f"included by {_number(len(files), 'file')}", places) if files else None
    named = occurrences(document).at(offset)
    if named is None:
        return None
    found = everywhere(workspace, document, named.symbol)
    places = tuple(each.span for each in found if not each.is_definition)
    return Count(_number(len(places), "reference"), places)


def _number(count: int, noun: str) -> str:
    return f"{count} {noun}{'' if count == 1 else 's'}"


def _inclusions(workspace: Workspace, document: Document) -> Iterator[Span]:
    """The elements that include a file, in the files of its project."""
    if document.kind is Kind.XACRO:
        yield from _of_xacro(workspace, document)
        return
    from sdfcheck.robot.includes.included import included, includes_of

    own = workspace.key(document.path)
    folder = Path(own).parent.name
    seen = {own}
    for path in project_files(workspace, document.path, folder.encode("utf-8", "surrogateescape")):
        other = workspace.document(path) if workspace.key(path) not in seen else None
        seen.add(workspace.key(path))
        if other is None or other.kind is not Kind.SDF:
            continue
        for include in includes_of(other):
            brought = included(other, include)
            if brought.file is not None and os.path.realpath(brought.file) == own:
                yield include.span if brought.uri is None else brought.uri.span


def _of_xacro(workspace: Workspace, document: Document) -> Iterator[Span]:
    from sdfcheck.xacro.static.definitions import reading, visible_definitions
    from sdfcheck.xacro.static.project import includers

    own = workspace.key(document.path)
    for path in includers(document):
        other = workspace.library(path).document(path, Kind.XACRO)
        if other is None:
            continue
        found = visible_definitions(other)
        elements = [include.element for include in reading(other).includes]
        targets = [(element, found.target(element)) for element in elements]
        sure = [element for element, target in targets if target is not None and workspace.key(target) == own]
        unknown = [element for element, target in targets if target is None]
        yield from (element.span for element in sure or unknown)

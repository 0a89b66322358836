"""Renaming and moving files: the texts that name them follow."""

from __future__ import annotations

import os
from collections.abc import Iterable, Iterator, Mapping
from pathlib import Path, PurePosixPath

from sdfcheck.lint.fix import TextEdit
from sdfcheck.lsp.names.index import project_files
from sdfcheck.lsp.outline import Link, links
from sdfcheck.lsp.workspace import Workspace
from sdfcheck.source.document import Document

Moves = Mapping[Path, Path]
"""File or folder → its path after the move; absolute."""


def moved(workspace: Workspace, moves: Moves) -> list[TextEdit]:
    """The edits, before the files are moved, after which all links of the project lead to the same files."""
    edits: dict[tuple[str, int], TextEdit] = {}
    for path in _files(workspace, moves):
        document = workspace.document(path)
        if document is None or document.root is None:
            continue
        for link in links(document):
            text = _followed(document, link, moves)
            if text is not None and text != link.span.text:
                edits[workspace.key(path), link.span.start] = TextEdit(link.span, text)
    return list(edits.values())


def _files(workspace: Workspace, moves: Moves) -> Iterator[Path]:
    """The files that may name what is moved, and those that are moved themselves."""
    seen: set[str] = set()
    for old in moves:
        inside = project_files(workspace, old)
        naming = project_files(workspace, old, old.name.encode("utf-8", "surrogateescape"))
        for path in (*naming, *(each for each in inside if _after(each, moves) is not None)):
            key = workspace.key(path)
            if key not in seen:
                seen.add(key)
                yield path


def _after(path: Path, moves: Moves) -> Path | None:
    """The path of a file after the move; None for one that stays."""
    plain = Path(os.path.abspath(path))
    for old, new in moves.items():
        if plain == old or plain.is_relative_to(old):
            return new / plain.relative_to(old)
    return None


def _followed(document: Document, link: Link, moves: Moves) -> str | None:
    """The text of a link after the move; None if it can stay, or nobody knows it."""
    text, target = link.span.text, Path(os.path.abspath(link.target))
    home = Path(os.path.abspath(document.path))
    new_home, new_target = _after(home, moves), _after(target, moves)
    if new_home is None and new_target is None:
        return None
    if _is_relative(text):
        return _relative(text, target, new_target or target, (new_home or home).parent)
    if new_target is None:
        return None
    return _in_place(text, (target, new_target), (target.parent, new_target.parent))


def _is_relative(text: str) -> bool:
    return ":" not in text and "$" not in text and not text.startswith("/")


def _relative(text: str, old: Path, new: Path, folder: Path) -> str:
    """A path from a folder to a file; to the folder of a model where the text names that."""
    if PurePosixPath(text).name != old.name and PurePosixPath(text).name == old.parent.name:
        new = new.parent
    found = Path(os.path.relpath(new, folder)).as_posix()
    return f"./{found}" if text.startswith("./") and not found.startswith("../") else found


def _in_place(text: str, *pairs: tuple[Path, Path]) -> str | None:
    """A URI with another end: as much of it stays as is around the old and the new path."""
    words = text.split("/")
    for old, new in pairs:
        for count in range(1, min(len(words), len(old.parts))):
            if tuple(words[-count:]) != old.parts[-count:]:
                break
            base = old.parents[count - 1]
            if new.is_relative_to(base):
                return "/".join([*words[:-count], new.relative_to(base).as_posix()])
    return None


def moves_of(renames: Iterable[tuple[Path, Path]]) -> Moves:
    """The moves of paths, by their absolute names."""
    return {Path(os.path.abspath(old)): Path(os.path.abspath(new)) for old, new in renames}

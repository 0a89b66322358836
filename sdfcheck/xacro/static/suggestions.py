"""Names that may be meant, and names that other files of the project define."""

from __future__ import annotations

import re
from collections.abc import Collection, Iterable
from pathlib import Path

from sdfcheck.files.library import library_of
from sdfcheck.files.regular import MEGABYTE, read_regular
from sdfcheck.source.document import Document
from sdfcheck.source.effort import Effort
from sdfcheck.source.scanner.evidence import alike

FILE_LIMIT = 1000
"""So many files of a project are looked through for definitions, no more."""
SIZE_LIMIT = 16 * MEGABYTE
"""Larger files are not searched for names."""

_DEFINED = re.compile(r"<xacro:(?:property|macro)\b[^<>]*?\sname\s*=\s*[\"']([^\"']+)")
_PARAMETERS = re.compile(r"\sparams\s*=\s*(?:\"([^\"]*)\"|'([^']*)')")
_WORD = re.compile(r"[^\W\d][\w.]*")


def nearest(name: str, candidates: Iterable[str], likeness: float = 0.75) -> str | None:
    """The candidate that a misspelt name was meant to be, None if none is so much like it."""
    import difflib

    if len(name) < 3:
        return None
    pool = {candidate.casefold(): candidate for candidate in sorted(candidates)}
    near = difflib.get_close_matches(name.casefold(), pool, n=1, cutoff=likeness)
    return pool[near[0]] if near else None


def guess(document: Document, name: str, known: Collection[str], *, surely: bool) -> str | None:
    """What a name was meant to be: the one it misspells or, unless it has to be ``surely`` so, most like.

    A document full of unknown names is not guessed at for ever.
    """
    effort = document.view(Effort)
    if effort.is_spent:
        return None
    effort.spend(len(known))
    return misspelling_of(name, known) or (None if surely else nearest(name, known))


def misspelling_of(name: str, candidates: Iterable[str]) -> str | None:
    """The candidate of which a name is a misspelling for certain: each of its words is at most a misspelling away.

    Where not all definitions are known, a name may well be one of them that is merely like others.
    """
    words = _words(name)
    for candidate in sorted(candidates):
        others = _words(candidate)
        pairs = zip(words, others, strict=False)
        if len(words) == len(others) and all(a == b or (len(a) > 2 and alike(a, b)) for a, b in pairs):
            return candidate
        if len(words) != len(others) and len(name) > 3 and alike(name, candidate):
            return candidate
    return None


def _words(name: str) -> list[str]:
    return re.split(r"[_.\-]", name.lower())


def is_included(document: Document) -> bool:
    """Does a file of the project include one of this name? Then it may define what this one uses."""
    return document.view(_is_included)


def _is_included(document: Document) -> bool:
    if (library := library_of(document)) is None:
        return False
    name = re.escape(document.path.name)
    pattern = re.compile(rf"<xacro:include\b[^<>]*?\sfilename\s*=\s*[\"'](?:[^\"']*/)?{name}[\"']")
    files = library.packages(document.path).files(".xacro", FILE_LIMIT)
    return any(pattern.search(text_of(path)) for path in files)


def project_names(document: Document) -> frozenset[str]:
    """All that any xacro file of the document's project defines: who includes a library may define it."""
    return document.view(_project_names)


def _project_names(document: Document) -> frozenset[str]:
    library = library_of(document)
    if library is None:
        return frozenset()
    names: set[str] = set()
    for path in library.packages(document.path).files(".xacro", FILE_LIMIT):
        text = text_of(path)
        names.update(_DEFINED.findall(text))
        for match in _PARAMETERS.finditer(text):
            names.update(_WORD.findall(match[1] or match[2] or ""))
    return frozenset(names)


def text_of(path: Path) -> str:
    """A file's text, empty if it cannot be read."""
    try:
        return read_regular(path, SIZE_LIMIT).decode("utf-8", "replace")
    except OSError:
        return ""

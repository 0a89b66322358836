"""Names that may be meant, and names that other files of the project define."""

from __future__ import annotations

import re
from collections.abc import Iterable
from pathlib import Path

from sdfcheck.source.document import Document

FILE_LIMIT = 1000
"""So many files of a project are looked through for definitions, no more."""

_DEFINED = re.compile(r"<xacro:(?:property|macro)\b[^>]*?\sname\s*=\s*[\"']([^\"']+)")
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


def project_names(document: Document) -> frozenset[str]:
    """All that any xacro file of the document's project defines: who includes a library may define it."""
    return document.view(_project_names)


def _project_names(document: Document) -> frozenset[str]:
    library = document.library
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
        return path.read_text(encoding="utf-8", errors="replace")
    except OSError:
        return ""

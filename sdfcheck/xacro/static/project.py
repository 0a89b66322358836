"""The other xacro files of a project: which include this one, and which names they define."""

from __future__ import annotations

import os
import re
from collections.abc import Iterator
from fnmatch import fnmatch
from functools import lru_cache
from pathlib import Path

from sdfcheck.files.library import Library, library_of
from sdfcheck.files.packages import Packages
from sdfcheck.files.regular import MEGABYTE, read_regular
from sdfcheck.source.document import Document
from sdfcheck.source.record import NamedTuple
from sdfcheck.source.sniff import MADE_BY_XACRO
from sdfcheck.xacro.language import FIND, LEADING, is_literal, matches

FILE_LIMIT = 1000
"""So many files of a project are looked through for definitions, no more."""
SIZE_LIMIT = 16 * MEGABYTE
"""Larger files are not searched for names."""

_DEFINED = re.compile(
    r"<xacro:(property|macro)\b[^<>]*?\sname\s*=\s*[\"']([^\"']+)|</xacro:macro\b|<!--[\s\S]*?(?:-->|\Z)"
)
_PARAMETERS = re.compile(r"\sparams\s*=\s*(?:\"([^\"]*)\"|'([^']*)')")
_WORD = re.compile(r"[^\W\d][\w.]*")
_INCLUDED = re.compile(r"<xacro:include\b[^<>]*?\sfilename\s*=\s*[\"']([^\"'<>]+)[\"']")
_ARGUMENT = re.compile(
    r"<xacro:(?:arg|property)\b[^<>]*?\s(?:default|value)\s*=\s*[\"']([^\"'<>]+\.\w+)[\"']"
)
"""An argument or property may hold the name of a file that is included."""
_DEFAULT = re.compile(r"\$\(optenv\s+\w+\s([^()]*)\)")
"""The value of a variable that is mostly not set."""
_MADE_OF = re.compile(rf"{MADE_BY_XACRO}([^|\n]*)")
"""The path in the remark of xacro in a file that it makes."""
_LED = re.compile(rf"<(?:link|joint)\s[^<>]*?\bname\s*=\s*[\"']{LEADING}(?P<rest>[^\"'<>]+)[\"']")
"""A link or joint whose name begins with an expression."""
_LINK = re.compile(r'<link\s(?:[^<>"]*\s)?name="([^"]*)"')
_GLOB = re.compile(r"[*?\[]")
_LITERAL = re.compile(r"\w")
"""A path of which more is written than the ending, so that not every file may be meant."""
_TELLING = 3
"""So many last parts of a path are those of one file, whatever is before them."""
_EXPRESSION = re.compile(r"\$\([^()]*\)|\$\{[^{}]*\}")


def _pattern(path: str) -> str:
    """A path whose expressions may be anything."""
    return _EXPRESSION.sub("*", path)


_CODE = r"\$\{([^{}]*)\}"
_CALL = r"<xacro:([\w.]+)"


class _Filename(NamedTuple):
    """A file name as another file of the project writes it."""

    text: str
    by: Path


class _Project:
    """The names in the xacro files of a project: those that occur, and those that are defined."""

    __slots__ = (
        "_written",
        "definers",
        "endings",
        "expanded",
        "filenames",
        "is_whole",
        "names",
        "paths",
        "patterns",
    )

    def __init__(self, packages: Packages) -> None:
        self.filenames: dict[str, list[_Filename]] = {}
        self.patterns: list[_Filename] = []
        self.definers: dict[tuple[str, str], list[Path]] = {}
        """The files that define a macro, or a property outside of macros: ``("macro", name)``."""
        self._written: dict[str, frozenset[str]] = {}
        names: set[str] = set()
        endings: set[str] = set()
        paths, self.expanded = _sources(packages)
        self.paths = tuple(paths)
        self.is_whole = len(self.paths) < FILE_LIMIT
        for path in self.paths:
            text = text_of(path)
            for written in (*_INCLUDED.findall(text), *_ARGUMENT.findall(text)):
                name = _DEFAULT.sub(lambda found: found[1].strip(), written)
                last = _pattern(name).rpartition("/")[2]
                if _GLOB.search(last):
                    if _says_something(name):
                        self.patterns.append(_Filename(name, path))
                else:
                    self.filenames.setdefault(last, []).append(_Filename(name, path))
            depth = 0
            for match in _DEFINED.finditer(text):
                own, name = match.groups()
                if name and (own == "macro" or not depth):
                    self.definers.setdefault((own, name), []).append(path)
                depth += (own == "macro") - match[0].startswith("</")
            endings.update(_endings(text))
            names.update(_names_in(text))
        self.names = frozenset(names)
        self.endings = frozenset(endings)
        """The names of links and joints that begin with an expression, without that."""

    def of(self, name: str) -> list[_Filename]:
        """The paths in include elements that may be those of a file of this name."""
        globs = [each for each in self.patterns if fnmatch(name, _pattern(each.text).rpartition("/")[2])]
        return [*self.filenames.get(name, ()), *globs]

    def written(self, pattern: str) -> frozenset[str]:
        """The names, by the group of a pattern, in all the files."""
        if pattern not in self._written:
            texts = map(text_of, self.paths)
            self._written[pattern] = frozenset(name for text in texts for name in re.findall(pattern, text))
        return self._written[pattern]


def is_expanded(document: Document) -> bool:
    """Does a file of the project say that xacro made it of this one?"""
    library = library_of(document)
    return library is not None and document.path.name in _project(library, document).expanded


def _sources(packages: Packages) -> tuple[list[Path], set[str]]:
    """The files in which xacro finds something to do, and the names of those of which it made others."""
    paths, expanded = [*packages.files(".xacro", FILE_LIMIT)], set[str]()
    for path in packages.files(".urdf", FILE_LIMIT):
        text = text_of(path)
        expanded.update(source.strip().rpartition("/")[2] for source in _MADE_OF.findall(text))
        if "<xacro:" in text:
            paths.append(path)
    return paths, expanded


def is_included(document: Document) -> bool:
    """Does another file of the project include this one? Then it may define what this one uses."""
    return document.view(_is_included)


def _is_included(document: Document) -> bool:
    return any(True for _ in _inclusions(document, document.path))


def includers(document: Document) -> list[Path]:
    """The other xacro files of the project that include this one, directly, sorted."""
    return sorted({each.by for each in _inclusions(document, document.path)})


def is_called(document: Document, macro: str) -> bool:
    """Does a xacro file of the project call a macro of that name, as far as that is known?"""
    library = library_of(document)
    return library is None or macro in _project(library, document).written(_CALL)


def is_read_in_project(document: Document, word: str) -> bool:
    """Is a word in an expression of a xacro file of the project, as far as that is known?"""
    library = library_of(document)
    if library is None or not _project(library, document).is_whole:
        return True
    codes = _project(library, document).written(_CODE)
    return any(word in code and re.search(rf"\b{re.escape(word)}\b", code) for code in codes)


def has_namesake(document: Document) -> bool:
    """Has another xacro file of the project the same file name?"""
    library = library_of(document)
    paths = () if library is None else _project(library, document).paths
    return sum(path.name == document.path.name for path in paths) > 1


def links_of_namesakes(document: Document) -> frozenset[str]:
    """The links of the project's other robots of the same name, as they are written: this one may be a part of one."""
    library, root = library_of(document), document.root
    robot = root.text_of("name", "") if root is not None else ""
    if library is None or not robot:
        return frozenset()
    named = re.compile(rf'<robot\s(?:[^<>]*\s)?name="{re.escape(robot)}"')
    own = library.disk.real(document.path)
    others = (path for path in _project(library, document).paths if library.disk.real(path) != own)
    return frozenset(
        link for text in map(text_of, others) if named.search(text) for link in _LINK.findall(text)
    )


def names_beside(document: Document, path: Path, pattern: str) -> frozenset[str]:
    """The names, by the group of a pattern, in the project's xacro files, if a file of it is in several robots."""
    library = library_of(document)
    robots = len({each.by for each in _inclusions(document, path)}) + (path == document.path)
    if library is None or robots < 2:
        return frozenset()
    return _project(library, document).written(pattern)


def _inclusions(document: Document, path: Path) -> Iterator[_Filename]:
    """The places where xacro files of a document's project include a file."""
    if (library := library_of(document)) is not None and not library.search.is_alone:
        packages = library.packages(path)
        own = library.disk.real(path)
        for each in _project(library, document).of(path.name):
            if library.disk.real(each.by) != own and _leads(each, own, packages, library):
                yield each


def _leads(filename: _Filename, own: str, packages: Packages, library: Library) -> bool:
    """Whether a file name leads to a file; as far as it is not known, whether it may."""
    text, folder = filename.text, filename.by.parent
    first = next(matches(text), None)
    found = FIND.match(first["command"] or "") if first is not None and first.start() == 0 else None
    if first is not None and found is not None:
        package = packages.find(found[1], filename.by)
        if package is None:
            parts = _pattern(text[first.end() :]).lstrip("/").split("/")
            if found[1] not in Path(own).parts:
                # Its folder has another name, if it is here at all: two folders below it tell as much.
                parts = parts[-_TELLING:]
                if len(parts) < _TELLING or any(map(_GLOB.search, parts)):
                    return False
            return fnmatch(Path(own).as_posix(), f"*/{'/'.join(parts)}")
        text, folder = text[first.end() :].lstrip("/"), package
    if is_literal(text) and not _GLOB.search(text):
        return library.disk.real(packages.locate(folder / text)) == own
    pattern = _pattern(text)
    whole = pattern if pattern.startswith("*") else os.path.normpath(Path(library.disk.real(folder), pattern))
    return fnmatch(Path(own).as_posix(), Path(whole).as_posix())


def possible_files(document: Document, filename: str, by: Path) -> list[Path]:
    """The xacro files of a document's project to which a path with expressions may lead, as a file writes it."""
    library = library_of(document)
    if library is None or library.search.is_alone or is_literal(filename) or not _says_something(filename):
        return []
    packages, written = library.packages(by), _Filename(filename, by)
    paths = _project(library, document).paths
    return [path for path in paths if _leads(written, library.disk.real(path), packages, library)]


def _says_something(filename: str) -> bool:
    """Is more of a path written than its ending, so that not every file may be meant?"""
    folder, _, last = _pattern(filename).rpartition("/")
    return bool(_LITERAL.search(folder + last.removesuffix(".xacro").removesuffix(".urdf")))


def passed(document: Document, macro: str, parameter: str) -> frozenset[str]:
    """The texts that calls of a macro give a parameter, empty for none: in its file and in those that include it."""
    call = re.compile(rf"<xacro:{re.escape(macro)}(?=[\s/>])([^<>]*)>")
    given = re.compile(rf"\s{re.escape(parameter)}\s*=\s*(?:\"([^\"]*)\"|'([^']*)')")
    texts = (document.source.text, *map(text_of, includers(document)))
    values = (given.search(found[1]) for text in texts for found in call.finditer(text))
    return frozenset((value[1] or value[2] or "").strip() if value else "" for value in values)


def name_endings(document: Document) -> frozenset[str]:
    """The names of links and joints in the document's project that begin with an expression, each without that."""
    library = library_of(document)
    if library is None or library.search.is_alone:
        return frozenset(_endings(document.source.text))
    return _project(library, document).endings


def _endings(text: str) -> Iterator[str]:
    return (match["rest"] for match in _LED.finditer(text))


def project_names(document: Document) -> frozenset[str]:
    """All that any xacro file of the document's project defines: who includes a library may define it.

    That of open texts counts as well, which may not be saved yet.
    """
    library = library_of(document)
    if library is None:
        return frozenset()
    return _project(library, document).names.union(*map(_names_in, library.open_texts))


@lru_cache(maxsize=4)
def _names_in(text: str) -> frozenset[str]:
    """The names of the macros, their parameters and the properties that a text defines."""
    defined = (match[2] for match in _DEFINED.finditer(text) if match[2])
    lists = (match[1] or match[2] or "" for match in _PARAMETERS.finditer(text))
    return frozenset((*defined, *(word for each in lists for word in _WORD.findall(each))))


def definer(document: Document, kind: str, name: str) -> Path | None:
    """The one file of the project that defines a macro, or a property for all; None if there are none or several."""
    library = library_of(document)
    found = set() if library is None else set(_project(library, document).definers.get((kind, name), ()))
    return found.pop() if len(found) == 1 else None


def is_whole(document: Document) -> bool:
    """Was the whole project of a document looked through?"""
    library = library_of(document)
    return library is not None and _project(library, document).is_whole


def _project(library: Library, document: Document) -> _Project:
    return library.of_project(document.path, _Project)


def text_of(path: Path) -> str:
    """A file's text, empty if it cannot be read."""
    try:
        return read_regular(path, SIZE_LIMIT).decode("utf-8", "replace")
    except OSError:
        return ""

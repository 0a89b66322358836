"""All that a xacro file can see: itself and what it includes, as far as that can be known."""

from __future__ import annotations

import re
from pathlib import Path

from sdfcheck.files.library import library_of
from sdfcheck.source.document import Document
from sdfcheck.source.element import Element
from sdfcheck.source.record import Record
from sdfcheck.source.sniff import Kind
from sdfcheck.source.text import Span
from sdfcheck.xacro.language import FIND, PREFIX, matches
from sdfcheck.xacro.static.project import is_included
from sdfcheck.xacro.static.reading import Include, Macro, Reading, reading

_CONTENT = frozenset({"xacro:call", "xacro:insert_block", "xacro:element"})
_GLOB = re.compile(r"[*?\[]")
_SIMPLE = re.compile(r"[^\W\d]\w*")
_ARGUMENT = re.compile(r"arg\s+(\S+)\s*$")


class Cycle(Record):
    """An include that leads back to a file that is being included."""

    include: Include
    steps: tuple[Span, ...]
    certain: bool


class Definitions:
    """A document and the files that it includes.

    ``is_open``: some of them cannot be known or read, so that what is not found here
    may still be somewhere.
    """

    def __init__(self, document: Document) -> None:
        self.readings: list[Reading] = []
        self.cycles: list[Cycle] = []
        self.is_open = False
        self.missing: list[Include] = []
        """The includes of the document itself whose file is known for certain and not there."""
        self.unmatched: list[Include] = []
        """The includes of the document itself whose pattern matches no file."""
        self.conditional: set[Document] = set()
        """The documents that only includes lead to which xacro may ignore."""
        self._done: set[Path] = set()
        self._enter(document, ())
        self.macros: dict[str, list[Macro]] = {}
        for read in self.readings:
            for macro in read.macros:
                self.macros.setdefault(macro.name, []).append(macro)
        self.namespaces = {i.namespace for read in self.readings for i in read.includes if i.namespace}
        self.properties = {p.name for read in self.readings for p in read.properties} | self.namespaces
        self.parameters = {
            p.name.lstrip("*") for read in self.readings for macro in read.macros for p in macro.parameters
        }
        self.words = set[str]().union(*(read.words for read in self.readings))

    def _enter(self, document: Document, way: tuple[tuple[Path, Include | None], ...]) -> None:
        path = _real(document.path)
        self._done.add(path)
        read = reading(document)
        self.readings.append(read)
        self.is_open |= read.is_open
        if any(include is not None and include.conditional for _, include in way):
            self.conditional.add(document)
        for include in read.includes:
            targets = self._targets(include, document)
            if not targets and self._is_pattern(include, document):
                self.unmatched += [include] if not way else []
                continue
            self.is_open |= not targets
            if not targets and not way and not include.optional and self._known_path(include, document):
                self.missing.append(include)
            for target in targets:
                self._follow(target, document, (*way, (path, include)))

    def _follow(self, target: Path, document: Document, way: tuple[tuple[Path, Include | None], ...]) -> None:
        real = _real(target)
        paths = [path for path, _ in way]
        if real in paths:
            if real == paths[0]:
                passed = [i for _, i in way[paths.index(real) :] if i is not None]
                certain = not any(i.conditional for i in passed)
                first = passed[0]
                self.cycles.append(Cycle(first, tuple(i.element.span for i in passed), certain))
            return
        if real in self._done:
            return
        library = library_of(document)
        found = library.document(target, Kind.XACRO, document) if library else None
        if found is None or found.root is None:
            self.is_open = True
        else:
            self._enter(found, way)

    def _targets(self, include: Include, document: Document) -> list[Path]:
        """The files that an include names; none if that cannot be known."""
        path = self._known_path(include, document)
        if path is None or (library := library_of(document)) is None:
            return []
        if _GLOB.search(str(path)):
            return sorted(path.parent.glob(path.name)) if not _GLOB.search(str(path.parent)) else []
        path = library.packages(document.path).locate(path)
        return [path] if path.is_file() else []

    def target(self, element: Element) -> Path | None:
        """The one file that an ``xacro:include`` names; None if that cannot be known."""
        for read in self.readings:
            for include in read.includes:
                if include.element is element:
                    found = self._targets(include, read.document)
                    return found[0] if len(found) == 1 else None
        return None

    def _is_pattern(self, include: Include, document: Document) -> bool:
        """Whether an include names files by a pattern, in a folder that is known."""
        path = self._known_path(include, document)
        return path is not None and bool(_GLOB.search(path.name)) and not _GLOB.search(str(path.parent))

    def _known_path(self, include: Include, document: Document) -> Path | None:
        """Where an include leads, if that can be known."""
        text = self._known_text(include.filename, document)
        return document.path.parent / text if text and document.library is not None else None

    def _known_text(self, text: str, document: Document) -> str:
        """A text whose substitutions have one possible value each; empty if one of them has not."""
        pieces, at = [], 0
        for match in matches(text):
            value = self._value(match, document)
            if value is None:
                return ""
            pieces += [text[at : match.start()], value]
            at = match.end()
        return "".join([*pieces, text[at:]])

    def _value(self, match: re.Match[str], document: Document) -> str | None:
        if match["command"] is not None:
            find = FIND.match(match["command"])
            if find and (library := library_of(document)) is not None:
                folder = library.packages(document.path).find(find[1])
                return None if folder is None else str(folder)
            argument = _ARGUMENT.match(match["command"])
            name = argument[1] if argument else ""
            values = {read.arguments[name] for read in self.readings if name in read.arguments}
        elif match["code"] is not None and _SIMPLE.fullmatch(match["code"].strip()):
            name = match["code"].strip()
            if any(p.name == name for r in self.readings for macro in r.macros for p in macro.parameters):
                return None
            values = {p.value or "" for r in self.readings for p in r.properties if p.name == name}
        else:
            return None
        return self._known_text(values.pop(), document) or None if len(values) == 1 else None


def visible_definitions(document: Document) -> Definitions:
    return document.view(Definitions)


def is_robot(document: Document) -> bool:
    """Whether a file is meant to be expanded on its own, rather than to be included.

    A robot has a name (a SDFormat document needs none), and elements or macro calls
    outside of macros; or else it only puts together what it includes.
    """
    root = document.root
    if root is None or root.name not in {"robot", "sdf"}:
        return False
    if root.name == "robot" and "name" not in root.attributes:
        return False
    has_content = has_macros = has_includes = False
    todo = list(root.children())
    while todo:
        element = todo.pop()
        name = element.name
        if name in {"xacro:if", "xacro:unless"}:
            todo += element.children()
        elif name in {"xacro:macro", "xacro:include"}:
            has_macros |= name == "xacro:macro"
            has_includes |= name == "xacro:include"
        elif name not in {"xacro:property", "xacro:arg", "xacro:attribute"}:
            has_content |= not name.startswith(PREFIX) or name in _CONTENT or name.count(":") == 1
    return has_content or (has_includes and not has_macros)


def knows_all(document: Document) -> bool:
    """Is all that a file uses known? Not what those define that include it, or what cannot be found."""
    return document.view(_knows_all)


def _knows_all(document: Document) -> bool:
    return is_robot(document) and not visible_definitions(document).is_open and not is_included(document)


def _real(path: Path) -> Path:
    return path.resolve()

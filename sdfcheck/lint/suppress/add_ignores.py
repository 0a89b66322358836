"""Writes comments that silence what a run has found."""

from __future__ import annotations

import os
import re
from bisect import bisect_right
from collections.abc import Iterator, Sequence
from pathlib import Path

from sdfcheck.lint.diagnostic import Diagnostic
from sdfcheck.lint.engine import INTERNAL_ERROR
from sdfcheck.lint.fix import TextEdit
from sdfcheck.lint.fix.fixer import FixedFile, Refused, edited
from sdfcheck.lint.one_file import Selected
from sdfcheck.lint.rulebook.rulebook import RuleBook
from sdfcheck.lint.run import RuleFacts, Run
from sdfcheck.lint.session import Options, find, selected
from sdfcheck.lint.suppress.rules import FACTS
from sdfcheck.lint.suppress.suppression import (
    IGNORE,
    IGNORE_FILE,
    Directive,
    comments,
    directives,
    is_include,
    reach,
)
from sdfcheck.source.document import Document, read
from sdfcheck.source.sniff import Kind
from sdfcheck.source.text import Span

_OWN = frozenset(facts.code for facts in (*FACTS, INTERNAL_ERROR))
"""Diagnostics of the engine itself cannot be silenced."""
_LINE_END = re.compile(r"\r\n?|\n")
_Key = tuple[str, int]
"""The kind of directive, and the offset of the element that it goes before."""


def add_ignores(
    done: Run, paths: Sequence[Path], options: Options, *, reason: str = ""
) -> Iterator[FixedFile]:
    """Each file of a run in which something can be silenced, before and after; nothing is written.

    A diagnostic that a comment before the element does not reach takes one for the whole file.
    Diagnostics in other files are silenced where these are included.
    """
    files = {os.path.realpath(path): path for path in done.files}
    wanted: dict[Path, list[tuple[Diagnostic, Span]]] = {}
    for diagnostic in done.diagnostics:
        spans = (diagnostic.span, *(origin.span for origin in diagnostic.origins))
        place = next((span for span in spans if os.path.realpath(span.source.path) in files), None)
        if place is not None and diagnostic.code not in _OWN:
            path = files[os.path.realpath(place.source.path)]
            wanted.setdefault(path, []).append((diagnostic, place))
    found = find(paths, options)
    found = found._replace(files=tuple(f for f in found.files if f.path in wanted), empty=())
    book = RuleBook()
    for file in selected(found, options, []):
        rules = book.rules(options.settings_for(file.path))
        yield _marked(file, wanted[file.path], rules, reason)


def ignoring(document: Document, diagnostic: Diagnostic, rules: Sequence[RuleFacts]) -> list[TextEdit]:
    """The edits of a document that silence one diagnostic, where it is if that can be, else in the
    whole file.

    None for a diagnostic that cannot be silenced, or is silenced already.
    """
    if diagnostic.code in _OWN or document.root is None:
        return []
    marks = _Marks(document, rules)
    return marks.edits("") if marks.add(diagnostic, diagnostic.span) else []


def _marked(
    file: Selected, findings: list[tuple[Diagnostic, Span]], rules: Sequence[RuleFacts], reason: str
) -> FixedFile:
    document = read(file.data, file.path, None if file.kind is Kind.BROKEN_XML else file.kind)
    sources = {id(place.source): place.source for _, place in findings}
    if any(source.text != document.source.text for source in sources.values()):
        return FixedFile(file.path, file.data, file.data, 0, "it has changed meanwhile")
    if document.root is None:
        return FixedFile(file.path, file.data, file.data, 0)
    marks = _Marks(document, rules)
    silenced = sum(marks.add(diagnostic, place) for diagnostic, place in findings)
    try:
        after = edited(file, marks.edits(reason)) if silenced else file.data
    except Refused as refusal:
        return FixedFile(file.path, file.data, file.data, 0, str(refusal))
    return FixedFile(file.path, file.data, after, silenced)


class _Marks:
    """The directives that a document needs in addition to those that it has."""

    def __init__(self, document: Document, rules: Sequence[RuleFacts]) -> None:
        self._document = document
        self._source = document.source
        self._scan = document.scan
        self._known: dict[_Key, Directive] = {}
        self._covered: set[tuple[_Key, str]] = set()
        self._new: dict[_Key, set[str]] = {}
        for directive in directives(comments(self._source, self._scan), rules).known:
            if (key := self._key(directive)) is not None:
                self._known.setdefault(key, directive)
                self._covered |= {(key, code) for each in directive.selectors for code in each.codes}

    def add(self, diagnostic: Diagnostic, place: Span) -> bool:
        """Note what silences a diagnostic; False if all that could is there already."""
        element = self._element(place, is_origin=place is not diagnostic.span)
        near = [] if element is None else [(IGNORE, self._scan.starts[element])]
        for key in (*near, (IGNORE_FILE, self._scan.starts[0])):
            if (key, diagnostic.code) not in self._covered:
                self._new.setdefault(key, set()).add(diagnostic.name)
                return True
        return False

    def edits(self, reason: str) -> list[TextEdit]:
        """Longer lists in comments that are there, new comments before the elements."""
        edits: list[TextEdit] = []
        texts: dict[int, str] = {}
        for (verb, start), names in sorted(self._new.items(), key=lambda item: item[0][1]):
            words = ", ".join(sorted(names))
            known = self._known.get((verb, start))
            if known is not None and known.place.text.endswith("]"):
                end = known.place.end - 1
                edits.append(TextEdit(self._source.span(end, end), f", {words}"))
                continue
            # Launch files of ROS 2 read a URDF as YAML, where a colon and a space mean something.
            blank = "" if self._document.kind in {Kind.URDF, Kind.XACRO} else " "
            comment = f"<!-- {' '.join(filter(None, (f'sdfcheck:{blank}{verb}[{words}]', reason)))} -->"
            texts[start] = texts.get(start, "") + comment + self._break(start)
        edits += (TextEdit(self._source.span(start, start), text) for start, text in texts.items())
        return sorted(edits, key=lambda edit: edit.span.start)

    def _key(self, directive: Directive) -> _Key | None:
        target = directive.comment.target
        if directive.verb == IGNORE and target is not None:
            return IGNORE, target.start
        return (IGNORE_FILE, self._scan.starts[0]) if directive.verb == IGNORE_FILE else None

    def _element(self, place: Span, *, is_origin: bool) -> int | None:
        """The element before which a comment reaches a place."""
        scan, source = self._scan, self._source
        number = bisect_right(scan.starts, place.start) - 1
        if number < 0 or self._document.is_doubtful(source.span(scan.starts[number], scan.starts[number])):
            return None
        if is_origin:
            around = (n for n in range(number, -1, -1) if scan.close_ends[n] > place.start)
            number = next((n for n in around if is_include(source, scan.starts[n])), number)
        start, end = reach(source, scan, number)
        before = source.text[:start].rstrip()
        is_free = number == 0 or before.endswith(">")
        return number if start <= place.start < end and is_free else None

    def _break(self, start: int) -> str:
        """The text between a comment and the element after it: a new line as the element's own."""
        text = self._source.text
        line = max(text.rfind("\n", 0, start), text.rfind("\r", 0, start)) + 1
        indent = text[line:start]
        if indent.strip():
            return ""
        end = _LINE_END.search(text, max(0, line - 2), line) or _LINE_END.search(text, start)
        return (end[0] if end else "\n") + indent

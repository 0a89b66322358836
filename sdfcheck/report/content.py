"""The content of the HTML report, as JSON for its script, with the robots that it shows."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from pathlib import Path
from typing import Any

from sdfcheck.consumers.reaction import Consumer
from sdfcheck.lint.diagnostic import Diagnostic, Severity
from sdfcheck.lint.fix import Fix, TextEdit
from sdfcheck.lint.run import Run
from sdfcheck.release import __version__
from sdfcheck.report.colors import INK_OF, painter
from sdfcheck.report.digest import Row, not_found, sections
from sdfcheck.report.frame import first_of, frame, marks_by_file
from sdfcheck.report.paths import Paths
from sdfcheck.report.summary import View, closing_line
from sdfcheck.source.document import Document
from sdfcheck.source.record import NamedTuple
from sdfcheck.source.text import Source
from sdfcheck.source.visible import harmless_document, visible
from sdfcheck.view.meshes import Meshes
from sdfcheck.view.notes import findings
from sdfcheck.view.page import page, split
from sdfcheck.view.scene import scene

# A fix as the lines that it changes, with what it takes out of them and puts into them.


KEPT, DELETED, INSERTED = "=", "-", "+"
_AROUND = 80
"""Characters that are shown of unchanged text beside a change."""
_LONGEST = 2000
"""Characters that are shown of what a change takes out or puts in."""


class Hunk(NamedTuple):
    """Lines from number ``line`` on, in pieces: each with its kind, in the order of the text."""

    line: int
    pieces: tuple[tuple[str, str], ...]


def hunks(fix: Fix) -> Iterator[Hunk]:
    """The changed lines; changes that share a line are shown together."""
    group: list[TextEdit] = []
    end = -1
    for edit in sorted(fix.edits, key=lambda edit: (edit.span.start, edit.span.end)):
        if group and edit.span.start > end:
            yield _hunk(group)
            group = []
        group.append(edit)
        end = _line_end(edit.span.source, edit.span.end)
    if group:
        yield _hunk(group)


def _hunk(edits: list[TextEdit]) -> Hunk:
    line = edits[0].span.begin.line
    return Hunk(line, tuple((kind, shown) for kind, text in _pieces(edits, line) if (shown := _shown(text))))


def _pieces(edits: Iterable[TextEdit], line: int) -> Iterator[tuple[str, str]]:
    edits = list(edits)
    source = edits[0].span.source
    at = source.line_starts[line - 1]
    for number, edit in enumerate(edits):
        yield KEPT, _between(source.text[at : edit.span.start], is_first=number == 0)
        yield DELETED, _cut(source.text[edit.span.start : edit.span.end])
        yield INSERTED, _cut(edit.text)
        at = max(at, edit.span.end)
    rest = source.text[at : _line_end(source, at)]
    yield KEPT, rest if len(rest) <= _AROUND else f"{rest[:_AROUND]}…"


def _between(text: str, *, is_first: bool) -> str:
    """Unchanged text before a change; the first one has no other change before it."""
    if is_first:
        return text if len(text) <= _AROUND else f"…{text[-_AROUND:]}"
    return text if len(text) <= 2 * _AROUND else f"{text[:_AROUND]}…{text[-_AROUND:]}"


def _cut(text: str) -> str:
    return text if len(text) <= _LONGEST else f"{text[:_LONGEST]}…"


def _shown(text: str) -> str:
    return harmless_document(text.replace("\r\n", "\n"))


def _line_end(source: Source, offset: int) -> int:
    """Where the line of an offset ends, its line end left out."""
    ends = [found for mark in "\r\n" if (found := source.text.find(mark, offset)) >= 0]
    return min(ends, default=len(source.text))


# The content.

Json = dict[str, Any]

MOST_FRAMES = 5000
"""So many findings are shown with their lines of code; those after them with their places only."""
WHOLE = View(Severity.INFO, folds=True)
"""Files that are not found on this computer are apart from the rest, as in the report for people."""


class Content:
    """The findings of a run, with what many of them have in common named once."""

    def __init__(self, run: Run, paths: Paths) -> None:
        self._run = run
        self._paths = paths
        self._files: dict[Path, int] = {}
        self._rules: dict[str, int] = {}
        self._reactions: dict[tuple[Any, ...], int] = {(): 0}

    def as_json(self) -> Json:
        """The whole content; texts are as people may see them, and numbers refer to lists."""
        run = self._run
        findings = [self._finding(each, number) for number, each in enumerate(run.diagnostics)]
        return {
            "version": __version__,
            "closing": closing_line(run, WHOLE),
            "files": len(run.files),
            "fixed": run.fixed,
            "suppressed": run.suppressed,
            "frames": MOST_FRAMES,
            "findings": findings,
            "places": [visible(self._paths(path)) for path in self._files],
            "rules": self._facts(),
            "reactions": [self._reaction(each) for each in self._reactions],
            "sections": [
                {
                    "heading": section.heading,
                    "fixable": section.is_fixable,
                    "rows": [self._row(row) for row in section.rows],
                }
                for section in sections(run, WHOLE)
            ],
            "missing": list(not_found(WHOLE.missing(run), self._paths, painter(False))),
            "skipped": [
                {"file": visible(self._paths(path)), "reason": visible(reason)}
                for path, reason in sorted(run.skipped)
            ],
        }

    def _finding(self, found: Diagnostic, number: int) -> Json:
        line, column = found.span.begin
        always: Json = {
            "rule": self._rules.setdefault(found.code, len(self._rules)),
            "severity": found.severity.value,
            "file": self._files.setdefault(found.span.source.path, len(self._files)),
            "line": line,
            "column": column,
            "message": visible(found.message),
        }
        # Most findings have few of these, and there may be many findings.
        rarely: Json = {
            "frames": list(self._frames(found)) if number < MOST_FRAMES else None,
            "fix": self._fix(found.fix) if found.fix is not None else None,
            "help": visible(found.help) if found.help else "",
            "origins": [f"{visible(at.text)}: {visible(self._paths.place(at.span))}" for at in found.origins],
            "missing": found.missing is not None,
            "affects": self._reactions.setdefault(found.affects, len(self._reactions)),
        }
        return always | {key: value for key, value in rarely.items() if value}

    def _frames(self, found: Diagnostic) -> Iterator[Json]:
        """Lines of code as the text report has them, colors included; those of other files with their place."""
        frames = list(marks_by_file(found))
        gutter = len(str(max(mark.span.begin.line for marks in frames for mark in marks)))
        for number, marks in enumerate(frames):
            # The empty line at the top separates code from a heading, which is absent here.
            lines = list(frame(marks, gutter, painter(True), INK_OF[found.severity]))[1:]
            place = visible(self._paths.place(first_of(marks).span)) if number else ""
            yield {"place": place, "text": "\n".join(lines)}

    @staticmethod
    def _fix(fix: Fix) -> Json:
        return {
            "title": visible(fix.title),
            "safe": fix.is_safe,
            "hunks": [{"line": hunk.line, "pieces": hunk.pieces} for hunk in hunks(fix)],
        }

    def _facts(self) -> list[Json]:
        known = {facts.code: facts for facts in self._run.rules}
        names = {each.code: each.name for each in self._run.diagnostics}
        return [
            {
                "code": code,
                "name": visible(names[code]),
                "summary": visible(known[code].summary) if code in known else "",
                "page": known[code].page if code in known else None,
                "remedy": "\n".join(map(visible, known[code].remedy.splitlines())) if code in known else "",
            }
            for code in self._rules
        ]

    @staticmethod
    def _reaction(affects: tuple[Any, ...]) -> list[Json]:
        return [
            {"consumer": Consumer(name).title, "verdict": reaction.verdict.value, "words": reaction.words}
            for name, reaction in affects
        ]

    def _row(self, row: Row) -> Json:
        """A rule, and how many of its findings are in a section."""
        return {
            "rule": self._rules[row.first.code],
            "severity": row.first.severity.value,
            "count": len(row.found),
            "files": len({each.span.source.path for each in row.found}),
        }


# The robots of a run, as the HTML report embeds them.

_BYTES = 10_000_000
"""Of the scenes in a report, meshes included; what does not fit is left out."""
_FINDINGS = 200
"""The findings listed beside a robot, at most."""
TITLE = "\ue000"
"""A substitute for the file's name in the page of a robot; names cannot hold it, as it cannot be shown."""


class Robot(NamedTuple):
    """A file of a run: ``page`` is what `sdfcheck view` writes, with TITLE as its title.

    Empty where the robot is not shown; ``reason`` is why.
    """

    path: Path
    page: str = ""
    reason: str = ""


def robots(run: Run, documents: Iterable[tuple[Path, Document | str]]) -> Iterator[Robot]:
    """The robots of descriptions, with the findings of a run; a text in place of a document says why it is missing."""
    left = _BYTES
    for path, document in documents:
        if isinstance(document, str):
            yield Robot(path, reason=document)
            continue
        meshes = Meshes(all=left // 2)
        drawn = scene(document, meshes)
        if not any(model["links"] for model in drawn["models"]):
            yield Robot(path, reason="; ".join(drawn["notes"]) or "it has no links")
            continue
        found = findings(_gravest(run, path), document, run.pages)
        text = page(TITLE, [drawn], meshes.entries, findings=found)
        size = len(split(text)[1])
        if size <= left:
            left -= size
            yield Robot(path, text)
        else:
            yield Robot(path, reason="too large for this page; `sdfcheck view` shows it")


def _gravest(run: Run, path: Path) -> tuple[Diagnostic, ...]:
    """The findings about a file that are listed beside its robot; the report has all of them."""
    found = [each for each in run.diagnostics if _is_in(each, path)]
    return tuple(sorted(found, key=lambda each: -each.severity.rank)[:_FINDINGS])


def _is_in(found: Diagnostic, path: Path) -> bool:
    """Whether a finding is in a file, or in what that includes or calls."""
    return any(span.source.path == path for span in (found.span, *(origin.span for origin in found.origins)))

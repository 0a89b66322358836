"""A summary in Markdown, as GitHub shows it for a job: what to do first, consumers, and the gravest findings."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Sequence
from html import escape
from pathlib import Path

from sdfcheck.consumers.reaction import Consumer
from sdfcheck.lint.diagnostic import Diagnostic, Severity, counted
from sdfcheck.lint.run import Run
from sdfcheck.report.colors import painter
from sdfcheck.report.digest import Section, digest, files_of, gravest_first, not_found, sections
from sdfcheck.report.paths import Paths
from sdfcheck.report.summary import View, closing_line
from sdfcheck.source.visible import visible

_VIEW = View(Severity.INFO, folds=True)
_ROWS = 20
"""So many rules are listed under a heading."""
_FINDINGS = 100
_LONGEST = 300
"""Characters of a text that are shown: GitHub takes 1 MiB for a step."""
_SPECIAL = re.compile(r"[\\`*_{}\[\]#!|~$]")
_CODE = re.compile(r"`([^`]*)`")


def render(run: Run) -> str:
    paths = Paths("GITHUB_WORKSPACE")
    lines = ["## sdfcheck", "", _text(closing_line(run, _VIEW))]
    for section in sections(run, _VIEW):
        lines += _section(section, run, paths)
    lines += _consumers(run.diagnostics)
    lines += _findings(run, paths)
    missing = list(not_found(_VIEW.missing(run), paths, painter(False)))
    if missing:
        lines += _folded("Not found", ["<pre>", *(escape(line) for line in missing), "</pre>"])
    return "\n".join(lines) + "\n"


def _section(section: Section, run: Run, paths: Paths) -> Iterator[str]:
    pages = run.pages
    yield from ("", f"### {_text(section.heading)}", "")
    rows = [
        (
            str(len(row.found)),
            _rule(row.first, pages.get(row.first.code)),
            str(len(files_of(row.found))),
            _code(paths.place(row.first.span)),
        )
        for row in section.rows
    ]
    yield from _table(("Findings", "Rule", "Files", "First"), rows[:_ROWS])
    if len(rows) > _ROWS:
        yield from ("", f"And {counted(len(rows) - _ROWS, 'other rule')}.")


def _consumers(diagnostics: Iterable[Diagnostic]) -> Iterator[str]:
    concerned: dict[str, int] = {}
    refused: dict[str, set[Path]] = {}
    for each in diagnostics:
        for name, reaction in each.affects:
            if not reaction.is_harmless:
                concerned[name] = concerned.get(name, 0) + 1
                files = refused.setdefault(name, set())
                files |= {each.span.source.path} if reaction.is_refusal else set()
    if not concerned:
        return
    yield from ("", "### Consumers", "")
    rows = [
        (Consumer(name).title, str(number), str(len(refused[name])))
        for name, number in sorted(concerned.items())
    ]
    yield from _table(("Consumer", "Findings", "Files that it refuses"), rows)


def _findings(run: Run, paths: Paths) -> Iterator[str]:
    groups = gravest_first(digest(run, _VIEW))
    if not groups:
        return
    pages = run.pages
    rows = []
    for group in groups[:_FINDINGS]:
        first = group.first
        message = _text(first.message) + (f" (and {len(group.others)} more)" if group.others else "")
        severity = first.severity.value
        rows.append((severity, message, _code(paths.place(first.span)), _rule(first, pages.get(first.code))))
    lines = list(_table(("", "Message", "Place", "Rule"), rows))
    if len(groups) > _FINDINGS:
        lines += ["", f"{counted(len(groups) - _FINDINGS, 'other finding')} not shown."]
    yield from _folded("Findings", lines)


def _folded(title: str, lines: Iterable[str]) -> Iterator[str]:
    yield from ("", "<details>", f"<summary>{title}</summary>", "", *lines, "", "</details>")


def _table(heads: Sequence[str], rows: Iterable[Sequence[str]]) -> Iterator[str]:
    """Columns named `Findings` and `Files…` hold numbers."""
    yield f"| {' | '.join(heads)} |"
    yield "|" + "|".join("---:" if head.startswith(("Findings", "Files")) else "---" for head in heads) + "|"
    for row in rows:
        yield f"| {' | '.join(row)} |"


def _rule(found: Diagnostic, page: str | None) -> str:
    name = _text(f"{found.code} {found.name}")
    return f"[{name}]({page})" if page else name


def _text(text: str) -> str:
    """One line, in which only `` `code` `` is markup."""
    pieces = _CODE.split(_shown(text))
    return "".join(_code(piece) if at % 2 else _escaped(piece) for at, piece in enumerate(pieces))


def _code(text: str) -> str:
    shown = _shown(text)
    is_plain = shown.strip() == shown != "" and not {"`", "|"} & set(shown)
    return f"`{shown}`" if is_plain else f"<code>{_escaped(shown)}</code>"


def _shown(text: str) -> str:
    shown = visible(text)
    return shown if len(shown) <= _LONGEST else f"{shown[:_LONGEST]}…"


def _escaped(text: str) -> str:
    return _SPECIAL.sub(r"\\\g<0>", escape(text, quote=False))

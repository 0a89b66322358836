"""The report that people read: each diagnostic with its lines of code."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from sdfcheck.lint.run import Run
from sdfcheck.report.summary import EVERYTHING, View, closing_line

if TYPE_CHECKING:
    from sdfcheck.report.digest import Group

_LINES = 110
"""A folded report with more lines of findings begins with an overview, and is cut off here."""


def render(run: Run, *, color: bool = False, view: View = EVERYTHING) -> str:
    text = "\n\n".join([*_blocks(run, view, color), closing_line(run, view)]) + "\n"
    if view.width is None:
        return text
    from sdfcheck.report.table import fitted

    return fitted(text, view.width)


def _blocks(run: Run, view: View, color: bool) -> Iterator[str]:
    if not run.diagnostics:
        return  # most runs: load nothing more
    from sdfcheck.report.colors import painter
    from sdfcheck.report.digest import digest, gravest_first
    from sdfcheck.report.paths import Paths

    paint, paths = painter(color), Paths()
    known = {facts.code for facts in run.rules}
    shown = digest(run, view)

    def blocks(groups: Iterator[Group]) -> Iterator[str]:
        from sdfcheck.report.digest import others_of
        from sdfcheck.report.frame import Style, block

        style = Style(paths, paint, view.width)
        for group in groups:
            first = group.first
            page = run.pages.get(first.code) if view.links else None
            others = others_of(group, paths)
            yield "\n".join(block(first, first.code in known, style, others, page))

    room = _LINES if view.folds and view.most is None else None
    found = _first(blocks(iter(shown)), room, view.most)
    if len(found) < len(shown):
        from sdfcheck.report.digest import overview

        yield "\n".join(overview(run, view, paths, paint))
        grave = gravest_first(shown)
        found = _first(blocks(iter(grave)), room, view.most)
        left = len(grave) - len(found)
        found.append(f"{left} more not shown: see them with --no-fold, or one rule with --select CODE.")
    yield from found
    if missing := view.missing(run):
        from sdfcheck.report.digest import not_found

        yield "\n".join(not_found(missing, paths, paint))


def _first(blocks: Iterator[str], room: int | None, most: int | None) -> list[str]:
    """As many blocks as there is room for, in lines and in number."""
    found: list[str] = []
    lines = 0
    for block in blocks:
        lines += block.count("\n") + 2
        if (room is not None and lines > room) or len(found) == most:
            break
        found.append(block)
    return found

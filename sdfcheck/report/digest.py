"""Repeated findings folded: what is between the diagnostics of a run and the report for people."""

from __future__ import annotations

import re
from collections.abc import Iterable, Sequence
from pathlib import Path

from sdfcheck.lint.diagnostic import Diagnostic, Severity
from sdfcheck.lint.run import Run
from sdfcheck.lint.wording import counted
from sdfcheck.report.paths import Paths
from sdfcheck.report.summary import View
from sdfcheck.source.record import NamedTuple

_ALONE = 3
"""So many findings of one shape are shown one by one."""
_PLACES = {True: 8, False: 3}
"""So many places of folded findings are named, if they are all in the same file and otherwise."""
_VARIED = re.compile(r"`[^`]*`|\d+(?:\.\d+)?")


class Group(NamedTuple):
    """A finding, and those of the same shape that are not shown."""

    first: Diagnostic
    others: tuple[Diagnostic, ...] = ()

    @property
    def size(self) -> int:
        return 1 + len(self.others)


def digest(run: Run, view: View) -> list[Group]:
    """The part of a run that a view shows, in the order of place."""
    shown = view.shown(run)
    return folded(shown) if view.folds else list(map(Group, shown))


def folded(diagnostics: Iterable[Diagnostic]) -> list[Group]:
    """Those of one rule whose messages differ in names and numbers only make a group, if they are many."""
    by_shape: dict[tuple[str, Severity, str], list[Diagnostic]] = {}
    for each in diagnostics:
        by_shape.setdefault((each.code, each.severity, _VARIED.sub("", each.message)), []).append(each)
    groups: list[Group] = []
    for alike in by_shape.values():
        if len(alike) <= _ALONE:
            groups += map(Group, alike)
        else:
            groups.append(Group(alike[0], tuple(alike[1:])))
    return sorted(groups, key=lambda group: group.first.sort_key)


def others_of(group: Group, paths: Paths) -> str:
    """``207 more in 12 files: a.sdf:1:2, …``; empty if there are none."""
    if not group.others:
        return ""
    files = {each.span.source.path for each in group.others}
    here = files == {group.first.span.source.path}
    where = "in this file" if here else f"in {counted(len(files), 'file')}"
    places = [_place(group, each, paths, here) for each in group.others[: _PLACES[here]]]
    left = ", …" if len(group.others) > len(places) else ""
    return f"{len(group.others)} more {where}: {', '.join(places)}{left}"


def _place(group: Group, each: Diagnostic, paths: Paths, here: bool) -> str:
    line, column = each.span.begin
    place = f"{line}:{column}" if here else paths.place(each.span)
    if each.message == group.first.message:
        return place
    # Of messages that differ the first thing that differs says what is meant.
    pairs = zip(_VARIED.findall(group.first.message), _VARIED.findall(each.message), strict=False)
    word = next((new for old, new in pairs if old != new), "")
    return f"{place} {word}".rstrip()


def gravest_first(groups: Sequence[Group]) -> list[Group]:
    """Errors before warnings; among equals the frequent ones first."""
    return sorted(groups, key=lambda group: (-group.first.severity.rank, -group.size, group.first.sort_key))


def files_of(diagnostics: Iterable[Diagnostic]) -> set[Path]:
    return {each.span.source.path for each in diagnostics}

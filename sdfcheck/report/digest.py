"""The findings of a large run: repeated ones folded, and counted by rule in the order in which to take them on."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Sequence
from itertools import chain
from pathlib import Path

from sdfcheck.lint.diagnostic import Diagnostic, Missing, MissingKind, Severity, counted, named
from sdfcheck.lint.run import Run
from sdfcheck.report.colors import INK_OF, Ink, Paint
from sdfcheck.report.paths import Paths
from sdfcheck.report.summary import EVERYTHING, View, closing_line
from sdfcheck.report.table import Cell, Column, fitted, table
from sdfcheck.source.record import NamedTuple
from sdfcheck.source.visible import visible

_ALONE = 3
"""So many findings of one shape are shown one by one."""
_PLACES = {True: 8, False: 3}
"""So many places of folded findings are named, if they are all in the same file and otherwise."""
_LONG = 40
"""Characters of what is said with such a place."""
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
    return grouped(shown) if view.folds else list(map(Group, shown))


def grouped(diagnostics: Iterable[Diagnostic]) -> list[Group]:
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
    # Of messages that differ the first name that differs says what is meant; a number alone says nothing.
    pairs = zip(_VARIED.findall(group.first.message), _VARIED.findall(each.message), strict=False)
    word = next((new for old, new in pairs if old != new and new[0] == "`"), "")
    if len(word) > _LONG:  # a path, most likely: its end tells it from others
        tail = word[-_LONG:]
        word = "`…" + tail[max(0, tail.find("/")) :]
    return f"{place} {word}".rstrip()


def gravest_first(groups: Sequence[Group]) -> list[Group]:
    """Errors before warnings; among equals the frequent ones first."""
    return sorted(groups, key=lambda group: (-group.first.severity.rank, -group.size, group.first.sort_key))


def files_of(diagnostics: Iterable[Diagnostic]) -> set[Path]:
    return {each.span.source.path for each in diagnostics}


# Findings about this computer, together: what was not found, and what to set.

STANDARD_MODELS = frozenset({"ground_plane", "sun"})
"""Models without a robot in them that most worlds include, and most computers have."""


_SHOWN = {
    MissingKind.PACKAGE: 8,
    MissingKind.MODEL: 8,
    MissingKind.REMOTE: 3,
    MissingKind.LFS: 3,
    MissingKind.SUBMODULE: 8,
    MissingKind.IGNORED: 3,
    MissingKind.BUILT: 3,
}
_SETTINGS = {
    MissingKind.PACKAGE: (
        "set ROS_PACKAGE_PATH or AMENT_PREFIX_PATH, or give --package-path FOLDER or --package NAME=PATH"
    ),
    MissingKind.MODEL: "set GZ_SIM_RESOURCE_PATH or GAZEBO_MODEL_PATH, or give --model-path FOLDER",
    MissingKind.REMOTE: "nothing is fetched from the network: download them, and give --model-path FOLDER",
    MissingKind.LFS: "only pointers to them are here: fetch them with `git lfs pull`",
    MissingKind.SUBMODULE: "their folders are empty: fetch them with `git submodule update --init`",
    MissingKind.IGNORED: "git ignores them: run the build or the download that brings them",
    MissingKind.BUILT: "the build of their package makes them: run it",
}


def not_found(diagnostics: Iterable[Diagnostic], paths: Paths, paint: Paint) -> Iterator[str]:
    """The lines of the block; none if nothing is missing."""
    by_kind: dict[MissingKind, dict[str, list[Diagnostic]]] = {}
    for each in diagnostics:
        if each.missing is not None:
            by_kind.setdefault(each.missing.kind, {}).setdefault(each.missing.name, []).append(each)
    if not by_kind:
        return
    yield paint("Not found on this computer, so not checked:", Ink.STRONG)
    for kind in MissingKind:
        lacking = by_kind.get(kind, {})
        standard = {name: lacking.pop(name) for name in sorted(STANDARD_MODELS & lacking.keys())}
        standard = standard if kind is MissingKind.MODEL else {}
        if lacking:
            yield from _kind(kind, lacking, paths)
        if standard:
            number = counted(len(standard), "standard model")
            yield f"  {number} of Gazebo ({_uses(standard)}): {named(standard)}"
            yield "      Gazebo Classic has them in /usr/share/gazebo-11/models, newer versions fetch them from Fuel"


def _kind(kind: MissingKind, lacking: dict[str, list[Diagnostic]], paths: Paths) -> Iterator[str]:
    noun = "addresses on the network" if kind is MissingKind.REMOTE and len(lacking) > 1 else ""
    number = f"{len(lacking)} {noun}" if noun else counted(len(lacking), kind.value)
    often = sorted(lacking, key=lambda name: (-_count(lacking[name]), name))
    first = min(chain.from_iterable(lacking.values()), key=lambda each: each.sort_key)
    yield f"  {number} ({_uses(lacking)}): {visible(named(often, most=_SHOWN[kind]))}"
    yield f"      first needed at {visible(paths.place(first.span))}"
    yield f"      {_SETTINGS[kind]}"


def _uses(lacking: dict[str, list[Diagnostic]]) -> str:
    return f"needed {counted(sum(map(_count, lacking.values())), 'time')}"


def _count(diagnostics: Sequence[Diagnostic]) -> int:
    return sum(each.missing.uses for each in diagnostics if isinstance(each.missing, Missing))


# The first screen of a large run: its findings by rule, in the order in which to take them on.


_ROWS = 20
"""So many rules are listed under a heading."""


_FIXABLE = "Fix first: `sdfcheck lint --fix` corrects these without changing a robot"
_HEADINGS = {
    Severity.ERROR: "Errors: a simulator refuses the file, or builds another robot",
    Severity.WARNING: "Warnings: very likely not what is meant",
    Severity.INFO: "Infos",
}


class Row(NamedTuple):
    """The findings of a rule."""

    found: list[Diagnostic]

    @property
    def first(self) -> Diagnostic:
        return self.found[0]


class Section(NamedTuple):
    """Rules that are taken on together, the most frequent first."""

    heading: str
    rows: list[Row]
    is_fixable: bool
    """Whether `sdfcheck lint --fix` fixes these findings."""


def sections(run: Run, view: View) -> Iterator[Section]:
    """Fixable findings first, then errors, then warnings, then infos; those without findings are left out."""
    shown = view.shown(run)
    fixable = [each for each in shown if _is_fixable(each)]
    others = [each for each in shown if not _is_fixable(each)]
    if fixable:
        yield Section(_FIXABLE, _rows(fixable), is_fixable=True)
    for severity, heading in _HEADINGS.items():
        found = [each for each in others if each.severity is severity]
        if found:
            yield Section(heading, _rows(found), is_fixable=False)


def _is_fixable(diagnostic: Diagnostic) -> bool:
    return diagnostic.fix is not None and diagnostic.fix.is_safe


def _rows(found: Sequence[Diagnostic]) -> list[Row]:
    by_code: dict[str, list[Diagnostic]] = {}
    for each in found:
        by_code.setdefault(each.code, []).append(each)
    return sorted(map(Row, by_code.values()), key=lambda row: (-len(row.found), row.first.code))


def overview(run: Run, view: View, paths: Paths, paint: Paint) -> Iterator[str]:
    """The sections as text; what is not shown is counted."""
    apart = view.singles(run)
    yield paint(
        f"{counted(len(apart), 'finding')} in {counted(len(files_of(apart)), 'file')}, by rule", Ink.STRONG
    )
    for section in sections(run, view):
        yield from _section(section, paths, paint)
    hidden = [each for each in apart if not each.severity >= view.least]
    if hidden:
        codes = sorted({each.code for each in hidden})
        fixable = sum(map(_is_fixable, hidden))
        fixed = f"; `--fix` corrects {fixable} of them" if fixable else ""
        yield ""
        yield (
            f"{counted(len(hidden), 'info')} of {counted(len(codes), 'rule')}: not shown, and rarely urgent{fixed}"
        )


def _section(section: Section, paths: Paths, paint: Paint) -> Iterator[str]:
    rows = section.rows
    digits = max(len(str(len(row.found))) for row in rows)
    width = max(len(f"{row.first.code} {row.first.name}") for row in rows[:_ROWS])
    yield ""
    yield paint(section.heading, Ink.STRONG)
    for row in rows[:_ROWS]:
        first = row.first
        rule = paint(f"{first.code} {first.name:{width - len(first.code) - 1}}", INK_OF[first.severity])
        files = counted(len(files_of(row.found)), "file")
        yield f"  {len(row.found):>{digits}}  {rule}  in {files}, first at {visible(paths.place(first.span))}"
    if len(rows) > _ROWS:
        rest = sum(len(row.found) for row in rows[_ROWS:])
        yield f"  {rest:>{digits}}  of {counted(len(rows) - _ROWS, 'other rule')}"


# How many findings each rule has: the report of ``--statistics``.


def render(run: Run, *, color: bool = False, view: View = EVERYTHING) -> str:
    """Counts by rule and severity, the most frequent first, with the kind of fix, of what the view shows.

    Models and packages that were not found on this computer have a line of their own.
    """
    closing = fitted(closing_line(run, view), view.width) + "\n"
    if not run.diagnostics:
        return closing

    groups: dict[tuple[str, Severity], list[Diagnostic]] = {}
    for diagnostic in view.shown(run):
        groups.setdefault((diagnostic.code, diagnostic.severity), []).append(diagnostic)
    rows = []
    for (code, severity), found in sorted(groups.items(), key=_most_frequent):
        words = (str(len(found)), severity.value, code, found[0].name, _fix(found))
        row = [Cell(word) for word in words]
        row[1] = row[1]._replace(ink=INK_OF[severity])
        row[2] = row[2]._replace(address=run.pages.get(code) if view.links else None)
        rows.append(row)
    columns = (
        Column("count", is_number=True),
        Column("severity"),
        Column("rule"),
        Column("name", gives_way=True),
        Column("fix"),
    )
    lines = [*table(columns, rows, width=view.width, color=color), ""] if rows else []
    if missing := view.missing(run):
        needed = counted(_count(missing), "time")
        lines.append(fitted(f"Not found on this computer, and so not checked: needed {needed}.", view.width))
    return "\n".join([*lines, closing])


def _most_frequent(group: tuple[tuple[str, Severity], list[Diagnostic]]) -> tuple[int, str, int]:
    (code, severity), found = group
    return -len(found), code, -severity.rank


def _fix(found: list[Diagnostic]) -> str:
    fixes = [diagnostic.fix for diagnostic in found if diagnostic.fix is not None]
    if not fixes:
        return ""
    return "safe fix" if any(fix.is_safe for fix in fixes) else "unsafe fix"

"""Findings about this computer, together: what was not found, and what to set."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from itertools import chain

from sdfcheck.lint.diagnostic import Diagnostic, Missing, MissingKind
from sdfcheck.lint.wording import counted, named
from sdfcheck.report.colors import Ink, Paint
from sdfcheck.report.paths import Paths
from sdfcheck.source.visible import visible

STANDARD_MODELS = frozenset({"ground_plane", "sun"})
"""Models without a robot in them that most worlds include, and most computers have."""


_SHOWN = {MissingKind.PACKAGE: 8, MissingKind.MODEL: 8, MissingKind.REMOTE: 3}
_SETTINGS = {
    MissingKind.PACKAGE: (
        "set ROS_PACKAGE_PATH or AMENT_PREFIX_PATH, or give --package-path FOLDER or --package NAME=PATH"
    ),
    MissingKind.MODEL: "set GZ_SIM_RESOURCE_PATH or GAZEBO_MODEL_PATH, or give --model-path FOLDER",
    MissingKind.REMOTE: "nothing is fetched from the network: download them, and give --model-path FOLDER",
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

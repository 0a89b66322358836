"""The purpose of elements and attributes, from data/descriptions.txt; read when it is asked for."""

from __future__ import annotations

from collections.abc import Sequence
from functools import cache
from pathlib import Path

_FILE = Path(__file__).parents[1] / "data" / "descriptions.txt"


def summary(dialect: str, names: Sequence[str]) -> str:
    """The purpose of the place at the end of a path of names, in one or two sentences; empty if unknown.

    ``dialect`` is ``sdf``, ``urdf``, ``drake`` or ``ros2_control``; the last name is an
    attribute's if it begins with ``@``.
    """
    known = _texts().get(dialect, {})
    last = names[-1]
    for number in range(max(0, len(names) - 3), len(names) - 1):
        text = known.get(f"{'/'.join(names[number:])}")
        if text is not None:
            return text
    return known.get(last, "")


@cache
def _texts() -> dict[str, dict[str, str]]:
    found: dict[str, dict[str, str]] = {}
    block: dict[str, str] = {}
    for line in _FILE.read_text("utf-8").splitlines():
        if line.startswith("["):
            block = found.setdefault(line.strip("[]"), {})
        elif line and not line.startswith("#"):
            places, _, text = line.partition("\t")
            block.update((place.strip(), text) for place in places.split(","))
    return found

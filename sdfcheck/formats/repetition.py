"""A mistake that is made again and again is reported once."""

from __future__ import annotations

from collections import Counter
from collections.abc import Hashable

from sdfcheck.formats.sdf.problems import RemovedElement, RepeatedElement, UnknownAttribute
from sdfcheck.source.document import Element

MOST = 10
"""So many unknown attributes of one element are reported one by one."""


def folded(found: list[object]) -> list[object]:
    """The problems, with one for all repeats of an element, and one for all uses of a removed name."""
    alike: dict[Hashable, list[Element]] = {}
    first_of_kind: list[object] = []
    for problem in found:
        if (kind := _kind(problem)) is None:
            first_of_kind.append(problem)
            continue
        assert isinstance(problem, RepeatedElement | RemovedElement)
        if kind not in alike:
            first_of_kind.append(problem)
        alike.setdefault(kind, []).append(problem.element)
    return [_with_others(problem, alike) for problem in first_of_kind]


def counted(found: list[object], strange: Counter[Element]) -> list[object]:
    """The problems; where an element has too many unknown attributes, its first says how many there are."""
    reported: set[Element] = set()
    result = []
    for problem in found:
        if isinstance(problem, UnknownAttribute) and strange[problem.element] > MOST:
            element = problem.element
            more = 0 if element in reported else strange[element] - 1
            reported.add(element)
            problem = problem.changed(more=more)  # noqa: PLW2901
        result.append(problem)
    return result


def _kind(problem: object) -> Hashable:
    """The common part of like problems; None for one that is reported alone."""
    if isinstance(problem, RepeatedElement) and not problem.refused:
        return problem.first
    if isinstance(problem, RemovedElement):
        return problem.element.name, problem.parent.name, problem.attribute
    return None


def _with_others(problem: object, alike: dict[Hashable, list[Element]]) -> object:
    kind = _kind(problem)
    others = tuple(alike[kind][1:]) if kind is not None else ()
    if others and isinstance(problem, RepeatedElement | RemovedElement):
        return problem.changed(others=others)
    return problem

"""A mistake that is made again and again is told once."""

from __future__ import annotations

from collections.abc import Hashable

from sdfcheck.formats.problems import RemovedElement, RepeatedElement
from sdfcheck.source.element import Element


def folded(found: list[object]) -> list[object]:
    """The problems, in which one stands for all repeats of an element, and for all uses of what is gone."""
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


def _kind(problem: object) -> Hashable:
    """What alike problems have in common; None for one that stands for itself."""
    if isinstance(problem, RepeatedElement) and not problem.refused:
        return problem.first
    if isinstance(problem, RemovedElement):
        return problem.element.name, problem.parent.name, problem.attribute
    return None


def _with_others(problem: object, alike: dict[Hashable, list[Element]]) -> object:
    kind = _kind(problem)
    others = tuple(alike[kind][1:]) if kind is not None else ()
    if others and isinstance(problem, RepeatedElement):
        return RepeatedElement(problem.element, problem.first, problem.parent, others=others)
    if others and isinstance(problem, RemovedElement):
        return RemovedElement(
            problem.element, problem.parent, problem.attribute, problem.until, problem.successor, others
        )
    return problem

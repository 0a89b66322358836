"""Elements and attributes that Drake passes over."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from sdfcheck.consumers.drake_limits import Ignored, ignored
from sdfcheck.consumers.drake_problems import IgnoredByDrake
from sdfcheck.formats.sdf.values import number
from sdfcheck.source.element import Element, Value


def ignored_parts(index: Mapping[str, list[Element]], dialect: str) -> Iterator[IgnoredByDrake]:
    """What is passed over, told once for each kind, at its first use; ``index`` as of the survey."""
    for entry in ignored(dialect):
        uses = list(_uses(index, entry))
        if uses:
            yield IgnoredByDrake(uses[0], "/".join(reversed(entry.parents)), entry.warned, len(uses))


def _uses(index: Mapping[str, list[Element]], entry: Ignored) -> Iterator[Element | Value]:
    for parent in index.get(entry.parents[0], ()):
        if not _stands_in(parent, entry.parents[1:]):
            continue
        if entry.name[0] == "@":
            value = parent.attribute(entry.name[1:])
            if value is not None and not _is(value.text, entry.unless):
                yield value
            continue
        for child in parent.children(entry.name):
            if not entry.unless or not _is(child.content, entry.unless):
                yield child


def _stands_in(element: Element, parents: tuple[str, ...]) -> bool:
    at = element.parent
    for name in parents:
        if at is None or at.name != name:
            return False
        at = at.parent
    return True


def _is(text: str, value: str) -> bool:
    """Is it that value, in whichever spelling?"""
    word = text.strip().lower()
    if value in {"true", "false"}:
        return word in {value, "1" if value == "true" else "0"}
    return bool(value) and (word == value or number(word) == number(value))

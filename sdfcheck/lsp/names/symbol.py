"""Symbols: what has a name in a description, and the places where the name is written."""

from __future__ import annotations

from sdfcheck.source.element import Value
from sdfcheck.source.record import NamedTuple
from sdfcheck.source.text import Span


class Symbol(NamedTuple):
    """Something with a name; ``span`` is where it gets it, which distinguishes it from others of that name."""

    kind: str
    """``link``, ``joint``, ``frame``, ``model``, ``world``, ``material``, ``macro``, ``property``, …"""
    name: str
    span: Span

    @property
    def key(self) -> tuple[str, int]:
        """The identity of a symbol, the same however often its file is read."""
        return self.span.source.real_path, self.span.start


class Occurrence(NamedTuple):
    """A place where the name of a symbol is written.

    ``before`` and ``after`` is what the place holds around the name, where that cannot be taken apart.
    """

    span: Span
    symbol: Symbol
    is_definition: bool = False
    before: str = ""
    after: str = ""


def steps(value: Value) -> list[tuple[Span, str, str]]:
    """The parts of a scoped name: the place of each, and what comes before and after it in the place."""
    span, text = value.span, value.text.strip()
    names = text.split("::")
    if span.text.strip() != text:  # written with entities
        return [
            (
                span,
                "".join(f"{each}::" for each in names[:n]),
                "".join(f"::{each}" for each in names[n + 1 :]),
            )
            for n in range(len(names))
        ]
    start = span.start + len(span.text) - len(span.text.lstrip())
    found = []
    for name in names:
        found.append((span.source.span(start, start + len(name)), "", ""))
        start += len(name) + 2
    return found

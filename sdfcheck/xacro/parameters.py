"""The parameters of a macro, as xacro takes ``params`` apart.

xacro's regular expression tries every way to part a default into quoted and bare pieces,
which takes for ever where a quote is left over. Here each offset is decided once.
"""

from __future__ import annotations

import re
from collections.abc import Iterator

from sdfcheck.source.record import NamedTuple

_HEAD = re.compile(r"\s*([^\s:=]+)\s*:?=")
_BLANKS = re.compile(r"\s*")
_PLAIN = re.compile(r"\s*(\S+)")


class Parameter(NamedTuple):
    """A parameter of a macro, as ``params`` spells it: ``*name`` and ``**name`` take blocks.

    ``start`` and ``end`` are the name's place in the text. ``forwards``: the caller's
    property of that name replaces it.
    """

    name: str
    start: int
    end: int
    default: str | None
    forwards: bool

    @property
    def is_block(self) -> bool:
        return self.name.startswith("*")

    @property
    def is_optional(self) -> bool:
        return self.default is not None or self.forwards


def parameters(text: str) -> Iterator[Parameter]:
    """The parameters in a ``params`` attribute."""
    return (parameter for parameter, _ in Parameters(text).after(0))


class Parameters:
    """A ``params`` attribute, and where the defaults in it may end."""

    __slots__ = ("_closing", "_ends", "text")

    def __init__(self, text: str) -> None:
        self.text = text
        self._ends: list[int] = []
        self._closing: dict[str, list[int]] = {}
        if "=" in text:
            self._decide()

    def after(self, at: int) -> Iterator[tuple[Parameter, int]]:
        """The parameters from an offset on, each with where the next one begins."""
        while match := _PLAIN.match(self.text, at):
            found = self._with_default(at)
            if found is None:
                found = Parameter(match[1], match.start(1), match.end(1), None, False), match.end()
            yield found
            at = found[1]

    def _with_default(self, at: int) -> tuple[Parameter, int] | None:
        head = _HEAD.match(self.text, at)
        if head is None:
            return None
        begin = self._skip(head.end())
        marks = [mark for mark in ("^|", "^", "") if self.text.startswith(mark, begin)]
        for mark in marks:
            start = begin + len(mark)
            end = self._end(start)
            if end >= 0:
                default = self.text[start:end] or None
                return Parameter(head[1], *head.span(1), default, bool(mark)), self._skip(end)
        # The text after the spaces is not a default, so the parameter has none.
        return (Parameter(head[1], *head.span(1), None, False), begin) if begin > head.end() else None

    def _end(self, at: int) -> int:
        """The end of the default that begins at an offset; -1 if none does."""
        for opening, mark in (("${", "}"), ("$(", ")")):
            if self.text.startswith(opening, at) and self._closing[mark][at + 2] >= 0:
                return self._closing[mark][at + 2]
        return self._ends[at] if self._ends[at] >= 0 or not self._is_over(at) else at

    def _decide(self) -> None:
        """From the end on: where the pieces that begin at an offset end, and the next mark that ends a default."""
        text, size = self.text, len(self.text)
        ends = self._ends = [-1] * (size + 2)
        quoted = {quote: [-1] * (size + 2) for quote in "'\""}
        closing = self._closing = {mark: [-1] * (size + 2) for mark in "})"}
        for at in range(size - 1, -1, -1):
            character, following = text[at], at + 1
            # More pieces are preferred to an end.
            past = ends[following]
            if past < 0 and self._is_over(following):
                past = following
            if character in quoted:
                ends[at] = quoted[character][following]
            elif not character.isspace():
                is_inside = (
                    following < size and text[following] not in "'\"" and not text[following].isspace()
                )
                ends[at] = ends[following] if is_inside else past
            if character == "\n":
                continue
            for quote, found in quoted.items():
                found[at] = past if character == quote and past >= 0 else found[following]
            for mark, found in closing.items():
                found[at] = following if character == mark and self._is_over(following) else found[following]

    def _is_over(self, at: int) -> bool:
        return at >= len(self.text) or self.text[at].isspace()

    def _skip(self, at: int) -> int:
        match = _BLANKS.match(self.text, at)
        assert match
        return match.end()


class ArgumentParser:
    """Does the work of ``xacro.parse_macro_arg``: the first parameter, its default, and the rest."""

    __slots__ = ("_known",)

    def __init__(self) -> None:
        self._known = Parameters("")

    def __call__(self, text: str) -> tuple[str, tuple[str | None, str | None] | None, str]:
        if not self._known.text.endswith(text):
            self._known = Parameters(text)
        whole = self._known.text
        parameter, following = next(self._known.after(len(whole) - len(text)))
        has_default = _HEAD.match(whole, parameter.start) is not None and following > parameter.end
        has_default = has_default and "=" in whole[parameter.end : following]
        if not has_default:
            return parameter.name, None, whole[following:].lstrip()
        forwarded = parameter.name if parameter.forwards else None
        # xacro reads on to the end of the line only.
        return parameter.name, (forwarded, parameter.default), whole[following:].partition("\n")[0]

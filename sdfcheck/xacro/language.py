"""The words of the xacro language, and the parameters of macros as it takes them apart."""

from __future__ import annotations

import ast
import re
from collections.abc import Callable, Iterator, Mapping

from sdfcheck.source.record import NamedTuple
from sdfcheck.source.text import pattern

# The words of the xacro language.


PREFIX = "xacro:"

KEYWORDS = frozenset(
    ["arg", "attribute", "call", "element", "if", "include", "insert_block", "macro", "property", "unless"]
)
"""The elements of the language; any other ``xacro:…`` calls a macro."""

REQUIRED: Mapping[str, tuple[str, ...]] = {
    "arg": ("name", "default"),
    "attribute": ("name", "value"),
    "call": ("macro",),
    "if": ("value",),
    "include": ("filename",),
    "insert_block": ("name",),
    "macro": ("name",),
    "property": ("name",),
    "unless": ("value",),
}
"""The attributes that elements of the language cannot do without; of the others any will do."""

OPTIONAL: Mapping[str, tuple[str, ...]] = {
    "include": ("ns", "optional"),
    "macro": ("params",),
    "property": ("value", "default", "remove", "scope", "lazy_eval"),
}
"""Further attributes that they take."""

COMMANDS = frozenset(["anon", "arg", "cwd", "dirname", "env", "eval", "find", "optenv"])
"""The beginnings of a substitution."""

# Names that expressions have from the start: Python's functions that xacro exposes, its modules, and math.
BUILT_IN = frozenset(
    """
    True False None list dict map len str float int bool min max round sorted range python math xacro
    load_yaml abs_filename dotify arg message warning error print_location fatal tokenize acos acosh
    asin asinh atan atan2 atanh cbrt ceil comb copysign cos cosh degrees dist e erf erfc exp exp2 expm1
    fabs factorial floor fma fmod frexp fsum gamma gcd hypot inf isclose isfinite isinf isnan isqrt lcm
    ldexp lgamma log log10 log1p log2 modf nan nextafter perm pi pow prod radians remainder sin sinh
    sqrt sumprod tan tanh tau trunc ulp
    """.split()
)

LONGEST_CODE = 65_536
"""Code with more characters is not read: of a chain of twice that, such as ``a.a.a``, Python 3.10 dies."""

DEPRECATED: Mapping[str, str] = {
    "abs_filename": "xacro",
    "dotify": "xacro",
    "load_yaml": "xacro",
    "range": "python",
    "sorted": "python",
}
"""Functions that xacro warns about if they are called without their module → the module."""

ONLY_IN_MODULE = frozenset(
    ["arg", "error", "fatal", "fma", "message", "print_location", "sumprod", "tokenize", "warning"]
)
"""Functions that a property may be called after: they are known with their module only, or not everywhere."""
SYMBOLS = BUILT_IN - ONLY_IN_MODULE
"""The names that expressions know, and that a property or parameter of that name redefines."""

_EXPRESSION = pattern(r"\$\$+[{(]|\$\{(?P<code>[^}]*)\}|\$\((?P<command>[^)]*)\)")
"""An expression or a substitution; a doubled dollar sign escapes it."""
_OPENING = pattern(r"(\$+)([{(])?")
_CLOSING = {"{": "}", "(": ")"}

LEADING = r"(?:\$\(arg\s+(?P<arg>\w+)\s*\)|\$\{\s*(?P<property>[^\W\d]\w*)\s*\})(?P<slash>/?)"
"""The expression with which a name begins, where it is an argument or a property alone."""
FIND = pattern(r"find\s+(\S+)\s*$")


def matches(text: str) -> Iterator[re.Match[str]]:
    """The expressions (``code``), the substitutions (``command``) and what is escaped (neither) in a text."""
    at, endless = 0, set()
    while opening := _OPENING.search(text, at):
        at = opening.end()
        if opening[2] is None or (len(opening[1]) == 1 and opening[2] in endless):
            continue
        if len(opening[1]) == 1 and text.find(_CLOSING[opening[2]], at) < 0:
            # Nor do those end that follow, and looking for their end each time would take long.
            endless.add(opening[2])
            continue
        match = _EXPRESSION.match(text, opening.start())
        assert match
        yield match
        at = match.end()


def replaced(text: str, by: Callable[[re.Match[str]], str]) -> str:
    """A text with other words in the place of its expressions and substitutions."""
    pieces, at = [], 0
    for match in matches(text):
        pieces += [text[at : match.start()], by(match)]
        at = match.end()
    return "".join([*pieces, text[at:]])


def expressions(text: str) -> Iterator[tuple[int, str]]:
    """The ``${…}`` in a text: the place of the code, and the code."""
    for match in matches(text):
        if match["code"] is not None:
            yield match.start("code"), match["code"]


def substitutions(text: str) -> Iterator[tuple[int, str]]:
    """The ``$(…)`` in a text, also those inside of ``${…}``: the place of the command, and the command."""
    for match in matches(text):
        if match["command"] is not None:
            yield match.start("command"), match["command"]
        elif match["code"] is not None and "$(" in match["code"]:
            for start, command in substitutions(match["code"]):
                yield match.start("code") + start, command


def is_literal(text: str) -> bool:
    """Whether a text means itself."""
    return "${" not in text and "$(" not in text


def may_become(written: str, name: str) -> bool:
    """Is a text this one, or may its expressions come to it? One without any other character says nothing."""
    bounds = [0, *(place for match in matches(written) for place in match.span()), len(written)]
    first, *others = (written[start:end] for start, end in zip(bounds[::2], bounds[1::2], strict=True))
    if not others:
        return written == name
    *middle, last = others
    at = len(first) if name.startswith(first) else -1
    for piece in middle:
        found = name.find(piece, at + 1) if at >= 0 else -1
        at = found + len(piece) if found >= 0 else -1
    return any((first, *others)) and 0 <= at < len(name) - len(last) and name.endswith(last)


def syntax_tree(code: str, mode: str = "eval") -> ast.AST:
    """The tree of an expression of Python; of a program with the mode ``exec``.

    Raises:
        SyntaxError: the code has another form.
        ValueError, RecursionError, MemoryError: it is too long, or nested too deep.
    """
    if len(code) > LONGEST_CODE:
        raise ValueError(f"more than {LONGEST_CODE} characters")
    return ast.parse(code, mode=mode)


# The parameters of a macro, as xacro takes ``params`` apart.
#
# xacro's regular expression tries every way to part a default into quoted and bare pieces,
# which takes for ever where a quote is left over. Here each offset is decided once.


_HEAD = pattern(r"\s*([^\s:=]+)\s*:?=")
_BLANKS = pattern(r"\s*")
_PLAIN = pattern(r"\s*(\S+)")


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
        begin = self.skip(head.end())
        marks = [mark for mark in ("^|", "^", "") if self.text.startswith(mark, begin)]
        for mark in marks:
            start = begin + len(mark)
            end = self._end(start)
            if end >= 0:
                default = self.text[start:end] or None
                return Parameter(head[1], *head.span(1), default, bool(mark)), self.skip(end)
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

    def skip(self, at: int) -> int:
        """The offset of the next character that is not blank."""
        match = _BLANKS.match(self.text, at)
        assert match
        return match.end()


class _Rest:
    """The rest of a ``params`` attribute; true where there is one."""

    __slots__ = ("at", "of")

    def __init__(self, of: Parameters, at: int) -> None:
        self.of = of
        self.at = at

    def __bool__(self) -> bool:
        return self.at < len(self.of.text)

    def __str__(self) -> str:
        return self.of.text[self.at :]


class ArgumentParser:
    """Does the work of ``xacro.parse_macro_arg``: the first parameter, its default, and the rest.

    xacro only asks whether there is a rest, and hands it back; a text would be copied for each parameter.
    """

    __slots__ = ()

    def __call__(self, given: str | _Rest) -> tuple[str, tuple[str | None, str | None] | None, _Rest]:
        rest = given if isinstance(given, _Rest) else _Rest(Parameters(given), 0)
        whole = rest.of.text
        parameter, following = next(rest.of.after(rest.at))
        has_default = _HEAD.match(whole, parameter.start) is not None and following > parameter.end
        has_default = has_default and whole.find("=", parameter.end, following) >= 0
        if not has_default:
            return parameter.name, None, _Rest(rest.of, rest.of.skip(following))
        forwarded = parameter.name if parameter.forwards else None
        # xacro reads on to the end of the line only.
        line_end = whole.find("\n", following)
        if line_end >= 0:
            rest, following = _Rest(Parameters(whole[following:line_end]), 0), 0
        return parameter.name, (forwarded, parameter.default), _Rest(rest.of, following)

"""The words of the xacro language."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Mapping

PREFIX = "xacro:"

KEYWORDS = frozenset(
    ["arg", "attribute", "call", "element", "if", "include", "insert_block", "macro", "property", "unless"]
)
"""The elements of the language; any other ``xacro:…`` calls a macro."""

REQUIRED: Mapping[str, tuple[str, ...]] = {
    "arg": ("name", "default"),
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

_EXPRESSION = re.compile(r"\$\$+[{(]|\$\{(?P<code>[^}]*)\}|\$\((?P<command>[^)]*)\)")
"""An expression or a substitution; a doubled dollar sign escapes it."""
_OPENING = re.compile(r"(\$+)([{(])?")
_CLOSING = {"{": "}", "(": ")"}

FIND = re.compile(r"find\s+(\S+)\s*$")


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

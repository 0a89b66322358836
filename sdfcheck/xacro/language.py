"""The words of the xacro language."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping

from sdfcheck.source.record import NamedTuple

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
"""What a substitution may begin with."""

# What expressions know without being told: Python's functions that xacro exposes, its modules, and math.
BUILT_IN = frozenset(
    [
        "True",
        "False",
        "None",
        "list",
        "dict",
        "map",
        "len",
        "str",
        "float",
        "int",
        "bool",
        "min",
        "max",
        "round",
        "sorted",
        "range",
        "python",
        "math",
        "xacro",
        "load_yaml",
        "abs_filename",
        "dotify",
        "arg",
        "message",
        "warning",
        "error",
        "print_location",
        "fatal",
        "tokenize",
        "acos",
        "acosh",
        "asin",
        "asinh",
        "atan",
        "atan2",
        "atanh",
        "cbrt",
        "ceil",
        "comb",
        "copysign",
        "cos",
        "cosh",
        "degrees",
        "dist",
        "e",
        "erf",
        "erfc",
        "exp",
        "exp2",
        "expm1",
        "fabs",
        "factorial",
        "floor",
        "fma",
        "fmod",
        "frexp",
        "fsum",
        "gamma",
        "gcd",
        "hypot",
        "inf",
        "isclose",
        "isfinite",
        "isinf",
        "isnan",
        "isqrt",
        "lcm",
        "ldexp",
        "lgamma",
        "log",
        "log10",
        "log1p",
        "log2",
        "modf",
        "nan",
        "nextafter",
        "perm",
        "pi",
        "pow",
        "prod",
        "radians",
        "remainder",
        "sin",
        "sinh",
        "sqrt",
        "sumprod",
        "tan",
        "tanh",
        "tau",
        "trunc",
        "ulp",
    ]
)

EXPRESSION = re.compile(r"\$\$+[{(]|\$\{(?P<code>[^}]*)\}|\$\((?P<command>[^)]*)\)")
"""An expression or a substitution; a doubled dollar sign escapes it."""

FIND = re.compile(r"find\s+(\S+)\s*$")

_DEFAULT = r"\$\{.*?\}|\$\(.*?\)|(?:'.*?'|\".*?\"|[^\s'\"]+)+|"
_PARAMETER = re.compile(rf"\s*([^\s:=]+?)\s*:?=\s*(\^\|?)?({_DEFAULT})(?:\s+|$)")
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
    at = 0
    while text[at:].strip():
        match = _PARAMETER.match(text, at)
        if match:
            yield Parameter(match[1], match.start(1), match.end(1), match[3] or None, match[2] is not None)
        else:
            match = _PLAIN.match(text, at)
            assert match
            yield Parameter(match[1], match.start(1), match.end(1), None, False)
        at = match.end()


def expressions(text: str) -> Iterator[tuple[int, str]]:
    """The ``${…}`` in a text: the place of the code, and the code."""
    for match in EXPRESSION.finditer(text):
        if match["code"] is not None:
            yield match.start("code"), match["code"]


def substitutions(text: str) -> Iterator[tuple[int, str]]:
    """The ``$(…)`` in a text, also those inside of ``${…}``: the place of the command, and the command."""
    for match in EXPRESSION.finditer(text):
        if match["command"] is not None:
            yield match.start("command"), match["command"]
        elif match["code"] is not None and "$(" in match["code"]:
            for start, command in substitutions(match["code"]):
                yield match.start("code") + start, command


def is_literal(text: str) -> bool:
    """Whether a text means itself."""
    return "${" not in text and "$(" not in text

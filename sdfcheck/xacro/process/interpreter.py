"""Evaluates the expressions of xacro from their syntax tree. Runs in the process that expands, nowhere else.

A xacro file is a program: its expressions are Python, which xacro has Python run. Here they are not run.
Their values are numbers, text, bytes, containers of such, iterators over them, and functions that are listed
below or that a ``lambda`` makes. The nodes of the tree, the attributes of each type and the functions are
allow-lists: whatever is not on them is refused by name, so no value leads to a frame, a module or a type's
inside. Steps, digits and sizes are counted; what C code does in one step is left to the limits of the process.
"""

from __future__ import annotations

import ast
import builtins
import math
import operator
import re
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from datetime import date, datetime
from functools import lru_cache
from string import Formatter
from typing import Any

STEPS = 5_000_000
"""So many nodes of expressions one expansion may evaluate."""

DIGITS = 100_000
"""The most decimal digits of a whole number."""

PARTS = 10_000_000
"""The longest text, list, dictionary or set that an expression may make."""

BYTES = 1_000_000_000
"""So much all values together may take that the expressions of one expansion make."""

_BITS = int(DIGITS / math.log10(2))

_VALUES = frozenset(
    """
    abs all any bool complex dict divmod enumerate filter float frozenset hash int isinstance issubclass
    len list map max min ord range repr reversed round set slice sorted str sum tuple zip True False
    """.split()
)
"""The functions of Python that give values and reach nothing else."""

_OF_XACRO = frozenset(
    "abs_filename arg dotify error fatal load_yaml message print_location tokenize warning".split()
)
_OF_MATH = frozenset(name for name in vars(math) if not name.startswith("_"))

_NUMBER = "conjugate imag real"
_WHOLE = f"{_NUMBER} as_integer_ratio bit_count bit_length denominator is_integer numerator"
_READING = "copy get items keys values"
_OF_SETS = "copy difference intersection isdisjoint issubset issuperset symmetric_difference union"
_OF_DATES = "day isoformat month weekday year"

_METHODS: Mapping[type, frozenset[str]] = {
    kind: frozenset(names.split())
    for kind, names in {
        bool: _WHOLE,
        bytes: "decode hex",
        complex: _NUMBER,
        date: _OF_DATES,
        datetime: f"{_OF_DATES} hour minute second",
        dict: f"{_READING} clear fromkeys pop popitem setdefault update",
        float: f"{_NUMBER} as_integer_ratio fromhex hex is_integer",
        frozenset: _OF_SETS,
        int: _WHOLE,
        list: "append clear copy count extend index insert pop remove reverse sort",
        range: "count index start step stop",
        set: f"{_OF_SETS} add clear difference_update discard intersection_update pop remove "
        "symmetric_difference_update update",
        slice: "indices start step stop",
        str: "capitalize casefold center count encode endswith expandtabs find format format_map index isalnum "
        "isalpha isascii isdecimal isdigit isidentifier islower isnumeric isprintable isspace istitle isupper "
        "join ljust lower lstrip maketrans partition removeprefix removesuffix replace rfind rindex rjust "
        "rpartition rsplit rstrip split splitlines startswith strip swapcase title translate upper zfill",
        tuple: "count index",
    }.items()
}
_OF_TYPES = frozenset({(dict, "fromkeys"), (float, "fromhex"), (str, "maketrans")})
"""Those that do not need a value of the type."""

_WIDTHS = frozenset({"center", "expandtabs", "ljust", "rjust", "zfill"})
_SIZED = (str, bytes, list, tuple, dict, set, frozenset)

_BINARY: Mapping[type[ast.operator], Callable[[Any, Any], Any]] = {
    ast.Add: operator.add,
    ast.BitAnd: operator.and_,
    ast.BitOr: operator.or_,
    ast.BitXor: operator.xor,
    ast.Div: operator.truediv,
    ast.FloorDiv: operator.floordiv,
    ast.LShift: operator.lshift,
    ast.Mod: operator.mod,
    ast.Mult: operator.mul,
    ast.Pow: operator.pow,
    ast.RShift: operator.rshift,
    ast.Sub: operator.sub,
}
_UNARY: Mapping[type[ast.unaryop], Callable[[Any], Any]] = {
    ast.Invert: operator.invert,
    ast.Not: operator.not_,
    ast.UAdd: operator.pos,
    ast.USub: operator.neg,
}
_COMPARE: Mapping[type[ast.cmpop], Callable[[Any, Any], Any]] = {
    ast.Eq: operator.eq,
    ast.Gt: operator.gt,
    ast.GtE: operator.ge,
    ast.In: lambda one, others: one in others,
    ast.Is: operator.is_,
    ast.IsNot: operator.is_not,
    ast.Lt: operator.lt,
    ast.LtE: operator.le,
    ast.NotEq: operator.ne,
    ast.NotIn: lambda one, others: one not in others,
}
_CONVERSIONS: Mapping[int, Callable[[object], object]] = {
    -1: lambda value: value,
    97: ascii,
    114: repr,
    115: str,
}

_INDEX = re.compile(r"\[[^\]]*\]")
_NUMBERS = re.compile(r"\d+")
_PERCENT = re.compile(r"%(?:\([^)]*\))?[-#0 +]*[\d.*]*")


class Refused(Exception):
    """An expression tried what it must not."""


class TooMuch(Exception):
    """A limit is reached."""


class Refusal:
    """Stands where xacro or Python has a function that expressions do not get here."""

    __slots__ = ("_name",)

    def __init__(self, name: str) -> None:
        self._name = name

    def __call__(self, *_: object, **__: object) -> object:
        raise Refused(f"`{self._name}` must not be used in an expression")

    def __repr__(self) -> str:
        raise Refused(f"`{self._name}` must not be used in an expression")


class Scope:
    """The names that an expression sees: those of a ``lambda`` or comprehension, and of what is around it."""

    __slots__ = ("names", "outer")

    def __init__(self, names: Any, outer: Scope | None = None) -> None:
        self.names = names
        self.outer = outer

    def find(self, name: str) -> Any:
        try:
            return self.names[name]
        except KeyError:
            if self.outer is None:
                raise NameError(f"name '{name}' is not defined", name=name) from None
        return self.outer.find(name)


class Interpreter:
    """Evaluates the expressions of one expansion, which share a budget."""

    def __init__(self, xacro: Any, substitution_args: Any) -> None:
        self._namespace: type = xacro.NameSpace
        self._tree: type = xacro.YamlDictWrapper
        self._methods = {
            **_METHODS,
            xacro.NameSpace: frozenset(_READING.split()),
            xacro.YamlDictWrapper: _METHODS[dict],
            xacro.YamlListWrapper: _METHODS[list],
        }
        self._functions = Scope(
            {name: Refusal(name) for name in dir(builtins)} | _only(vars(builtins), _VALUES)
        )
        self._steps = STEPS
        self._bytes = BYTES
        self._take = self._nodes()
        _cage(xacro._global_symbols)
        substitution_args._eval_dict.update(_BOUNDED)
        xacro.safe_eval = self.evaluate
        substitution_args.eval = self.evaluate_substitution

    def _nodes(self) -> Mapping[type[ast.expr], Callable[[Any, Scope], Any]]:
        """The nodes that an expression may have, and what evaluates them."""
        return {
            ast.Attribute: self._attribute_of,
            ast.BinOp: self._bin_op,
            ast.BoolOp: self._bool_op,
            ast.Call: self._call,
            ast.Compare: self._compare,
            ast.Constant: self._constant,
            ast.Dict: self._dict,
            ast.DictComp: self._dict_comp,
            ast.FormattedValue: self._formatted_value,
            ast.GeneratorExp: self._generator_exp,
            ast.IfExp: self._if_exp,
            ast.JoinedStr: self._joined_str,
            ast.Lambda: self._lambda,
            ast.List: self._list,
            ast.ListComp: self._list_comp,
            ast.Name: self._name,
            ast.NamedExpr: self._named_expr,
            ast.Set: self._set,
            ast.SetComp: self._set_comp,
            ast.Slice: self._slice,
            ast.Subscript: self._subscript,
            ast.Tuple: self._tuple,
            ast.UnaryOp: self._unary_op,
        }

    def evaluate(self, expression: str, symbols: Any, locals: Any = None) -> object:
        """The value of an expression; ``symbols`` are xacro's properties, parameters and functions."""
        return self.value(parse(expression), Scope(symbols))

    def evaluate_substitution(self, expression: str, symbols: Any, locals: Any) -> object:
        """The value of the text of ``$(eval …)``, to which xacro gives all of Python's built-in functions."""
        return self.value(parse(expression), Scope(locals, self._functions))

    def value(self, node: ast.expr, scope: Scope) -> Any:
        self._steps -= 1
        if self._steps < 0:
            raise TooMuch(f"no end after {STEPS} steps of computing")
        take = self._take.get(type(node))
        if take is None:
            raise Refused(f"`{ast.unparse(node)}` must not be used in an expression: {type(node).__name__}")
        return take(node, scope)

    # Names, and what is made of values

    def _constant(self, node: ast.Constant, scope: Scope) -> object:
        return node.value

    def _name(self, node: ast.Name, scope: Scope) -> object:
        return scope.find(node.id)

    def _named_expr(self, node: ast.NamedExpr, scope: Scope) -> object:
        value = self.value(node.value, scope)
        scope.names[node.target.id] = value
        return value

    def _unary_op(self, node: ast.UnaryOp, scope: Scope) -> object:
        return _UNARY[type(node.op)](self.value(node.operand, scope))

    def _bin_op(self, node: ast.BinOp, scope: Scope) -> object:
        pending = [node]  # a long sum is a deep tree
        while isinstance(pending[-1].left, ast.BinOp):
            pending.append(pending[-1].left)
        value = self.value(pending[-1].left, scope)
        for one in reversed(pending):
            compute = _BINARY.get(type(one.op))
            if compute is None:
                raise Refused("`@` must not be used in an expression")
            right = self.value(one.right, scope)
            _expect(type(one.op), value, right)
            value = self._made(compute(value, right))
        return value

    def _bool_op(self, node: ast.BoolOp, scope: Scope) -> object:
        value: object = None
        for each in node.values:
            value = self.value(each, scope)
            if bool(value) is isinstance(node.op, ast.Or):
                break
        return value

    def _compare(self, node: ast.Compare, scope: Scope) -> object:
        left = self.value(node.left, scope)
        result: object = True
        for compare, each in zip(node.ops, node.comparators, strict=True):
            right = self.value(each, scope)
            result = _COMPARE[type(compare)](left, right)
            if not result:
                break
            left = right
        return result

    def _if_exp(self, node: ast.IfExp, scope: Scope) -> object:
        return self.value(node.body if self.value(node.test, scope) else node.orelse, scope)

    # Containers and text

    def _list(self, node: ast.List, scope: Scope) -> object:
        return self._items(node.elts, scope)

    def _tuple(self, node: ast.Tuple, scope: Scope) -> object:
        return tuple(self._items(node.elts, scope))

    def _set(self, node: ast.Set, scope: Scope) -> object:
        return set(self._items(node.elts, scope))

    def _dict(self, node: ast.Dict, scope: Scope) -> object:
        made: dict[Any, Any] = {}
        for key, each in zip(node.keys, node.values, strict=True):
            if key is None:
                made.update(self.value(each, scope))
            else:
                made[self.value(key, scope)] = self.value(each, scope)
        return self._made(made)

    def _slice(self, node: ast.Slice, scope: Scope) -> object:
        parts = (node.lower, node.upper, node.step)
        return slice(*(None if part is None else self.value(part, scope) for part in parts))

    def _joined_str(self, node: ast.JoinedStr, scope: Scope) -> object:
        return self._made("".join([self.value(part, scope) for part in node.values]))

    def _formatted_value(self, node: ast.FormattedValue, scope: Scope) -> object:
        value = _CONVERSIONS[node.conversion](self.value(node.value, scope))
        form = "" if node.format_spec is None else self.value(node.format_spec, scope)
        _expect_width(form)
        return format(value, form)

    def _items(self, nodes: Iterable[ast.expr], scope: Scope) -> list[Any]:
        made: list[Any] = []
        for node in nodes:
            if isinstance(node, ast.Starred):
                made.extend(self.value(node.value, scope))
            else:
                made.append(self.value(node, scope))
        self._made(made)
        return made

    # Comprehensions

    def _list_comp(self, node: ast.ListComp, scope: Scope) -> object:
        inner = Scope({}, scope)
        made = [
            self.value(node.elt, inner) for _ in self._turns(node.generators, inner, self._first(node, scope))
        ]
        return self._made(made)

    def _set_comp(self, node: ast.SetComp, scope: Scope) -> object:
        inner = Scope({}, scope)
        made = {
            self.value(node.elt, inner) for _ in self._turns(node.generators, inner, self._first(node, scope))
        }
        return self._made(made)

    def _dict_comp(self, node: ast.DictComp, scope: Scope) -> object:
        inner = Scope({}, scope)
        turns = self._turns(node.generators, inner, self._first(node, scope))
        return self._made({self.value(node.key, inner): self.value(node.value, inner) for _ in turns})

    def _generator_exp(self, node: ast.GeneratorExp, scope: Scope) -> object:
        inner = Scope({}, scope)
        turns = self._turns(node.generators, inner, self._first(node, scope))
        return (self.value(node.elt, inner) for _ in turns)

    def _first(self, node: Any, scope: Scope) -> Iterator[Any]:
        """The items of the first ``for``, which does not see the names of the comprehension."""
        return iter(self.value(node.generators[0].iter, scope))

    def _turns(
        self, generators: Sequence[ast.comprehension], scope: Scope, items: Iterable[Any]
    ) -> Iterator[None]:
        """One turn for each combination of items that passes the tests, with the names bound."""
        generator, others = generators[0], generators[1:]
        if generator.is_async:
            raise Refused("`async` must not be used in an expression")
        for item in items:
            self._bind(generator.target, item, scope)
            if not all(self.value(test, scope) for test in generator.ifs):
                continue
            if others:
                yield from self._turns(others, scope, self.value(others[0].iter, scope))
            else:
                yield

    def _bind(self, target: ast.expr, value: Any, scope: Scope) -> None:
        """Give a name, or names in a list, a value."""
        self._steps -= 1
        if isinstance(target, ast.Name):
            scope.names[target.id] = value
            return
        if not isinstance(target, ast.Tuple | ast.List):
            raise Refused(f"`for {ast.unparse(target)}` must not be used in an expression")
        values, names = list(value), target.elts
        stars = [at for at, name in enumerate(names) if isinstance(name, ast.Starred)]
        if len(values) < len(names) - len(stars):
            raise ValueError(f"not enough values to unpack (expected {len(names)}, got {len(values)})")
        if stars:
            at, rest = stars[0], len(values) - len(names) + 1
            values[at : at + rest] = [values[at : at + rest]]
        elif len(values) > len(names):
            raise ValueError(f"too many values to unpack (expected {len(names)})")
        for name, one in zip(names, values, strict=True):
            self._bind(name.value if isinstance(name, ast.Starred) else name, one, scope)

    # Functions

    def _call(self, node: ast.Call, scope: Scope) -> object:
        function = self.value(node.func, scope)
        arguments = self._items(node.args, scope)
        named: dict[str, Any] = {}
        for keyword in node.keywords:
            value = self.value(keyword.value, scope)
            more = dict(value) if keyword.arg is None else {keyword.arg: value}
            if twice := [name for name in more if name in named]:
                raise TypeError(f"got multiple values for keyword argument '{twice[0]}'")
            named.update(more)
        return self._made(function(*arguments, **named))

    def _lambda(self, node: ast.Lambda, scope: Scope) -> object:
        positional = [*node.args.posonlyargs, *node.args.args]
        values = [self.value(default, scope) for default in node.args.defaults]
        defaults = {parameter.arg: value for parameter, value in zip(positional[::-1], values[::-1])}  # noqa: B905
        for parameter, default in zip(node.args.kwonlyargs, node.args.kw_defaults, strict=True):
            if default is not None:
                defaults[parameter.arg] = self.value(default, scope)

        def call(*arguments: Any, **named: Any) -> object:
            return self.value(node.body, Scope(_bound(node.args, defaults, arguments, named), scope))

        return call

    # Attributes and items

    def _attribute_of(self, node: ast.Attribute, scope: Scope) -> object:
        return self._attribute(self.value(node.value, scope), node.attr)

    def _attribute(self, owner: Any, name: str) -> Any:
        kind = type(owner)
        if kind is type and name in self._methods.get(owner, ()):
            return getattr(owner, name) if (owner, name) in _OF_TYPES else self._unbound(owner, name)
        if name in self._methods.get(kind, ()):
            own = _OF_TEXT.get(name) if kind is str else None
            return getattr(owner, name) if own is None else lambda *args, **named: own(owner, *args, **named)
        if hasattr(kind, name) or name in getattr(owner, "__dict__", ()):
            raise Refused(f"`{name}` must not be used in an expression")
        if kind is self._tree:
            return owner[name]
        if kind is self._namespace:
            return Scope(owner).find(name)
        raise AttributeError(f"'{kind.__name__}' object has no attribute '{name}'")

    def _unbound(self, kind: type, name: str) -> Callable[..., object]:
        """A method that is called with its value, as in ``map(str.strip, texts)``."""

        def call(owner: Any, *arguments: Any, **named: Any) -> object:
            if not isinstance(owner, kind):
                raise TypeError(
                    f"'{name}' of '{kind.__name__}' does not apply to a '{type(owner).__name__}' object"
                )
            return self._attribute(owner, name)(*arguments, **named)

        return call

    def _subscript(self, node: ast.Subscript, scope: Scope) -> object:
        owner = self.value(node.value, scope)
        if isinstance(owner, type):
            raise Refused(f"`{ast.unparse(node)}` must not be used in an expression")
        return owner[self.value(node.slice, scope)]

    def _made(self, value: Any) -> Any:
        """Count a value that was made.

        Raises:
            TooMuch: it is too large, or all values together are.
        """
        if isinstance(value, int):
            _expect_bits(value.bit_length())
        elif isinstance(value, _SIZED):
            size = len(value)
            _expect_parts(size)
            self._bytes -= size if isinstance(value, str | bytes) else 8 * size
            if self._bytes < 0:
                raise TooMuch(f"the values take more than {BYTES} bytes together")
        return value


@lru_cache(maxsize=4096)
def parse(expression: str) -> ast.expr:
    """The tree of an expression.

    Raises:
        SyntaxError: the text has another form.
        Refused: it reaches for the interpreter; xacro refuses most of these names, too.
    """
    tree = ast.parse(expression.strip(), "<expression>", "eval").body
    if "__" in expression or not expression.isascii():  # Python reads some other letters as an underscore
        for node in ast.walk(tree):
            name = {ast.Name: "id", ast.Attribute: "attr"}.get(type(node))
            if name is not None and getattr(node, name).startswith("__"):
                raise Refused(f"`{getattr(node, name)}` must not be used in an expression")
    return tree


def _only(names: Mapping[str, Any], allowed: Iterable[str]) -> dict[str, Any]:
    return {name: names[name] for name in allowed if name in names}


def _cage(symbols: Any) -> None:
    """Leave xacro's global names only what is allowed; the others say so when they are used."""
    spaces = {"math": _OF_MATH, "python": _VALUES, "xacro": _OF_XACRO}
    tables = [(f"{name}.", dict.__getitem__(symbols, name), allowed) for name, allowed in spaces.items()]
    for prefix, table, allowed in [("", symbols, _OF_MATH | _VALUES | _OF_XACRO | {*spaces}), *tables]:
        for name, value in [*dict.items(table)]:
            if name not in allowed:
                dict.__setitem__(table, name, Refusal(f"{prefix}{name}"))
            elif name in _BOUNDED and value is getattr(math, name):
                dict.__setitem__(table, name, _BOUNDED[name])


def _bound(
    parameters: ast.arguments,
    defaults: Mapping[str, Any],
    arguments: tuple[Any, ...],
    named: Mapping[str, Any],
) -> dict[str, Any]:
    """The names of the parameters of a ``lambda``, with what a call gives them."""
    positional = [parameter.arg for parameter in (*parameters.posonlyargs, *parameters.args)]
    by_name = [parameter.arg for parameter in (*parameters.args, *parameters.kwonlyargs)]
    names: dict[str, Any] = dict(zip(positional, arguments))  # noqa: B905
    if parameters.vararg is not None:
        names[parameters.vararg.arg] = arguments[len(positional) :]
    elif len(arguments) > len(positional):
        raise TypeError(
            f"<lambda>() takes {len(positional)} positional arguments but {len(arguments)} were given"
        )
    rest = dict(named)
    for name in by_name:
        if name in rest:
            if name in names:
                raise TypeError(f"<lambda>() got multiple values for argument '{name}'")
            names[name] = rest.pop(name)
    if parameters.kwarg is not None:
        names[parameters.kwarg.arg] = rest
    elif rest:
        raise TypeError(f"<lambda>() got an unexpected keyword argument '{next(iter(rest))}'")
    names = {**defaults, **names}
    if missing := [name for name in (*positional, *by_name) if name not in names]:
        raise TypeError(f"<lambda>() missing a required argument: '{missing[0]}'")
    return names


# Checks before a computation that could take all memory or time at once.


def _expect(kind: type[ast.operator], left: Any, right: Any) -> None:
    """Look at the operands of an operator."""
    if isinstance(left, int) and isinstance(right, int):
        if kind is ast.Mult:
            _expect_bits(left.bit_length() + right.bit_length() - 1)
        elif kind is ast.LShift and left:
            _expect_bits(left.bit_length() + right)
        elif kind is ast.Pow and abs(left) > 1:
            _expect_bits((left.bit_length() - 1) * right)
    elif kind is ast.Mult:
        for one, times in ((left, right), (right, left)):
            if isinstance(one, _SIZED) and isinstance(times, int):
                _expect_parts(len(one) * times)
    elif kind is ast.Mod and isinstance(left, str | bytes):
        form = "".join(_PERCENT.findall(left if isinstance(left, str) else left.decode("latin-1")))
        _expect_width(form)
        _expect_widths(right if isinstance(right, tuple) else (right,), "*" in form)


def _expect_bits(bits: int) -> None:
    if bits > _BITS:
        raise TooMuch(f"the number has more than {DIGITS} digits")


def _expect_parts(parts: int) -> None:
    if parts > PARTS:
        raise TooMuch(f"the value has {parts} parts, more than {PARTS}")


def _expect_width(form: str) -> None:
    """Look at the widths and precisions in a format."""
    for number in _NUMBERS.findall(form):
        _expect_parts(int(number) if len(number) < 10 else 10**9)


def _expect_widths(values: Iterable[Any], may_be_widths: bool) -> None:
    if may_be_widths:
        for value in values:
            if isinstance(value, int):
                _expect_parts(value)


def _check_fields(form: str, values: Iterable[Any]) -> None:
    """Look at the fields of a format: they name no attributes, and no width is too large."""
    for _, field, spec, _ in Formatter().parse(form):
        if field is not None and "." in _INDEX.sub("", field):
            raise Refused(f"`{{{field}}}` must not be used in a format: an attribute")
        if spec:
            _expect_width(spec)
            _expect_widths(values, "{" in spec)
            _check_fields(spec, values)


def _formatted(text: str, *arguments: Any, **named: Any) -> str:
    _check_fields(text, (*arguments, *named.values()))
    return text.format(*arguments, **named)


def _formatted_map(text: str, names: Any) -> str:
    _check_fields(text, dict.values(names) if isinstance(names, dict) else ())
    return text.format_map(names)


def _widened(name: str) -> Callable[..., str]:
    def call(text: str, *arguments: Any, **named: Any) -> str:
        _expect_widths((*arguments, *named.values()), may_be_widths=True)
        made: str = getattr(text, name)(*arguments, **named)
        return made

    return call


_OF_TEXT: Mapping[str, Callable[..., str]] = {
    "format": _formatted,
    "format_map": _formatted_map,
    **{name: _widened(name) for name in _WIDTHS},
}
"""The methods of text that look before they compute."""


def _factorial(number: Any) -> int:
    if isinstance(number, int) and number > 1:
        _expect_bits(int(math.lgamma(min(number, 10**9) + 1) / math.log(2)))
    return math.factorial(number)


def _choices(number: Any, chosen: Any) -> int:
    if isinstance(number, int) and isinstance(chosen, int) and 0 <= chosen <= number:
        _expect_bits(
            (number // max(1, min(chosen, number - chosen))).bit_length() * min(chosen, number - chosen)
        )
    return math.comb(number, chosen)


def _arrangements(number: Any, chosen: Any = None) -> int:
    if isinstance(number, int) and isinstance(chosen, int | None) and number > 1:
        _expect_bits((number.bit_length() - 1) * (number if chosen is None else chosen))
    return math.perm(number, chosen)


_BOUNDED: Mapping[str, Callable[..., int]] = {
    "comb": _choices,
    "factorial": _factorial,
    "perm": _arrangements,
}
"""The functions of ``math`` that look before they compute."""

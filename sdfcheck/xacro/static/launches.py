"""The arguments that launch files of a project give to its xacro files. Nothing of a launch file runs.

Launch files of ROS 1 and ROS 2 in XML hold a command line (``xacro FILE name:=value``), in which arguments of
the launch file (``$(arg name)``, ``$(var name)``) have their defaults. Those in Python make one of substitutions
(``Command(["xacro ", PathJoinSubstitution([...]), " name:=", LaunchConfiguration("name")])``), or call
``xacro.process_file(FILE, mappings={...})``; they are read as syntax trees. A launch file gives arguments to
those that it includes. Where a value is not known, the argument is left out.
"""

from __future__ import annotations

import ast
import operator
import os
import re
from collections.abc import Callable, Iterator, Mapping
from contextlib import suppress
from itertools import accumulate
from pathlib import Path
from typing import Any, Protocol

from sdfcheck.files.library import library_of
from sdfcheck.files.packages import LAUNCHES, Packages, is_of_ros_1
from sdfcheck.files.regular import read_regular
from sdfcheck.source.document import Document
from sdfcheck.source.record import NamedTuple
from sdfcheck.source.text import Source, Span, pattern
from sdfcheck.xacro.language import LONGEST_CODE, syntax_tree

_FOLDER = "launch"
"""In a folder of this name each program is a launch file, elsewhere one whose name says so."""
_FILE_LIMIT = 500
"""So many launch files of each kind are read."""
_INCLUDES_DEEP = 4
_EFFORT = 5_000_000
"""So many characters and names are looked at for all launch files of a project; the rest is not known."""
_MOST = 8
"""So many sets of arguments of one file are kept."""
_DEEPEST = 30
_LONGEST = 10_000
"""A text of a launch file with more characters is not known."""
_LONGEST_VALUE = 1_000
"""The same for the default of an argument, of which a text may hold many."""

_UNKNOWN = "\0"
_NO_OTHER = "\ue000"
"""It in the text of an expression."""
_COMPARISONS: Mapping[type[ast.cmpop], Callable[[Any, Any], bool]] = {
    ast.Eq: operator.eq,
    ast.NotEq: operator.ne,
    ast.In: lambda one, other: one in other,
    ast.NotIn: lambda one, other: one not in other,
}
_METHODS: Mapping[str, Callable[..., Any]] = {
    method.__name__: method for method in (str.lower, str.upper, str.strip, str.startswith, str.endswith)
}
_VALUE = pattern(r"=\s*(?:\"([^\"]*)\"|'([^']*)')")
_TAG = pattern(r"<(/?)(arg|include|let)\b([^<>]*)>")
_ATTRIBUTE = pattern(r"\b(name|default|value|file|pass_all_args)\s*=\s*(?:\"([^\"]*)\"|'([^']*)')")
_REFERENCE = pattern(r"\$\((?:arg|var)\s+([^\s()]+)\s*\)")
_PACKAGE = pattern(r"\$\((?:find|find-pkg-share)\s+([^\s()]+)\s*\)")
_OTHER = pattern(r"\$\((?!command\b)[^()]*\)")
_STRING = pattern(r"type\s*=\s*[\"']str")
_REPLACED = r"<xacro:|\$\{|\$\("
"""Something that xacro replaces."""
_JOINED = pattern(f"xacro[/{_UNKNOWN}]")
_FORMER = "xacro.py"
_EXPANDER = pattern(r"\bxacro\.[a-z_]{1,30}\(")
_GIVEN = pattern(r"(?<!\w)(\w+):=(\"[^\"]*\"|'[^']*'|\S*)")


class LaunchFault(NamedTuple):
    """A place in a launch file where a file is not expanded as it is meant to be."""

    kind: str
    """``joined``: the name of xacro and the file are one word; ``read``: not by xacro; ``gone``: by ``xacro.py``."""
    span: Span


class _Use(NamedTuple):
    """A file that is expanded, included, or opened as it is: what it is given, and whether it is taken for text."""

    file: str
    arguments: Mapping[str, str]
    is_text: bool = True
    is_expanded: bool = True
    fault: LaunchFault | None = None


def launched_arguments(document: Document) -> tuple[Mapping[str, str], ...]:
    """The sets of arguments with which launch files of the project expand a xacro file, each once."""
    found: list[Mapping[str, str]] = []
    for arguments in (each.arguments for each in _uses(document)):
        if arguments and arguments not in found:
            found.append(arguments)
    return tuple(found[:_MOST])


def is_launched(document: Document) -> bool:
    """Does a launch file of the project expand a file with xacro?"""
    return any(each.is_expanded for each in _uses(document))


def is_launched_as_text(document: Document) -> bool:
    """Do the launch files of the project that expand or open a file take it for text, none for YAML?

    Those of ROS 1 always do, those of ROS 2 where they say so (``ParameterValue``). Where none names the file,
    those count that expand one whose name is not known.
    """
    uses = _uses(document) or _uses(document, "")
    return is_of_ros_1(document.path) or (bool(uses) and all(each.is_text for each in uses))


def launch_fault(document: Document) -> LaunchFault | None:
    """The first place where a launch file of the project does not get what a document of xacro expands to.

    A file that is opened may also be expanded by others, which then may be meant.
    """
    uses = _uses(document)
    found = [use.fault for use in uses if use.fault is not None]
    if not found or (
        found[0].kind == "read" and (len(found) < len(uses) or not document.may_write(_REPLACED))
    ):
        return None
    return found[0]


def _uses(document: Document, name: str | None = None) -> list[_Use]:
    """The uses of a file, or of files of another name, which is empty where it is not known."""
    library = library_of(document)
    uses = {} if library is None else library.of_project(document.path, _Launches).uses
    return uses.get(document.path.name if name is None else name, [])


def launched_names(document: Document) -> frozenset[str]:
    """The names of all arguments that launch files of the project give to xacro files."""
    library = library_of(document)
    uses = {} if library is None else library.of_project(document.path, _Launches).uses
    return frozenset(name for sets in uses.values() for each in sets for name in each.arguments)


class _Launch(Protocol):
    """A launch file, whose text has been read; both methods take the arguments that it is given."""

    def uses(self, given: Mapping[str, str]) -> Iterator[_Use]:
        """The xacro files that it expands."""

    def included(self, given: Mapping[str, str]) -> Iterator[_Use]:
        """The launch files that it includes."""


class _Surroundings:
    """The packages of a project, and the effort that its launch files are worth."""

    __slots__ = ("_left", "_packages")

    def __init__(self, packages: Packages) -> None:
        self._packages = packages
        self._left = _EFFORT

    def may_spend(self, effort: int) -> bool:
        """Whether so many characters or names may still be looked at; each look counts as some."""
        self._left -= effort + 10
        return self._left > 0

    def resolved(self, text: str) -> str:
        """A text with the folders of packages in it; what is not known is one character."""

        def folder(match: re.Match[str]) -> str:
            found = self._packages.find(match[1])
            return _UNKNOWN if found is None else str(found)

        return _OTHER.sub(_UNKNOWN, _PACKAGE.sub(folder, text))


class _Launches:
    """The uses of xacro files in the launch files of a project, by the names of the files."""

    __slots__ = ("_around", "uses")

    def __init__(self, packages: Packages) -> None:
        self.uses: dict[str, list[_Use]] = {}
        self._around = _Surroundings(packages)
        by_name: dict[str, _Launch] = {}
        launches: list[_Launch] = []
        for path, text in launch_texts(packages):
            launch = self._read(path, text)
            if launch is not None:
                launches.append(launch)
                by_name.setdefault(path.name, launch)
        for launch in launches:
            for use in self._uses(launch, {}, by_name, 0):
                self.uses.setdefault(use.file, []).append(use)

    def _read(self, path: Path, text: str) -> _Launch | None:
        if "xacro" not in text and "nclude" not in text and "open(" not in text:
            return None
        source = Source(path, text, is_foreign=True)
        if path.suffix != ".py":
            return _Xml(source, self._around, is_ros_1=path.suffix == ".launch")
        return _Python.read(source, self._around)

    def _uses(
        self, launch: _Launch, given: Mapping[str, str], by_name: Mapping[str, _Launch], depth: int
    ) -> Iterator[_Use]:
        yield from launch.uses(given)
        # One that includes itself is asked again on the way.
        for inner in tuple(launch.included(given)) if depth < _INCLUDES_DEEP else ():
            if inner.file in by_name and self._around.may_spend(0):
                yield from self._uses(by_name[inner.file], inner.arguments, by_name, depth + 1)


def launch_texts(packages: Packages) -> Iterator[tuple[Path, str]]:
    """The launch files of a project with their texts, without those that cannot be read."""
    for suffix in LAUNCHES:
        for path in packages.files(suffix, _FILE_LIMIT, _is_launch):
            with suppress(OSError):
                yield path, read_regular(path, LONGEST_CODE).decode("utf-8", "replace")


def _is_launch(folder: str, name: str) -> bool:
    return not name.endswith(".py") or name.endswith("launch.py") or os.path.basename(folder) == _FOLDER


def _of_command(command: str, *, is_text: bool, fault: LaunchFault | None = None) -> Iterator[_Use]:
    """The use in a command line: the file is the first word that ends as one, and arguments follow."""
    words = command.split()
    names = [word.strip("'\"()").rpartition("/")[2] for word in words if ":=" not in word]
    file = next((name for name in names if name.endswith((".xacro", ".urdf"))), "")
    if _UNKNOWN in file or (not file and words[:1] == ["xacro"]):
        yield _Use("", {}, is_text, fault=fault)
    elif file:
        given = ((name, value.strip("'\"")) for name, value in _GIVEN.findall(command))
        known = {name: value.rstrip(")'\"") for name, value in given if _UNKNOWN not in value}
        yield _Use(file, known, is_text, fault=fault)


class _Xml:
    """A launch file in XML. In ROS 2 an included file knows all arguments, in ROS 1 those that it is given."""

    __slots__ = ("_around", "_commands", "_declared", "_former", "_includes", "_is_ros_1", "_is_text")

    def __init__(self, source: Source, around: _Surroundings, *, is_ros_1: bool) -> None:
        text = source.text
        start = text.find(f"/{_FORMER}") + 1 if is_ros_1 else 0
        self._former = LaunchFault("gone", Span(source, start, start + len(_FORMER))) if start else None
        self._around = around
        self._is_ros_1 = is_ros_1
        self._is_text = is_ros_1 or _STRING.search(text) is not None
        self._declared: list[dict[str, str]] = []
        self._includes: list[tuple[dict[str, str], list[dict[str, str]]]] = []
        """The attributes of each include, and of the arguments in it."""
        outer = declared = self._declared
        for end, name, inside in _TAG.findall(text):
            if name == "include":
                declared = outer
                if not end:
                    self._includes.append((_attributes(inside), []))
                    declared = outer if inside.endswith("/") else self._includes[-1][1]
            elif not end:
                declared.append(_attributes(inside))
        values = (_unescaped(double or single) for double, single in _VALUE.findall(text))
        self._commands = [value for value in values if "xacro" in value]

    def uses(self, given: Mapping[str, str]) -> Iterator[_Use]:
        values = self._arguments(given)
        for command in self._commands:
            fault = self._former if f"/{_FORMER}" in command else None
            yield from _of_command(self._text(command, values), is_text=self._is_text, fault=fault)

    def included(self, given: Mapping[str, str]) -> Iterator[_Use]:
        values = self._arguments(given)
        for attributes, arguments in self._includes:
            if not self._around.may_spend(len(values)):
                break
            file = self._text(attributes.get("file", ""), values).rpartition("/")[2]
            has_all = not self._is_ros_1 or attributes.get("pass_all_args") == "true"
            passed = dict(values) if has_all else {}
            for one in arguments:
                if "name" in one and "value" in one:
                    passed[one["name"]] = self._text(one["value"], values)
            yield _Use(file, {name: value for name, value in passed.items() if _UNKNOWN not in value})

    def _arguments(self, given: Mapping[str, str]) -> dict[str, str]:
        found = dict(given)
        for one in self._declared if self._around.may_spend(len(given) + len(self._declared)) else ():
            name, value = one.get("name"), one.get("value", one.get("default"))
            if name is not None and value is not None and ("value" in one or name not in given):
                found[name] = value if len(value) <= _LONGEST_VALUE else _UNKNOWN
        return found

    def _text(self, text: str, values: Mapping[str, str]) -> str:
        for _ in range(_DEEPEST):
            if len(text) > _LONGEST or not self._around.may_spend(len(text)):
                return _UNKNOWN
            text, changed = _REFERENCE.subn(lambda match: values.get(match[1], _UNKNOWN), text)
            if not changed:
                break
        return self._around.resolved(text)


def _unescaped(text: str) -> str:
    if "&" not in text:
        return text
    from html import unescape

    return unescape(text)


def _attributes(text: str) -> dict[str, str]:
    return {key: _unescaped(double or single) for key, double, single in _ATTRIBUTE.findall(text)}


# Launch files in Python.


_WRAPPERS = frozenset(
    (
        "AnyLaunchDescriptionSource",
        "FindExecutable",
        "ParameterValue",
        "PythonLaunchDescriptionSource",
        "TextSubstitution",
        "XMLLaunchDescriptionSource",
        "str",
    )
)
"""Calls that give the text of what they are given."""


class _Python:
    """A launch file in Python: the values of the names in it, as far as its text alone says them."""

    __slots__ = (
        "_around",
        "_calls",
        "_defaults",
        "_given",
        "_has_expander",
        "_is_expander",
        "_is_text",
        "_source",
        "_starts",
        "_values",
    )

    def __init__(self, tree: ast.AST, around: _Surroundings, source: Source) -> None:
        self._around = around
        self._source = source
        self._starts: list[int] = []
        self._has_expander = _EXPANDER.search(source.text) is not None
        self._given: Mapping[str, str] = {}
        self._calls = [node for node in ast.walk(tree) if isinstance(node, ast.Call)]
        called = set(map(_called, self._calls))
        self._is_text = "ParameterValue" in called
        self._is_expander = "process_doc" in called
        """Does it expand what it opens (``xacro.process_doc(xacro.parse(open(FILE)))``)?"""
        self._values: dict[str, ast.expr] = {}
        for node in ast.walk(tree):
            if (
                isinstance(node, ast.Assign)
                and len(node.targets) == 1
                and isinstance(node.targets[0], ast.Name)
            ):
                self._values.setdefault(node.targets[0].id, node.value)
        self._defaults: dict[str, ast.expr] = {}
        for call in self._calls:
            if _called(call) == "DeclareLaunchArgument":
                named = {keyword.arg: keyword.value for keyword in call.keywords}
                name = call.args[0] if call.args else named.get("name")
                if isinstance(name, ast.Constant) and "default_value" in named:
                    self._defaults.setdefault(str(name.value), named["default_value"])

    @classmethod
    def read(cls, source: Source, around: _Surroundings) -> _Python | None:
        """The launch file of a text, None if it cannot be read."""
        try:
            return cls(syntax_tree(source.text, "exec"), around, source)
        except (SyntaxError, ValueError, RecursionError, MemoryError):
            return None

    def uses(self, given: Mapping[str, str]) -> Iterator[_Use]:
        self._given = given
        for call in self._calls:
            name = _called(call)
            if name == "Command" and call.args:
                command = self._around.resolved(self._text(call.args[0]))
                fault = self._fault("joined", call) if _JOINED.match(command) else None
                yield from _of_command(command, is_text=self._is_text, fault=fault)
            elif name == "ExecuteProcess":
                yield from self._of_process(call)
            elif name in {"process_file", "process"} and call.args:
                mappings = next((each.value for each in call.keywords if each.arg == "mappings"), None)
                yield from self._of_pairs(call.args[0], mappings or ast.Dict([], []), {})
            elif name == "open" and call.args:
                file = self._text(call.args[0]).rpartition("/")[2]
                if file.endswith((".urdf", ".xacro")) and _UNKNOWN not in file:
                    is_raw = file.endswith(".xacro") and not self._is_expander and not self._has_expander
                    fault = self._fault("read", call) if is_raw else None
                    yield _Use(file, {}, is_expanded=self._is_expander, fault=fault)

    def _fault(self, kind: str, call: ast.Call) -> LaunchFault:
        """A fault at the line of a call."""
        if not self._starts:
            lengths = (len(line) + 1 for line in self._source.text.split("\n"))
            self._starts = list(accumulate(lengths, initial=0))
        at = min(call.lineno, len(self._starts) - 1)
        line = self._source.text[self._starts[at - 1] : self._starts[at]]
        start = self._starts[at - 1] + len(line) - len(line.lstrip())
        return LaunchFault(kind, Span(self._source, start, start + len(line.strip())))

    def _of_process(self, call: ast.Call) -> Iterator[_Use]:
        """The use in a process that runs xacro itself, up to a pipe."""
        words = next((each.value for each in call.keywords if each.arg == "cmd"), None)
        command = " ".join(map(self._text, words.elts)) if isinstance(words, ast.List) else ""
        if command.startswith("xacro "):
            yield from _of_command(self._around.resolved(command.partition("|")[0]), is_text=True)

    def included(self, given: Mapping[str, str]) -> Iterator[_Use]:
        self._given = given
        for call in self._calls:
            if _called(call) == "IncludeLaunchDescription" and call.args:
                passed = next((each.value for each in call.keywords if each.arg == "launch_arguments"), None)
                known = {
                    name: self._around.resolved(self._text(value)) for name, value in self._defaults.items()
                }
                yield from self._of_pairs(call.args[0], passed or ast.Dict([], []), {**known, **given})

    def _of_pairs(self, file: ast.expr, pairs: ast.expr, known: Mapping[str, str]) -> Iterator[_Use]:
        """The use of a file with ``known`` arguments and those of a dictionary, or of its items."""
        name = self._text(file).rpartition("/")[2]
        if (
            isinstance(pairs, ast.Call)
            and isinstance(pairs.func, ast.Attribute)
            and pairs.func.attr == "items"
        ):
            pairs = pairs.func.value
        if isinstance(pairs, ast.Name):
            pairs = self._values.get(pairs.id, pairs)
        is_known = name and _UNKNOWN not in name and self._around.may_spend(len(known))
        if is_known and isinstance(pairs, ast.Dict):
            both = zip(pairs.keys, pairs.values, strict=True)
            texts = {
                self._text(key): self._around.resolved(self._text(value))
                for key, value in both
                if key is not None
            }
            yield _Use(name, {k: v for k, v in {**known, **texts}.items() if _UNKNOWN not in k + v})

    def _text(self, node: ast.expr, depth: int = 0) -> str:
        """The text that an expression or substitution gives; unknown parts are one character."""
        if depth > _DEEPEST or not self._around.may_spend(0):
            return _UNKNOWN

        def inner(node: ast.expr) -> str:
            return self._text(node, depth + 1)

        found = _UNKNOWN
        if isinstance(node, ast.Constant):
            found = str(node.value)
        elif isinstance(node, ast.List | ast.Tuple):
            found = "".join(map(inner, node.elts))
        elif isinstance(node, ast.Name) and node.id in self._values:
            found = inner(self._values[node.id])
        elif isinstance(node, ast.BinOp) and isinstance(node.op, ast.Add):
            found = inner(node.left) + inner(node.right)
        elif isinstance(node, ast.JoinedStr):
            found = "".join(map(inner, node.values))
        elif isinstance(node, ast.FormattedValue):
            found = inner(node.value)
        elif isinstance(node, ast.Call):
            found = self._of_call(node, inner)
        return found if len(found) <= _LONGEST and self._around.may_spend(len(found)) else _UNKNOWN

    def _of_call(self, call: ast.Call, inner: Callable[[ast.expr], str]) -> str:
        name = _called(call)
        named = {keyword.arg: keyword.value for keyword in call.keywords}
        given = [*call.args, *named.values()]
        if name == "LaunchConfiguration" and given:
            wanted = inner(given[0])
            default = self._defaults.get(wanted, named.get("default"))
            return self._given.get(wanted, _UNKNOWN if default is None else inner(default))
        if name == "PathJoinSubstitution" and given and isinstance(given[0], ast.List | ast.Tuple):
            return "/".join(map(inner, given[0].elts))
        if name in {"join", "Path"}:  # of os.path
            return "/".join(map(inner, call.args))
        if name in _WRAPPERS and given:
            return inner(given[0])
        if name in {"FindPackageShare", "get_package_share_directory"} and given:
            return f"$(find {inner(given[0])})"
        return _computed(inner(given[0])) if name == "PythonExpression" and given else _UNKNOWN


def _computed(expression: str) -> str:
    """The text that an expression of Python gives, if it is made of texts; one that is not known equals no other."""
    try:
        tree = syntax_tree(expression.replace(_UNKNOWN, _NO_OTHER), "eval")
        value = _value(tree.body) if isinstance(tree, ast.Expression) else _UNKNOWN
    except (SyntaxError, ValueError, RecursionError, MemoryError, TypeError, KeyError):
        return _UNKNOWN
    return str(value).replace(_NO_OTHER, _UNKNOWN)


def _value(node: ast.expr) -> Any:
    """The value of a choice among texts; raises KeyError where an expression is something else."""
    match node:
        case ast.Constant(value=str() | bool() as value):
            return value
        case ast.IfExp(test=test, body=chosen, orelse=other):
            return _value(chosen if _value(test) else other)
        case ast.BoolOp(op=ast.And(), values=values):
            return all(map(_value, values))
        case ast.BoolOp(values=values):
            return any(map(_value, values))
        case ast.UnaryOp(op=ast.Not(), operand=operand):
            return not _value(operand)
        case ast.Compare(left=left, ops=[comparison], comparators=[right]):
            return _COMPARISONS[type(comparison)](_value(left), _value(right))
        case ast.Call(func=ast.Attribute(value=text, attr=method), args=given, keywords=[]):
            return _METHODS[method](_value(text), *map(_value, given))
    raise KeyError(type(node))


def _called(call: ast.Call) -> str:
    """The last name of the function that is called."""
    function = call.func
    return function.attr if isinstance(function, ast.Attribute) else getattr(function, "id", "")

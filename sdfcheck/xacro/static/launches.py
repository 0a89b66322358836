"""The arguments that launch files of a project give to its xacro files. Nothing of a launch file runs.

Launch files of ROS 1 and ROS 2 in XML hold a command line (``xacro FILE name:=value``), in which arguments of
the launch file (``$(arg name)``, ``$(var name)``) have their defaults. Those in Python make one of substitutions
(``Command(["xacro ", PathJoinSubstitution([...]), " name:=", LaunchConfiguration("name")])``), or call
``xacro.process_file(FILE, mappings={...})``; they are read as syntax trees. Where a value is not known, the
argument is left out.
"""

from __future__ import annotations

import ast
import re
from collections.abc import Callable, Iterator, Mapping
from html import unescape
from pathlib import Path

from sdfcheck.files.library import library_of
from sdfcheck.files.packages import Packages
from sdfcheck.files.regular import read_regular
from sdfcheck.source.document import Document
from sdfcheck.source.record import NamedTuple
from sdfcheck.xacro.language import LONGEST_CODE, syntax_tree

_SUFFIXES = ("launch", "launch.xml", "launch.py")
_FILE_LIMIT = 500
"""So many launch files of each kind are read."""
_MOST = 8
"""So many sets of arguments of one file are kept."""
_DEEPEST = 30
_LONGEST = 10_000
"""A text of a launch file with more characters is not known."""
_LONGEST_VALUE = 1_000
"""The same for the default of an argument, of which a text may hold many."""
_STEPS = 20_000
"""So many expressions of one launch file are looked at."""

_UNKNOWN = "\0"
_VALUE = re.compile(r"=\s*(?:\"([^\"]*)\"|'([^']*)')")
_DECLARED = re.compile(r"<(?:arg|let)\b([^<>]*)>")
_ATTRIBUTE = re.compile(r"\b(name|default|value)\s*=\s*(?:\"([^\"]*)\"|'([^']*)')")
_REFERENCE = re.compile(r"\$\((?:arg|var)\s+([^\s()]+)\s*\)")
_FOUND = re.compile(r"\$\(find[^()]*\)")
_OTHER = re.compile(r"\$\((?!command\b)[^()]*\)")
_GIVEN = re.compile(r"(?<!\w)(\w+):=(\"[^\"]*\"|'[^']*'|\S*)")


class _Use(NamedTuple):
    """The name of a file that is expanded, and what it is given."""

    file: str
    arguments: Mapping[str, str]


def launched_arguments(document: Document) -> tuple[Mapping[str, str], ...]:
    """The sets of arguments with which launch files of the project expand a xacro file, each once."""
    library = library_of(document)
    if library is None:
        return ()
    uses = library.of_project(document.path, _Launches).uses.get(document.path.name, ())
    found: list[Mapping[str, str]] = []
    for arguments in uses:
        if arguments and arguments not in found:
            found.append(arguments)
    return tuple(found[:_MOST])


class _Launches:
    """The uses of xacro files in the launch files of a project, by the names of the files."""

    __slots__ = ("uses",)

    def __init__(self, packages: Packages) -> None:
        self.uses: dict[str, list[Mapping[str, str]]] = {}
        for suffix in _SUFFIXES:
            for path in packages.files(suffix, _FILE_LIMIT):
                for use in _uses(path):
                    self.uses.setdefault(use.file, []).append(use.arguments)


def _uses(path: Path) -> Iterator[_Use]:
    try:
        text = read_regular(path, LONGEST_CODE).decode("utf-8", "replace")
    except OSError:
        return
    if "xacro" in text:
        yield from _in_python(text) if path.suffix == ".py" else _in_xml(text)


def _in_xml(text: str) -> Iterator[_Use]:
    declared: dict[str, str] = {}
    for match in _DECLARED.finditer(text):
        given = {key: unescape(double or single) for key, double, single in _ATTRIBUTE.findall(match[1])}
        value = given.get("value", given.get("default"))
        if "name" in given and value is not None and len(value) <= _LONGEST_VALUE:
            declared[given["name"]] = value

    def known(text: str) -> str:
        for _ in range(_DEEPEST):
            if len(text) > _LONGEST:
                return _UNKNOWN
            text, changed = _REFERENCE.subn(lambda match: declared.get(match[1], _UNKNOWN), text)
            if not changed:
                break
        return text

    for double, single in _VALUE.findall(text):
        command = unescape(double or single)
        if "xacro" in command:
            yield from _of_command(_OTHER.sub(_UNKNOWN, _FOUND.sub("", known(command))))


def _of_command(command: str) -> Iterator[_Use]:
    """The use in a command line: the file is the first word that ends as one, and arguments follow."""
    words = command.split()
    names = [word.strip("'\"()").rpartition("/")[2] for word in words if ":=" not in word]
    file = next((name for name in names if name.endswith((".xacro", ".urdf"))), "")
    if file and _UNKNOWN not in file:
        given = ((name, value.strip("'\"")) for name, value in _GIVEN.findall(command))
        yield _Use(file, {name: value.rstrip(")'\"") for name, value in given if _UNKNOWN not in value})


# Launch files in Python.


def _in_python(text: str) -> Iterator[_Use]:
    try:
        tree = syntax_tree(text, "exec")
        calls = [node for node in ast.walk(tree) if isinstance(node, ast.Call)]
        program = _Program(tree, calls)
        uses = [use for call in calls for use in program.uses(call)]
    except (SyntaxError, ValueError, RecursionError, MemoryError):
        return
    yield from uses


class _Program:
    """The values of the names in a launch file, as far as its text alone says them."""

    def __init__(self, tree: ast.AST, calls: list[ast.Call]) -> None:
        self._steps = _STEPS
        self._values: dict[str, ast.expr] = {}
        for node in ast.walk(tree):
            if (
                isinstance(node, ast.Assign)
                and len(node.targets) == 1
                and isinstance(node.targets[0], ast.Name)
            ):
                self._values.setdefault(node.targets[0].id, node.value)
        self._defaults: dict[str, ast.expr] = {}
        for call in calls:
            if _called(call) == "DeclareLaunchArgument":
                named = {keyword.arg: keyword.value for keyword in call.keywords}
                name = call.args[0] if call.args else named.get("name")
                if isinstance(name, ast.Constant) and "default_value" in named:
                    self._defaults.setdefault(str(name.value), named["default_value"])

    def uses(self, call: ast.Call) -> Iterator[_Use]:
        name = _called(call)
        if name == "Command" and call.args:
            yield from _of_command(self.text(call.args[0]))
        elif name in {"process_file", "process"} and call.args:
            file = self.text(call.args[0]).rpartition("/")[2]
            mappings = next((each.value for each in call.keywords if each.arg == "mappings"), None)
            mappings = self._values.get(mappings.id) if isinstance(mappings, ast.Name) else mappings
            if file and isinstance(mappings, ast.Dict):
                given = zip(mappings.keys, mappings.values, strict=True)
                texts = {self.text(key): self.text(value) for key, value in given if key is not None}
                yield _Use(file, {key: value for key, value in texts.items() if _UNKNOWN not in key + value})

    def text(self, node: ast.expr, depth: int = 0) -> str:
        """The text that an expression or substitution gives; unknown parts are one character."""
        self._steps -= 1
        if depth > _DEEPEST or self._steps < 0:
            return _UNKNOWN

        def inner(node: ast.expr) -> str:
            return self.text(node, depth + 1)

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
        return found if len(found) <= _LONGEST else _UNKNOWN

    def _of_call(self, call: ast.Call, inner: Callable[[ast.expr], str]) -> str:
        name = _called(call)
        named = {keyword.arg: keyword.value for keyword in call.keywords}
        given = [*call.args, *named.values()]
        if name == "LaunchConfiguration" and given:
            default = self._defaults.get(inner(given[0]), named.get("default"))
            return _UNKNOWN if default is None else inner(default)
        if name == "PathJoinSubstitution" and given and isinstance(given[0], ast.List | ast.Tuple):
            return "/".join(map(inner, given[0].elts))
        if name in {"join", "Path"}:  # of os.path
            return "/".join(map(inner, call.args))
        if name in {"TextSubstitution", "str", "ParameterValue"} and given:
            return inner(given[0])
        if name in {"FindExecutable", "FindPackageShare", "get_package_share_directory"} and given:
            return inner(given[0])
        return _UNKNOWN


def _called(call: ast.Call) -> str:
    """The last name of the function that is called."""
    function = call.func
    return function.attr if isinstance(function, ast.Attribute) else getattr(function, "id", "")

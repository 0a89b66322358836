"""Expanding a xacro file: the text, the document, or what was in the way, with its exact place."""

from __future__ import annotations

import os
import re
from collections.abc import Callable, Mapping
from pathlib import Path
from types import TracebackType
from typing import Any, TypeGuard

from sdfcheck.files.library import Surroundings as Places
from sdfcheck.files.packages import Packages, is_shared, project_root
from sdfcheck.files.regular import Bounds, note_read, read_named
from sdfcheck.source.decode import EncodingDefect
from sdfcheck.source.document import Document, read
from sdfcheck.source.problems import SyntaxDefect
from sdfcheck.source.record import NamedTuple
from sdfcheck.source.scanner.scan import parse_start_tag
from sdfcheck.source.scanner.start_tag import StartTag
from sdfcheck.source.sniff import Kind
from sdfcheck.source.text import Source, Span, Step
from sdfcheck.xacro.origins import Call, ExpandedDocument, Provenance, Sources, shown
from sdfcheck.xacro.problems import (
    ExpansionFailure,
    Failure,
    Mismatch,
    Problem,
    UndefinedMacro,
    UndefinedProperty,
    UnknownPackage,
    WrongMacroArguments,
    XacroIncludeCycle,
)
from sdfcheck.xacro.process.watch import Limits
from sdfcheck.xacro.process.worker import Worker

# From what the expanding process reports to a problem with an exact place.


Report = Mapping[str, Any]

_MISMATCHES = {
    "Invalid": Mismatch.UNKNOWN,
    "Undefined": Mismatch.MISSING,
    "Not": Mismatch.MISSING_BLOCK,
    "Unused": Mismatch.EXTRA_BLOCK,
}
_FAILURES: Mapping[str, Failure] = {
    "argument": Failure.ARGUMENT,
    "variable": Failure.VARIABLE,
    "limit": Failure.LIMIT,
    "refused": Failure.REFUSED,
    "other": Failure.EXPRESSION,
}


def explain(report: Report, provenance: Provenance, document: Document) -> Problem:
    """The problem that made an expansion fail."""
    case = _Case(report, provenance, document)
    kind: str = report["kind"]
    take: Callable[[_Case], Problem] | None = _TAKE.get(kind)
    if take is not None:
        return take(case)
    detail = str(report.get("name") or report.get("message") or "")
    failure = _FAILURES[kind]
    if failure is Failure.VARIABLE and detail in os.environ:
        failure = Failure.WITHHELD
    return ExpansionFailure(case.span(), failure, detail, str(report.get("expression", "")), case.origins)


class _Case:
    """A report, and the place that it speaks of."""

    def __init__(self, report: Report, provenance: Provenance, document: Document) -> None:
        self.report = report
        self.provenance = provenance
        self.source, self.at = self.place(document)
        self.tag: StartTag = parse_start_tag(self.source, self.at)[0]
        self.origins: tuple[Step, ...] = _shortened(provenance.steps(report.get("step", -1)))

    def place(self, document: Document) -> tuple[Source, int]:
        place = self.report.get("place")
        if place and place[0] < len(self.provenance.files) and place[1]:
            source = self.provenance.files[place[0]]
            at = source.offset(place[1], place[2])
            if source.text.startswith("<", at):
                return source, at
        scan = document.scan
        return document.source, scan.starts[0] if scan.starts else 0

    @property
    def name(self) -> Span:
        return self.source.span(self.tag.name_start, self.tag.name_end)

    def span(self, word: str = "") -> Span:
        """The smallest place known: the word in the expression, the expression, the value, the tag."""
        start, end = self.value()
        expression: str = self.report.get("expression", "")
        if expression:
            found = self.source.text.find(expression, start, end)
            if found < 0:
                start, end = self.at, self.reach()
                found = self.source.text.find(expression, start, end)
            if found < 0:
                return self.value_span()
            start, end = found, found + len(expression)
        if word:
            match = re.compile(rf"(?<![\w.]){re.escape(word)}(?!\w)").search(self.source.text, start, end)
            if match:
                return self.source.span(match.start(), match.end())
        return self.source.span(start, end) if expression else self.value_span()

    def value(self) -> tuple[int, int]:
        """The range of the attribute that is spoken of, else of the start tag after its name."""
        for attribute in self.tag.attributes:
            if attribute.name == self.report.get("attribute"):
                return attribute.value_start, attribute.value_end
        return self.tag.name_end, self.tag.end

    def value_span(self) -> Span:
        start, end = self.value()
        known = end != self.tag.end and start < end
        return self.source.span(start, end) if known else self.name

    def attribute(self, name: str) -> Span:
        for attribute in self.tag.attributes:
            if attribute.name == name:
                return self.source.span(attribute.name_start, attribute.name_end)
        return self.name

    def reach(self) -> int:
        """Where the element ends: the text inside may hold the expression."""
        scan = self.provenance.sources.scan(self.source)
        if self.at in scan.starts:
            return scan.close_ends[scan.starts.index(self.at)]
        return self.tag.end


def _shortened(steps: tuple[Step, ...], most: int = 12) -> tuple[Step, ...]:
    """A long chain without its middle."""
    return steps if len(steps) <= most else (*steps[: most // 2], *steps[-most // 2 :])


def _property(case: _Case) -> Problem:
    name = str(case.report["name"])
    return UndefinedProperty(case.span(name), name, None, case.origins)


def _macro(case: _Case) -> Problem:
    attribute = "macro" if case.tag.name == "xacro:call" else ""
    span = case.name
    if attribute:
        span = case.value_span()
    elif ":" in span.text:
        span = case.source.span(span.start + span.text.index(":") + 1, span.end)
    return UndefinedMacro(span, str(case.report["name"]), None, case.origins)


def _package(case: _Case) -> Problem:
    name = str(case.report["name"])
    return UnknownPackage(case.span(name), name, None, case.origins)


def _file(case: _Case) -> Problem:
    detail = f"{case.report['name']}: {case.report['message']}"
    expression = case.report.get("expression", "")
    return ExpansionFailure(case.span(), Failure.FILE, detail, expression, case.origins)


def _syntax(case: _Case) -> Problem:
    file, line, column = case.report["at"]
    source = case.provenance.files[file]
    start = source.offset(line, column)
    fault = source.span(start, start + 1)
    detail = str(case.report["message"])
    if not case.report.get("place"):  # the file itself: no include was under way
        return ExpansionFailure(fault, Failure.TEXT, detail, cause=fault)
    document = Document(source, Kind.XACRO, [])
    if case.report.get("is_undecoded"):
        document = read(read_named(source.path), source.path, Kind.XACRO)
    defects = (each.span for each in document.problems if isinstance(each, (SyntaxDefect, EncodingDefect)))
    cause = next(defects, fault)
    return ExpansionFailure(case.span(), Failure.SYNTAX, detail, origins=case.origins, cause=cause)


def _recursion(case: _Case) -> Problem:
    name = str(case.report["name"])
    if case.report["what"] == "include":
        return XacroIncludeCycle(case.value_span(), name, (), case.origins)
    return ExpansionFailure(case.name, Failure.RECURSION, name, "", case.origins)


def _arguments(case: _Case) -> Problem:
    report = case.report
    kind = _MISMATCHES[report["what"]]
    names = tuple(map(str, report["names"]))
    span = case.attribute(names[0]) if kind is Mismatch.UNKNOWN else case.name
    definition = None
    if report.get("definition"):
        definition = case.provenance.name_at(*report["definition"])
    parameters = tuple(map(str, report["parameters"]))
    return WrongMacroArguments(span, str(report["macro"]), kind, names, parameters, definition, case.origins)


_TAKE: Mapping[str, Callable[[_Case], Problem]] = {
    "property": _property,
    "macro": _macro,
    "package": _package,
    "file": _file,
    "syntax": _syntax,
    "recursion": _recursion,
    "arguments": _arguments,
}

PASSED_ON = tuple(
    """
    AMENT_PREFIX_PATH GZ_VERSION IGNITION_VERSION ROS_DISTRO ROS_PACKAGE_PATH ROS_PYTHON_VERSION
    ROS_VERSION
    """.split()
)
"""The environment variables that an expansion sees, in addition to those that are asked for."""


class Surroundings(NamedTuple):
    """The resources outside its file that an expansion may use.

    ``packages`` maps names to folders; below ``package_paths`` packages are looked for;
    ``variables`` names environment variables to pass on. ``root`` is the project, below
    which files may be read; it is worked out for each file if it is not given. ``texts``
    are taken in place of what the files at those (absolute) paths hold.
    """

    packages: Mapping[str, Path] = {}
    package_paths: tuple[Path, ...] = ()
    variables: tuple[str, ...] = ()
    root: Path | None = None
    limits: Limits = Limits()
    texts: Mapping[str, str] = {}

    @property
    def environment(self) -> dict[str, str]:
        names = (*PASSED_ON, *self.variables)
        return {name: os.environ[name] for name in names if name in os.environ}


class Expansion(NamedTuple):
    """The outcome: a text and its document, or problems; both, where a part was expanded.

    ``files`` are those that were read, the file itself first; ``arguments`` the names
    of those that the file takes or was given.
    """

    text: str | None
    document: ExpandedDocument | None
    problems: tuple[Problem, ...]
    files: tuple[Path, ...]
    arguments: tuple[str, ...] = ()

    def obstacle(self, path: Path) -> str:
        """The reason that keeps xacro from expanding the file, with the place, if it is known."""
        if not self.problems:
            return f"{path} cannot be expanded"
        first, span = self.problems[0], self.problems[0].span
        what = f"`{span.text}` cannot be expanded"
        if isinstance(first, UnknownPackage):
            what = f"package `{first.name}` is not found"
        wanted = (f"`{each.detail}:=…`" for each in self.problems if _is_missing_argument(each))
        if _is_missing_argument(first):
            what = f"arguments without a value: {', '.join(dict.fromkeys(wanted))}"
        return f"{span.source.path}:{span.begin.line}:{span.begin.column}: {what}"


class Expander:
    """Expands files in a process of its own, which is started when it is first needed.

    Use it as a context manager, or close it.
    """

    def __init__(self, surroundings: Surroundings | None = None) -> None:
        self.surroundings = surroundings or Surroundings()
        self._worker = Worker()
        self._packages: dict[Path, Packages] = {}

    def __enter__(self) -> Expander:
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        self.close()

    def close(self) -> None:
        self._worker.close()

    def start(self) -> None:
        """Let the process get ready while the caller has other things to do."""
        self._worker.start()

    def packages_for(self, path: Path) -> Packages:
        """The packages that the file at ``path`` may name."""
        root = self.surroundings.root or project_root(path)
        if root not in self._packages:
            around = self.surroundings
            is_flat = around.root is None and is_shared(root)
            self._packages[root] = Packages(
                root, around.packages, around.package_paths, around.environment, is_flat=is_flat
            )
        return self._packages[root]

    def expand(self, document: Document, arguments: Mapping[str, str] | None = None) -> Expansion:
        """Expand a xacro document; ``arguments`` are what ``$(arg …)`` gives."""
        done = self._expand(document, arguments, is_partial=False)
        lacking = {problem.detail for problem in done.problems if _is_missing_argument(problem)}
        if not lacking:
            return done
        from sdfcheck.xacro.static.definitions import missing_arguments

        others = missing_arguments(document, {*lacking, *(arguments or {})})
        return done._replace(problems=(*done.problems, *others))

    def expand_partly(self, document: Document, arguments: Mapping[str, str] | None = None) -> Expansion:
        """Expand what can be expanded of a document that xacro refuses; the problems are what stops xacro.

        An expression that has no value stays in it as a text, ``${…}`` or ``$(…)``, and so does all that
        depends on it: elements of xacro's that are left have their names. Elements and calls that lack the
        prefix of xacro are taken as if they had it.
        """
        return self._expand(document, arguments, is_partial=True)

    def _expand(
        self, document: Document, arguments: Mapping[str, str] | None, *, is_partial: bool
    ) -> Expansion:
        packages = self.packages_for(document.path)
        texts = self.surroundings.texts
        answer = self._ask(
            packages,
            path=str(document.path),
            text=document.source.text,
            arguments=dict(arguments or {}),
            partial=is_partial,
            unprefixed=_unprefixed(document) if is_partial else [],
            texts=dict(texts),
        )
        try:
            return _expansion(answer, document, texts, _readable(packages))
        except (
            KeyError,
            IndexError,
            TypeError,
            ValueError,
            AttributeError,
        ):  # code in a file has got at the answer
            refusal = {
                "kind": "refused",
                "message": "the answer of the process that expands is not as it must be",
            }
            return _expansion({"failure": refusal, "files": [], "steps": []}, document, {}, None)

    def walls(self) -> Mapping[str, bool]:
        """The parts of the system that lock an expansion up, and whether they do so here."""
        here = Path.cwd()
        answer = self._ask(
            Packages(here), path="", text="", arguments={}, partial=False, unprefixed=[], texts={}
        )
        walls: Mapping[str, bool] = answer["walls"]
        return walls

    def _ask(self, packages: Packages, **wanted: Any) -> Mapping[str, Any]:
        request = {
            "root": str(packages.root),
            "packages": {name: os.path.abspath(folder) for name, folder in packages.given.items()},
            "paths": [os.path.abspath(folder) for folder in packages.paths],
            "environment": packages.environment,
            "flat": packages.is_flat,
            "cwd": os.getcwd(),
        }
        return self._worker.ask({**request, **wanted}, self.surroundings.limits)


def expand(
    what: Document | Path,
    arguments: Mapping[str, str] | None = None,
    surroundings: Surroundings | None = None,
) -> Expansion:
    """Expand one file; :class:`Expander` is the cheaper way for several.

    Raises:
        OSError: the file cannot be read.
    """
    document = what if isinstance(what, Document) else read(read_named(what), what, Kind.XACRO)
    with Expander(surroundings) as expander:
        return expander.expand(document, arguments)


def _unprefixed(document: Document) -> list[tuple[str, int, int]]:
    """The file, line and column of each element that a document uses without the prefix of xacro."""
    from sdfcheck.xacro.static.definitions import visible_definitions
    from sdfcheck.xacro.static.likely_mistakes import missing_prefixes

    files = [read.document for read in visible_definitions(document).readings]
    names = (
        span
        for file in files
        for problem in missing_prefixes(file)
        for span in (problem.span, *problem.others)
    )
    return [(os.path.abspath(name.source.path), name.begin.line, name.begin.column - 1) for name in names]


def _is_missing_argument(problem: Problem) -> TypeGuard[ExpansionFailure]:
    return isinstance(problem, ExpansionFailure) and problem.kind is Failure.ARGUMENT


def _readable(packages: Packages) -> Bounds:
    """The places that the process that expands may read from."""
    trusted = [os.fspath(folder) for folder in packages.trusted()]
    roots = (*map(os.fspath, packages.places), *map(os.fspath, packages.installed()), *trusted)
    return Places(tuple(map(os.path.realpath, roots)), tuple(map(os.path.abspath, trusted)), ())


def _expansion(
    answer: Mapping[str, Any], document: Document, texts: Mapping[str, str], within: Bounds | None
) -> Expansion:
    """The outcome that an answer reports; raises one of several errors for an answer that is not as it must be."""
    files: list[str] = [*answer["files"]]
    others: list[str] = [*answer.get("others", ())]
    if any("\0" in name for name in (*files, *others)):
        raise ValueError
    calls = [Call(*row) for row in answer["steps"]]
    for number, call in enumerate(calls):
        _check([call.file, call.line, call.column, call.outer], len(files), number)
    sources = Sources(document.source, texts, within)
    read_files = tuple(dict.fromkeys(shown(Path(name)) for name in (*files, *others)))
    note_read(map(Path, (*files, *others)))
    if "failure" in answer:
        provenance = Provenance(sources, files, calls, [])
        found = explain(answer["failure"], provenance, document)
        return Expansion(None, None, (found,), read_files)
    text: str = answer["text"]
    places: list[int] = answer["places"]
    _check(places, len(files), len(calls))
    provenance = Provenance(sources, files, calls, places)
    expanded = ExpandedDocument(Source(document.path, text), provenance)
    if len(places) < 4 * len(expanded.elements):
        raise ValueError
    problems = tuple(explain(failure, provenance, document) for failure in answer.get("failures", ()))
    return Expansion(text, expanded, problems, read_files, tuple(map(str, answer["arguments"])))


def _check(places: list[int], files: int, steps: int) -> None:
    """Raise ValueError unless each four numbers are a file, a line, a column, and a step or -1."""
    if not places:
        return
    file, line, column, step = (places[start::4] for start in range(4))
    is_right = set(map(type, places)) == {int} and min(file) >= 0 and max(file) < files
    is_right = is_right and min(line) > 0 and min(column) > 0 and min(step) >= -1 and max(step) < steps
    if not is_right:
        raise ValueError

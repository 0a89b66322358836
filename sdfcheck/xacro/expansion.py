"""Expanding a xacro file: the text, the document, or what was in the way."""

from __future__ import annotations

import os
from collections.abc import Mapping, Sequence
from pathlib import Path
from types import TracebackType
from typing import Any, TypeGuard

from sdfcheck.files.packages import Packages, project_root
from sdfcheck.files.regular import note_read, read_named
from sdfcheck.source.document import Document, read
from sdfcheck.source.record import NamedTuple
from sdfcheck.source.sniff import Kind
from sdfcheck.source.text import Source
from sdfcheck.xacro.explanation import explain
from sdfcheck.xacro.origins import Call, ExpandedDocument, Provenance, Sources, shown
from sdfcheck.xacro.problems import ExpansionFailure, Failure, Problem
from sdfcheck.xacro.process.watch import Limits
from sdfcheck.xacro.process.worker import Worker

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
    """The outcome: a text and its document, or problems.

    ``files`` are those that were read, the file itself first; ``arguments`` the names
    of those that the file takes or was given.
    """

    text: str | None
    document: ExpandedDocument | None
    problems: tuple[Problem, ...]
    files: tuple[Path, ...]
    arguments: tuple[str, ...] = ()


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
            self._packages[root] = Packages(root, around.packages, around.package_paths, around.environment)
        return self._packages[root]

    def expand(self, document: Document, arguments: Mapping[str, str] | None = None) -> Expansion:
        """Expand a xacro document; ``arguments`` are what ``$(arg …)`` gives."""
        done = self._expand(document, arguments, is_partial=False)
        lacking = {problem.detail for problem in done.problems if _is_missing_argument(problem)}
        if not lacking:
            return done
        from sdfcheck.xacro.static.arguments import missing_arguments

        others = missing_arguments(document, {*lacking, *(arguments or {})})
        return done._replace(problems=(*done.problems, *others))

    def expand_partly(self, document: Document, arguments: Mapping[str, str] | None = None) -> Expansion:
        """Expand a document without the packages that are not found, as far as the rest does not need them.

        Includes from them, and calls of macros that nothing else defines, stay in it as they are.
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
            texts=dict(texts),
        )
        try:
            return _expansion(answer, document, texts)
        except (KeyError, IndexError, TypeError, ValueError):  # code in a file has got at the answer
            refusal = {
                "kind": "refused",
                "message": "the answer of the process that expands is not as it must be",
            }
            return _expansion({"failure": refusal, "files": [], "steps": []}, document, {})

    def walls(self) -> Mapping[str, bool]:
        """The parts of the system that lock an expansion up, and whether they do so here."""
        here = Path.cwd()
        answer = self._ask(Packages(here), path="", text="", arguments={}, partial=False, texts={})
        walls: Mapping[str, bool] = answer["walls"]
        return walls

    def _ask(self, packages: Packages, **wanted: Any) -> Mapping[str, Any]:
        request = {
            "root": str(packages.root),
            "packages": {name: os.path.abspath(folder) for name, folder in packages.given.items()},
            "paths": [os.path.abspath(folder) for folder in packages.paths],
            "environment": packages.environment,
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


def _is_missing_argument(problem: Problem) -> TypeGuard[ExpansionFailure]:
    return isinstance(problem, ExpansionFailure) and problem.kind is Failure.ARGUMENT


def _expansion(answer: Mapping[str, Any], document: Document, texts: Mapping[str, str]) -> Expansion:
    files: Sequence[str] = answer["files"]
    calls = [Call(*row) for row in answer["steps"]]
    sources = Sources(document.source, texts)
    read_files = tuple(dict.fromkeys(shown(Path(name)) for name in (*files, *answer.get("others", ()))))
    note_read(map(Path, (*files, *answer.get("others", ()))))
    if "failure" in answer:
        provenance = Provenance(sources, files, calls, [])
        found = explain(answer["failure"], provenance, document)
        return Expansion(None, None, (found,), read_files)
    text: str = answer["text"]
    provenance = Provenance(sources, files, calls, answer["places"])
    expanded = ExpandedDocument(Source(document.path, text), provenance)
    return Expansion(text, expanded, (), read_files, tuple(answer["arguments"]))

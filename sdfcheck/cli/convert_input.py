"""What a conversion starts from: the document, expanded if it is xacro, and the errors in it."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from types import TracebackType
from typing import TYPE_CHECKING, NamedTuple

from sdfcheck.cli.terminal import pair
from sdfcheck.lint.config import Configuration, Settings
from sdfcheck.lint.diagnostic import Diagnostic, Severity
from sdfcheck.lint.engine import Dispatch, lint_document
from sdfcheck.lint.packs import load_index
from sdfcheck.lint.select import ActiveRules
from sdfcheck.source.library import Library, SearchPaths
from sdfcheck.source.sniff import Kind, sniff
from sdfcheck.source.wrong_usage import WrongUsage

if TYPE_CHECKING:
    from sdfcheck.source.document import Document
    from sdfcheck.source.xacro.expansion import Expander

_OF_OTHERS = frozenset({"RES", "DRK"})
"""Families whose errors are about files that are not there, or one program's limits: no obstacle."""


class Input(NamedTuple):
    """A file as it was read; with ``diagnostics`` it is not to be converted."""

    file: Path
    document: Document | None
    diagnostics: Sequence[Diagnostic] = ()


class Reader:
    """Reads the inputs of one run. Use it as a context manager: it may start a process to expand xacro."""

    def __init__(
        self,
        config: Path | None,
        isolated: bool,
        arguments: Sequence[str],
        *,
        lint: bool = True,
        tolerated: frozenset[str] = frozenset(),
    ) -> None:
        self._tolerated = _OF_OTHERS | tolerated
        self._configuration = Configuration(config, isolated=isolated)
        self._arguments = dict(pair(text, ":=", "name:=value") for text in arguments)
        self._lint = lint
        self._expander: Expander | None = None

    def __enter__(self) -> Reader:
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        if self._expander is not None:
            self._expander.close()

    def read(self, file: Path, kinds: Mapping[Kind, str]) -> Input:
        """Read a file that must be of one of ``kinds``.

        Raises:
            WrongUsage: it does not exist, cannot be read or is of another kind.
        """
        settings = self._configuration.settings_for(file)
        library = Library(SearchPaths(settings.model_paths, settings.package_paths, settings.packages))
        try:
            data = file.read_bytes()
        except OSError as error:
            raise WrongUsage(f"{file} cannot be read: {error.strerror}") from None
        kind = sniff(data, file)
        from sdfcheck.source.document import read

        document = read(data, file, None if kind is Kind.BROKEN_XML else kind)
        document.library = library
        if document.kind is Kind.XACRO and Kind.URDF in kinds:
            expanded, problems = self._expand(document, settings)
            if expanded is None:
                document.problems = [*document.problems, *problems]  # type: ignore[list-item]
                return Input(file, None, self._errors(document))
            document = expanded
        if document.kind not in kinds or document.root is None:
            names = " or ".join(kinds.values())
            raise WrongUsage(f"{file} looks like {document.kind.description}, not like {names}")
        return Input(file, document, self._errors(document) if self._lint else ())

    def _expand(self, document: Document, settings: Settings) -> tuple[Document | None, Sequence[object]]:
        from sdfcheck.source.xacro.expansion import Expander, Surroundings

        if self._expander is None:
            self._expander = Expander(Surroundings(dict(settings.packages), settings.package_paths))
        sets = settings.arguments_for(document.path)
        chosen = {**(dict(sets[0]) if sets else {}), **self._arguments}
        done = self._expander.expand(document, chosen)
        if done.document is not None:
            done.document.library = document.library
        return done.document, done.problems

    def _errors(self, document: Document) -> list[Diagnostic]:
        """The errors that make a conversion pointless."""
        index = load_index()
        found = lint_document(document, Dispatch(index, ActiveRules(index.facts, {})))
        return [
            one
            for one in found
            if one.severity is Severity.ERROR and one.code.rstrip("0123456789") not in self._tolerated
        ]

"""What a conversion starts from: the document, expanded if it is xacro, and the errors in it."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from types import TracebackType
from typing import TYPE_CHECKING

from sdfcheck.cli.descriptions import Around, chosen_arguments, expander_for
from sdfcheck.files.library import Library, SearchPaths
from sdfcheck.files.regular import read_regular
from sdfcheck.lint.config.configuration import Settings
from sdfcheck.lint.diagnostic import Diagnostic, Severity
from sdfcheck.lint.engine import lint_document
from sdfcheck.lint.obstacles import obstacles
from sdfcheck.lint.rulebook.rulebook import RuleBook
from sdfcheck.lint.select import SILENT
from sdfcheck.source.record import NamedTuple
from sdfcheck.source.sniff import Kind, sniff
from sdfcheck.source.wrong_usage import WrongUsage

if TYPE_CHECKING:
    from sdfcheck.source.document import Document
    from sdfcheck.xacro.expansion import Expander

_ELSEWHERE = frozenset({"RES"})
"""Families whose errors are about other files, which a conversion can do without."""


class Input(NamedTuple):
    """A file as it was read, and the errors in it; if they stop the conversion, ``is_sound`` is false."""

    file: Path
    document: Document | None
    errors: Sequence[Diagnostic] = ()
    is_sound: bool = True


class Reader:
    """Reads the inputs of one run. Use it as a context manager: it may start a process to expand xacro."""

    def __init__(self, around: Around, *, lint: bool = True) -> None:
        self._book = RuleBook(SILENT, None)
        self._around = around
        self._lint = lint
        self._libraries: dict[SearchPaths, Library] = {}
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
            WrongUsage: it does not exist, cannot be read, is of another kind or brings too many models.
        """
        settings = self._around.settings_for(file)
        search = settings.search
        # Shared, so that what lies around the files is looked up once.
        library = self._libraries.setdefault(search, Library(search, settings.size_limit))
        try:
            data = read_regular(file, settings.size_limit)
        except OSError as error:
            raise WrongUsage(f"{file} cannot be read: {error.strerror}") from None
        kind = sniff(data, file)
        from sdfcheck.robot.includes.multiplied import refuse_too_many
        from sdfcheck.source.document import read

        document = read(data, file, None if kind is Kind.BROKEN_XML else kind)
        document.library = library
        if document.kind is Kind.XACRO and Kind.URDF in kinds:
            expanded, problems = self._expand(document, settings)
            if expanded is None:
                document.problems = [*document.problems, *problems]  # type: ignore[list-item]
                return self._judged(document, settings)._replace(document=None, is_sound=False)
            document = expanded
        if document.kind not in kinds or document.root is None:
            names = " or ".join(kinds.values())
            raise WrongUsage(f"{file} looks like {document.kind.description}, not like {names}")
        refuse_too_many(document)
        return self._judged(document, settings) if self._lint else Input(file, document)

    def _expand(self, document: Document, settings: Settings) -> tuple[Document | None, Sequence[object]]:
        if self._expander is None:
            self._expander = expander_for(settings)
        done = self._expander.expand(document, chosen_arguments(document.path, settings, self._around))
        if done.document is not None:
            done.document.library = document.library
        return done.document, done.problems

    def _judged(self, document: Document, settings: Settings) -> Input:
        """A document with the errors that the configured rules find in it."""
        file = document.path
        found = lint_document(document, self._book.dispatch(settings, file))
        errors = [one for one in found if one.severity is Severity.ERROR]
        stopping = obstacles(errors, document.kind, _ELSEWHERE)
        return Input(file, document, errors, not stopping)

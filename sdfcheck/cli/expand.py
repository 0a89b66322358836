"""``sdfcheck expand``."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from sdfcheck.cli.parts.command import Command
from sdfcheck.cli.parts.descriptions import (
    SearchContext,
    around,
    check_arguments,
    chosen_arguments,
    described,
    expander_for,
)
from sdfcheck.cli.parts.options import require_file, written
from sdfcheck.cli.parts.output import deliver
from sdfcheck.cli.parts.terminal import say
from sdfcheck.source.errors import WrongUsage
from sdfcheck.source.sniff import Kind

if TYPE_CHECKING:
    from collections.abc import Sequence

    from sdfcheck.lint.diagnostic import Diagnostic
    from sdfcheck.source.document import Document
    from sdfcheck.xacro.expansion import Expansion


@click.command(cls=Command)
@click.argument("file", type=click.Path(path_type=Path))
@click.option("--annotate", is_flag=True, help="Say in comments where each element was written.")
@written()
@described
def expand(file: Path, annotate: bool, output_file: Path | None, **given: Any) -> int:
    """Expand a xacro file.

    The expansion runs in a process of its own that can do nothing but compute and read
    the project's files.
    """
    require_file(file)
    document, outcome = _expand(file, around(given))
    if outcome.document is None or outcome.text is None:
        from sdfcheck.source.problems import SyntaxDefect
        from sdfcheck.xacro.prepare import stops
        from sdfcheck.xacro.static import analysis

        # As lint does: what can be read in the file explains more than what xacro says of it.
        found = [problem for problem in analysis.problems(document) if stops(problem)]
        is_broken = any(isinstance(problem, SyntaxDefect) for problem in document.problems)
        _report(_explained(document, () if is_broken else found or outcome.problems))
        return 1
    if annotate:
        from sdfcheck.xacro.origins import annotated

        deliver(annotated(outcome.document), output_file)
    else:
        deliver(outcome.text, output_file)
    return 0


def _expand(file: Path, around: SearchContext) -> tuple[Document, Expansion]:
    """Expand with what the command line and the configuration say; the command line has the last word."""
    settings = around.settings_for(file)
    with expander_for(settings) as expander:
        expander.start()
        from sdfcheck.files.library import Library
        from sdfcheck.files.regular import read_named
        from sdfcheck.source.document import read

        try:
            data = read_named(file, settings.size_limit)
        except OSError as error:
            raise WrongUsage(f"{file} cannot be read: {error.strerror}") from None
        document = read(data, file, Kind.XACRO)
        document.library = Library(settings.search)
        check_arguments(around.arguments, [file], settings)
        return document, expander.expand(document, chosen_arguments(file, settings, around))


def _explained(document: Document, problems: Sequence[object]) -> list[Diagnostic]:
    """The diagnostics of the problems that stopped the expansion."""
    from sdfcheck.lint.diagnostic import Severity
    from sdfcheck.lint.engine import Dispatch, lint_document
    from sdfcheck.lint.rulebook.packs import load_index
    from sdfcheck.lint.select import ActiveRules

    index = load_index()
    document.problems = [*document.problems, *problems]  # type: ignore[list-item]
    found = lint_document(document, Dispatch(index, ActiveRules(index.facts, {})))
    return [diagnostic for diagnostic in found if diagnostic.severity >= Severity.WARNING]


def _report(diagnostics: Sequence[Diagnostic]) -> None:
    for diagnostic in diagnostics:
        line, column = diagnostic.span.begin
        place = f"{diagnostic.span.source.path}:{line}:{column}"
        say(f"{place}: {diagnostic.severity.value}[{diagnostic.code}]: {diagnostic.message}")
        for origin in diagnostic.origins:
            at = origin.span.begin
            say(f"  {origin.span.source.path}:{at.line}:{at.column}: {origin.text}")
        if diagnostic.help:
            say(f"  help: {diagnostic.help}")

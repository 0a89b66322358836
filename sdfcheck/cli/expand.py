"""``sdfcheck expand``."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from sdfcheck.cli.options import configured, require_file
from sdfcheck.cli.terminal import emit, pair, say
from sdfcheck.source.record import NamedTuple
from sdfcheck.source.sniff import Kind
from sdfcheck.source.wrong_usage import WrongUsage

if TYPE_CHECKING:
    from collections.abc import Sequence

    from sdfcheck.lint.config.configuration import Configuration
    from sdfcheck.lint.diagnostic import Diagnostic
    from sdfcheck.source.document import Document
    from sdfcheck.xacro.expansion import Expansion


class Request(NamedTuple):
    """The command line, as click read it."""

    file: Path
    arguments: tuple[str, ...]
    packages: tuple[str, ...]
    package_paths: tuple[Path, ...]
    variables: tuple[str, ...]
    annotate: bool
    configuration: Configuration


@click.command()
@click.argument("file", type=click.Path(path_type=Path))
@click.argument("arguments", nargs=-1, metavar="[ARG:=VALUE]…")
@click.option("--package", "packages", multiple=True, metavar="NAME=PATH", help="Where a ROS package is.")
@click.option(
    "--package-path",
    "package_paths",
    multiple=True,
    type=click.Path(path_type=Path),
    metavar="FOLDER",
    help="A folder below which to look for packages.",
)
@click.option("--env", "variables", multiple=True, metavar="NAME", help="An environment variable to pass on.")
@click.option("--annotate", is_flag=True, help="Say in comments where each element was written.")
@configured
def expand(**given: Any) -> int:
    """Expand a xacro file to stdout.

    The expansion runs in a process of its own that can do nothing but compute and read
    the project's files.
    """
    request = Request(**given)
    require_file(request.file)
    document, outcome = _expand(request)
    if outcome.document is None or outcome.text is None:
        _report(_explained(document, outcome.problems))
        return 1
    if request.annotate:
        from sdfcheck.xacro.annotate import annotated

        emit(annotated(outcome.document))
    else:
        emit(outcome.text)
    return 0


def _expand(request: Request) -> tuple[Document, Expansion]:
    """Expand with what the command line and the configuration say; the command line has the last word."""
    from sdfcheck.files.library import Library, SearchPaths
    from sdfcheck.files.regular import read_regular
    from sdfcheck.source.document import read
    from sdfcheck.xacro.expansion import Expander, Surroundings

    file = request.file
    settings = request.configuration.settings_for(file)
    named = [pair(text, "=", "--package name=path") for text in request.packages]
    packages = {**dict(settings.packages), **{name: Path(path) for name, path in named}}
    paths = (*request.package_paths, *settings.package_paths)
    sets = settings.arguments_for(file)
    chosen = dict(sets[0]) if sets else {}
    chosen.update(pair(text, ":=", "name:=value") for text in request.arguments)
    try:
        data = read_regular(file, settings.size_limit)
    except OSError as error:
        raise WrongUsage(f"{file} cannot be read: {error.strerror}") from None
    document = read(data, file, Kind.XACRO)
    document.library = Library(SearchPaths((), paths, tuple(packages.items())))
    with Expander(Surroundings(packages, paths, request.variables)) as expander:
        return document, expander.expand(document, chosen)


def _explained(document: Document, problems: Sequence[object]) -> list[Diagnostic]:
    """What the rules say of the problems that stopped the expansion."""
    from sdfcheck.lint.diagnostic import Severity
    from sdfcheck.lint.engine import Dispatch, lint_document
    from sdfcheck.lint.packs import load_index
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

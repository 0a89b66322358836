"""The options of every command that reads a description: where things are, and arguments for xacro."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from sdfcheck.cli.parts.options import configured, settable, taken
from sdfcheck.cli.parts.terminal import pair, say
from sdfcheck.files.library import Library
from sdfcheck.report import OutputFormat
from sdfcheck.source.errors import WrongUsage
from sdfcheck.source.record import NamedTuple
from sdfcheck.source.sniff import Kind, sniff

if TYPE_CHECKING:
    from sdfcheck.cli.parts.output import Output
    from sdfcheck.lint.config.configuration import Configuration
    from sdfcheck.lint.config.settings import Settings
    from sdfcheck.lint.run import Run
    from sdfcheck.lint.session import Options
    from sdfcheck.report.content import Robot
    from sdfcheck.source.document import Document
    from sdfcheck.xacro.expansion import Expander

ARGUMENT = ":="
"""A sign that an argument for xacro has, and a path does not have."""


surroundings = settable("packages", "package_paths", "model_paths", "env")
"""Where things are."""


def described(command: Callable[..., Any]) -> Any:
    """Arguments for xacro, after the files; where things are; and which configuration counts."""
    command = surroundings(configured(command))
    return click.argument("arguments", nargs=-1, metavar="[ARG:=VALUE]…")(command)


class SearchContext(NamedTuple):
    """The options about the surroundings of descriptions."""

    configuration: Configuration
    arguments: tuple[tuple[str, str], ...] = ()

    def settings_for(self, file: Path) -> Settings:
        """The settings of a file."""
        return self.configuration.settings_for(file)


def around(given: dict[str, Any]) -> SearchContext:
    """Takes the shared options out of what click has read; the rest is the command's own.

    Raises:
        WrongUsage: an option names nothing.
    """
    return SearchContext(
        given.pop("configuration").with_given(taken(given)), arguments_in(given.pop("arguments"))
    )


def arguments_in(words: Iterable[str]) -> tuple[tuple[str, str], ...]:
    """Names and values of arguments for xacro."""
    return tuple(pair(word, ARGUMENT, "name:=value") for word in words)


def load(file: Path, around: SearchContext, *, check: bool = True, as_launched: bool = False) -> Document:
    """Read a description, expanded if it is xacro; ``check``: with arguments that it takes.

    ``as_launched``: where it lacks arguments, with those that a launch file of the project gives.

    Raises: WrongUsage: it is not a description, cannot be read or expanded, or brings too many
    models.
    """
    from sdfcheck.files.regular import read_named
    from sdfcheck.robot.includes.included import refuse_too_many

    settings = around.settings_for(file)
    if check:
        check_arguments(around.arguments, [file], settings)
    library = Library(settings.search, settings.size_limit)
    try:
        data = read_named(file, settings.size_limit)
    except OSError as error:
        raise WrongUsage(f"{file} cannot be read: {error.strerror}") from None
    kind = sniff(data, file)
    document = library.given(data, file, None if kind is Kind.BROKEN_XML else kind)
    if _is_launched_source(document):
        document = library.given(data, file, Kind.XACRO)
    if document.kind is Kind.XACRO:
        document = _expanded(document, settings, around, as_launched=as_launched)
    if document.root is None or document.kind not in {Kind.SDF, Kind.URDF}:
        raise WrongUsage(f"{file} looks like {kind.description}, not like a robot or world")
    refuse_too_many(document)
    return document


def _is_launched_source(document: Document) -> bool:
    from sdfcheck.xacro.prepare import is_launched_source

    return is_launched_source(document)


def load_unexpanded(file: Path, around: SearchContext) -> Document | None:
    """A file of URDF with elements of xacro as it is written: programs that read it leave them out.

    None for one whose name says that it is for xacro.
    """
    settings = around.settings_for(file)
    if file.suffix.lower() != ".urdf" or ".xacro" in file.name.lower():
        return None
    return Library(settings.search, settings.size_limit).document(file, Kind.URDF)


def warn_if_broken(*documents: Document) -> None:
    """Say on stderr where the text of a description is broken: what a command shows of it may not be all."""
    from sdfcheck.convert.new_errors import break_of

    for document in documents:
        if (span := break_of(document)) is not None:
            line, column = span.begin
            place = f"{document.path}:{line}:{column}"
            say(f"warning: {place}: the text is broken here, parts may be missing; `sdfcheck lint` says how")


def _expanded(
    document: Document, settings: Settings, around: SearchContext, *, as_launched: bool
) -> Document:
    from sdfcheck.xacro.prepare import expand_as_launched

    with expander_for(settings) as expander:
        chosen = chosen_arguments(document.path, settings, around)
        if as_launched:
            expansion = expand_as_launched(document, expander.expand, chosen)
        else:
            expansion = expander.expand(document, chosen)
    if expansion.document is None:
        obstacle = expansion.obstacle(document.path)
        raise WrongUsage(f"{obstacle}; `sdfcheck expand` says more")
    expansion.document.library = document.library
    return expansion.document


def expander_for(settings: Settings) -> Expander:
    """The expansion for files that have these settings."""
    from sdfcheck.xacro.expansion import Expander, Surroundings

    return Expander(Surroundings(dict(settings.packages), settings.package_paths, settings.env))


def chosen_arguments(file: Path, settings: Settings, around: SearchContext) -> dict[str, str]:
    """The arguments of a file: the first set of the configuration, and over it those of the command line."""
    sets = settings.arguments_for(file)
    return {**(dict(sets[0]) if sets else {}), **dict(around.arguments)}


def check_arguments(
    given: Iterable[tuple[str, str]],
    files: Iterable[Path],
    settings: Settings,
    texts: Mapping[Path, bytes] | None = None,
) -> None:
    """Make sure that some of the files take the arguments; says which do not seem to be taken.

    ``texts`` replace some of the files, such as stdin.

    Raises:
        WrongUsage: a name is misspelled.
    """
    names = [name for name, _ in given]
    if not names:
        return
    from sdfcheck.formats.near_names import nearest
    from sdfcheck.xacro.static.definitions import taken_arguments

    library = Library(settings.search, settings.size_limit)
    taken: set[str] = set()
    knows_all = True
    for file in files:
        document = _xacro(file, library, settings.size_limit, (texts or {}).get(file))
        if document is not None:
            own = taken_arguments(document)
            taken |= own.names
            knows_all &= own.is_complete
    for name in names:
        if name in taken:
            continue
        near = nearest(name, taken)
        if near is not None:
            raise WrongUsage(f"no file takes the argument `{name}`; did you mean `{near}`?")
        if knows_all:
            say(f"warning: no file takes the argument `{name}`")


def _xacro(file: Path, library: Library, limit: int, text: bytes | None) -> Document | None:
    from sdfcheck.files.regular import read_named
    from sdfcheck.source.document import read

    try:
        kind = sniff(read_named(file, limit) if text is None else text, file)
    except OSError:
        return None
    if kind is not Kind.XACRO:
        return None
    if text is None:
        return library.document(file, kind)
    document = read(text, file, kind)
    document.library = library
    return document


def robots_of(run: Run, wanted: Iterable[Output], options: Options) -> Sequence[Robot]:
    """The robots and worlds of a small run, in the order of its files; none if no report shows them.

    Where xacro is not expanded, the robots would not be what was linted.
    """
    if not options.expand or not any(output.format is OutputFormat.HTML for output in wanted):
        return ()
    from sdfcheck.report.formats.html import MOST_ROBOTS

    if len(run.files) > MOST_ROBOTS:
        return ()
    from sdfcheck.report.content import robots

    around = SearchContext(options.configuration, options.arguments)
    return list(robots(run, _documents(run, around)))


def _documents(run: Run, around: SearchContext) -> Iterator[tuple[Path, Document | str]]:
    """The files of a run, each read or with why not."""
    for file in run.files:
        if not os.path.isfile(file):
            yield file, "read from stdin"
            continue
        try:
            yield file, load(file, around, check=False)
        except WrongUsage:
            yield file, "not read; the findings say why"

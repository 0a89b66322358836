"""``sdfcheck graph``."""

from __future__ import annotations

import sys
from pathlib import Path
from typing import TYPE_CHECKING

import click

from sdfcheck.cli.options import colored, configured, formatted, require_file
from sdfcheck.cli.terminal import emit, emit_lines, lines_of, wants_color
from sdfcheck.robot import graph_text
from sdfcheck.robot.graphs import GraphKind, graph
from sdfcheck.source.sniff import Kind
from sdfcheck.source.wrong_usage import WrongUsage

if TYPE_CHECKING:
    from sdfcheck.lint.config.configuration import Configuration, Settings
    from sdfcheck.source.document import Document

_COLORS = {"kind": "cyan", "label": "yellow", "note": "bright_black"}


@click.command(name="graph")
@click.argument("kind", type=click.Choice([kind.value for kind in GraphKind]))
@click.argument("file", type=click.Path(path_type=Path))
@formatted(
    "A tree to read, or the language of Graphviz or Mermaid.  [default: tree]", "tree", "dot", "mermaid"
)
@configured
@colored("When to colour the tree.")
def graph_command(kind: str, file: Path, form: str, configuration: Configuration, color: str) -> int:
    """Show what is tied to what in an SDFormat, URDF or xacro file.

    \b
    frames  what moves with what
    poses   what is placed relative to what, and where in the world or model that is,
            all joints at zero: x y z (m) roll pitch yaw (rad)
    joints  which joint carries which link
    """
    require_file(file)
    try:
        drawn = graph(load(file, configuration.settings_for(file)), GraphKind(kind))
    except ValueError as error:
        from sdfcheck.robot.errors import DescriptionError

        if not isinstance(error, DescriptionError):
            raise
        line, column = error.element.span.begin
        raise WrongUsage(f"{file}:{line}:{column}: {error}") from None
    if form == "tree":
        colors = wants_color(color, sys.stdout)
        text = graph_text.tree(drawn, _paint if colors else graph_text.plain)
        emit_lines(lines_of(text), color=colors)
    else:
        emit(graph_text.dot(drawn) if form == "dot" else graph_text.mermaid(drawn))
    return 0


def load(file: Path, settings: Settings) -> Document:
    """Read a description, expanded if it is xacro.

    Raises:
        WrongUsage: it is none, cannot be read or expanded, or brings too many models.
    """
    from sdfcheck.files.library import Library, SearchPaths
    from sdfcheck.files.regular import read_regular
    from sdfcheck.robot.includes.multiplied import refuse_too_many
    from sdfcheck.source.sniff import sniff

    search = SearchPaths(settings.model_paths, settings.package_paths, settings.packages)
    library = Library(search, settings.size_limit)
    try:
        kind = sniff(read_regular(file, settings.size_limit), file)
    except OSError as error:
        raise WrongUsage(f"{file} cannot be read: {error.strerror}") from None
    document = library.document(file, None if kind is Kind.BROKEN_XML else kind)
    if document is not None and document.kind is Kind.XACRO:
        document = _expanded(document, settings)
    if document is None or document.root is None or document.kind not in {Kind.SDF, Kind.URDF}:
        raise WrongUsage(f"{file} looks like {kind.description}, not like a robot or world")
    refuse_too_many(document)
    return document


def _expanded(document: Document, settings: Settings) -> Document:
    from sdfcheck.xacro.expansion import Expander, Surroundings

    arguments = settings.arguments_for(document.path)
    surroundings = Surroundings(dict(settings.packages), settings.package_paths)
    with Expander(surroundings) as expander:
        expanded = expander.expand(document, dict(arguments[0]) if arguments else {}).document
    if expanded is None:
        raise WrongUsage(f"{document.path} cannot be expanded; `sdfcheck expand` says why")
    return expanded


def _paint(text: str, what: str) -> str:
    return click.style(text, fg=_COLORS[what])

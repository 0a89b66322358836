"""``sdfcheck graph``."""

from __future__ import annotations

import os
import sys
from pathlib import Path
from typing import Any

import click

from sdfcheck.cli.parts.command import Command
from sdfcheck.cli.parts.descriptions import around, described, load, warn_if_broken
from sdfcheck.cli.parts.options import colored, formatted, require_file, written
from sdfcheck.cli.parts.output import deliver, deliver_lines
from sdfcheck.cli.parts.terminal import lines_of, wants_color
from sdfcheck.robot import pictures as graph_text
from sdfcheck.robot.pictures import Graph, GraphKind, graph, svg
from sdfcheck.source.errors import DescriptionError, WrongUsage

_COLORS = {"kind": "cyan", "label": "yellow", "note": "bright_black"}


class _Kinds(click.Choice):  # type: ignore[type-arg, unused-ignore]
    """The kinds of graphs; a file in their place is a command that lacks one."""

    def convert(self, value: Any, param: click.Parameter | None, ctx: click.Context | None) -> Any:
        if value not in self.choices and os.path.exists(value):
            self.fail(f"which graph of it? Try `sdfcheck graph {GraphKind.JOINTS.value} {value}`", param, ctx)
        return super().convert(value, param, ctx)


@click.command(cls=Command, name="graph")
@click.argument("kind", type=_Kinds([kind.value for kind in GraphKind]))
@click.argument("file", type=click.Path(path_type=Path))
@formatted(
    "A tree to read, the language of Graphviz or Mermaid, or a picture.",
    *("text", "dot", "mermaid", "svg"),
    old={"tree": "text"},
)
@written()
@described
@colored("When to color the tree.")
def graph_command(
    kind: str, file: Path, form: str, output_file: Path | None, color: str, **given: Any
) -> int:
    """Show what is tied to what in an SDFormat, URDF or xacro file.

    \b
    frames  what moves with what
    poses   what is placed relative to what, and where in the world or model that
            is, all joints at zero: x y z (m) roll pitch yaw (rad)
    joints  which joint carries which link
    """
    require_file(file)
    try:
        document = load(file, around(given))
        warn_if_broken(document)
        drawn = graph(document, GraphKind(kind))
    except ValueError as error:
        if not isinstance(error, DescriptionError):
            raise
        line, column = error.element.span.begin
        raise WrongUsage(f"{file}:{line}:{column}: {error}") from None
    if form == "text":
        colors = output_file is None and wants_color(color, sys.stdout)
        text = graph_text.tree(drawn, _paint if colors else graph_text.plain)
        deliver_lines(lines_of(text), output_file, color=colors)
    else:
        deliver(_picture(drawn, form), output_file)
    return 0


def _picture(drawn: Graph, form: str) -> str:
    if form == "svg":
        return svg(drawn)
    return graph_text.dot(drawn) if form == "dot" else graph_text.mermaid(drawn)


def _paint(text: str, what: str) -> str:
    return click.style(text, fg=_COLORS[what])

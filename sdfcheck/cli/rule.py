"""``sdfcheck rule``."""

from __future__ import annotations

import sys
from typing import TYPE_CHECKING

import click

from sdfcheck.cli.parts import completing
from sdfcheck.cli.parts.command import Command
from sdfcheck.cli.parts.options import colored, configured
from sdfcheck.cli.parts.terminal import emit, emit_lines, lines_of, wants_color
from sdfcheck.cli.rules import VERSION, loaded, narrowed
from sdfcheck.report.manual import Manuals, record, render

if TYPE_CHECKING:
    from sdfcheck.lint.config.configuration import Configuration


@click.command(cls=Command)
@click.argument("selectors", nargs=-1, shell_complete=completing.rules, required=True, metavar="RULE...")
@click.option("--output-format", type=click.Choice(["text", "json"]), default="text", help="How to explain.")
@configured
@colored()
def rule(selectors: tuple[str, ...], output_format: str, configuration: Configuration, color: str) -> int:
    """Explain rules, given by code, name or family (ALL for all)."""
    index, known = loaded(configuration)
    manuals = Manuals(index)
    pages = [manuals.of(facts) for facts in narrowed(known, selectors)]
    if output_format == "json":
        import json

        explained = [dict(record(page)) for page in pages]
        emit(json.dumps({"version": VERSION, "rules": explained}, indent=2) + "\n")
        return 2 if index.faults else 0
    text = "\n".join(render(page) for page in pages)
    painted = wants_color(color, sys.stdout)
    emit_lines(lines_of(_painted(text) if painted else text), color=painted)
    return 2 if index.faults else 0


def _painted(markdown: str) -> str:
    """Markdown laid out for a terminal."""
    from io import StringIO

    from rich.console import Console
    from rich.markdown import Markdown

    console = Console(file=StringIO(), force_terminal=True, width=min(Console().width, 100))
    with console.capture() as capture:
        console.print(Markdown(markdown, code_theme="ansi_dark", hyperlinks=False))
    return capture.get()

"""``sdfcheck rule``."""

from __future__ import annotations

import sys
from pathlib import Path
from typing import TYPE_CHECKING

import click

from sdfcheck.cli.parts import options
from sdfcheck.cli.parts.command import Command
from sdfcheck.cli.parts.options import colored, configured, formatted, written
from sdfcheck.cli.parts.output import deliver, deliver_lines
from sdfcheck.cli.parts.terminal import lines_of, wants_color
from sdfcheck.cli.rules import VERSION, loaded, narrowed
from sdfcheck.report.manual import Manuals, record, render

if TYPE_CHECKING:
    from sdfcheck.lint.config.configuration import Configuration


@click.command(cls=Command)
@click.argument("selectors", nargs=-1, shell_complete=options.rules, required=True, metavar="RULE...")
@formatted("Pages to read, or JSON.", "text", "json")
@written()
@configured
@colored()
def rule(
    selectors: tuple[str, ...], form: str, output_file: Path | None, configuration: Configuration, color: str
) -> int:
    """Explain rules, given by code, name or family (ALL for all)."""
    index, known = loaded(configuration)
    manuals = Manuals(index)
    pages = [manuals.of(facts) for facts in narrowed(known, selectors)]
    if form == "json":
        import json

        explained = [dict(record(page)) for page in pages]
        deliver(json.dumps({"version": VERSION, "rules": explained}, indent=2) + "\n", output_file)
        return 2 if index.faults else 0
    text = "\n".join(render(page) for page in pages)
    painted = output_file is None and wants_color(color, sys.stdout)
    deliver_lines(lines_of(_painted(text) if painted else text), output_file, color=painted)
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

"""``sdfcheck config``."""

from __future__ import annotations

from pathlib import Path

import click

from sdfcheck.cli.parts.command import Command
from sdfcheck.cli.parts.options import formatted, written
from sdfcheck.cli.parts.output import deliver, deliver_lines
from sdfcheck.lint.config.settings import FIELDS


@click.command(cls=Command)
@formatted("A table to read, or the JSON Schema of configuration files.", "text", "schema")
@written()
def config(form: str, output_file: Path | None) -> None:
    """List the keys of a configuration file, with their defaults.

    The settings that apply to a file: sdfcheck lint --show-settings FILE.
    """
    if form == "text":
        deliver_lines(_lines(), output_file)
        return
    from sdfcheck.lint.config.schema import render

    deliver(render(), output_file)


def _lines() -> list[str]:
    width = max(len(field.key) for field in FIELDS)
    lines = []
    for field in FIELDS:
        default = f" (default: {field.default})" if field.default else ""
        lines += [f"{field.key:{width}}  {field.summary}", f"{'':{width}}  {field.shape}{default}"]
    return lines

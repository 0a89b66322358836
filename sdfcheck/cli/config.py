"""``sdfcheck config``."""

from __future__ import annotations

from pathlib import Path

import click

from sdfcheck.cli.parts.command import Command
from sdfcheck.cli.parts.options import PATH, formatted
from sdfcheck.cli.parts.terminal import emit, emit_lines
from sdfcheck.files.overwrite import overwrite
from sdfcheck.lint.config.fields import FIELDS
from sdfcheck.source.wrong_usage import WrongUsage


@click.command(cls=Command)
@formatted("A table to read, or the JSON Schema of configuration files.  [default: text]", "text", "schema")
@click.option("-o", "--output-file", type=PATH, metavar="FILE", help="Write it there.")
def config(form: str, output_file: Path | None) -> None:
    """List the keys of a configuration file, with their defaults.

    What holds for a file: sdfcheck lint --show-settings FILE.
    """
    if form == "text" and output_file is None:
        emit_lines(_lines())
        return
    from sdfcheck.lint.config.schema import render

    text = render() if form == "schema" else "".join(f"{line}\n" for line in _lines())
    if output_file is None:
        emit(text)
        return
    try:
        overwrite(output_file, text.encode())
    except OSError as error:
        raise WrongUsage(f"cannot write {output_file}: {error.strerror}") from None


def _lines() -> list[str]:
    width = max(len(field.key) for field in FIELDS)
    lines = []
    for field in FIELDS:
        default = f" (default: {field.default})" if field.default else ""
        lines += [f"{field.key:{width}}  {field.summary}", f"{'':{width}}  {field.shape.value}{default}"]
    return lines

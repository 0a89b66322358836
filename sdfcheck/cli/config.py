"""The commands ``init`` and ``config``: a configuration file that explains itself, and the one that is in force."""

from __future__ import annotations

import os
import sys
from collections.abc import Iterator, Sequence
from pathlib import Path
from textwrap import wrap

import click

from sdfcheck.cli.parts.command import Command
from sdfcheck.cli.parts.options import formatted, targeted, written
from sdfcheck.cli.parts.output import deliver, deliver_lines
from sdfcheck.cli.parts.terminal import say, width_of
from sdfcheck.lint.config.settings import FIELDS
from sdfcheck.source.errors import WrongUsage

# ``sdfcheck init``.

NAME = "sdfcheck.toml"
_NAMES = (NAME, f".{NAME}")
_SHOWN = ("select", "extend-select", "ignore", "fail-on", "exclude", "model-paths", "package-paths")
"""The keys that a configuration begins with, as comments."""


@click.command(cls=Command)
@click.argument("folder", type=click.Path(path_type=Path, file_okay=False, exists=True), default=".")
@targeted("The consumers that the files are meant for")
def init(folder: Path, target: tuple[str, ...] | None) -> None:
    """Write a commented sdfcheck.toml into FOLDER (default: the current one)."""
    for name in _NAMES:
        if os.path.exists(folder / name):
            raise WrongUsage(f"{folder / name} exists already")
    file = folder / NAME
    try:
        with file.open("x", encoding="utf-8") as opened:
            opened.write("\n".join(_commented(target or ())) + "\n")
    except OSError as error:
        raise WrongUsage(f"cannot write {file}: {error.strerror}") from None
    say(f"wrote {file}; next: sdfcheck lint {folder}")


def _commented(target: Sequence[str]) -> Iterator[str]:
    fields = {field.key: field for field in FIELDS}
    yield "# The configuration of sdfcheck; `sdfcheck config` lists all keys."
    yield ""
    yield f"# {fields['target'].summary}"
    listed = ", ".join(f'"{name}"' for name in target)
    yield f"target = [{listed}]" if target else "# target = []"
    for key in _SHOWN:
        yield ""
        yield f"# {fields[key].summary}"
        yield f"# {key} = {fields[key].default or '[]'}"
    yield ""
    yield f"# {fields['per-file-ignores'].summary}"
    yield "# [per-file-ignores]"
    yield '# "worlds/legacy/*" = ["deprecated-element"]'


# ``sdfcheck config``.


@click.command(cls=Command)
@formatted("A table to read, or the JSON Schema of configuration files.", "text", "schema")
@written()
def config(form: str, output_file: Path | None) -> None:
    """List the keys of a configuration file, with their defaults.

    The settings that apply to a file: sdfcheck lint --show-settings FILE.
    """
    if form == "text":
        deliver_lines(_lines(width_of(sys.stdout) if output_file is None else None), output_file)
        return
    from sdfcheck.lint.config.schema import render

    deliver(render(), output_file)


def _lines(cells: int | None) -> list[str]:
    """The keys and what they are for, in lines of at most so many cells, if they go to a terminal."""
    indent = " " * (max(len(field.key) for field in FIELDS) + 2)
    lines = []
    for field in FIELDS:
        default = f" (default: {field.default})" if field.default else ""
        first, *others = [
            line
            for text in (field.summary, f"{field.shape}{default}")
            for line in _wrapped(text, indent, cells)
        ]
        lines += [field.key.ljust(len(indent)) + first.lstrip(), *others]
    return lines


def _wrapped(text: str, indent: str, cells: int | None) -> list[str]:
    if cells is None:
        return [indent + text]
    width = max(cells, len(indent) + 20)
    return wrap(text, width, initial_indent=indent, subsequent_indent=indent, break_on_hyphens=False)

"""The manual page ``sdfcheck(1)``, made of the help of the commands: ``python -m tables.man_page [FILE]``."""

from __future__ import annotations

import inspect
import re
import sys
from collections.abc import Iterator
from pathlib import Path

import click

from sdfcheck.cli.main import sdfcheck
from sdfcheck.release import HOME, __version__

_CODES = (
    ("0", "no finding at or above --fail-on"),
    ("1", "findings"),
    ("2", "it could not run: a wrong option, a faulty configuration, a missing path"),
    ("130", "interrupted"),
)


def page() -> str:
    """The whole page in roff."""
    context = click.Context(sdfcheck, info_name="sdfcheck")
    lines = [
        f'.TH SDFCHECK 1 "" "sdfcheck {__version__}" "User Commands"',
        ".SH NAME",
        "sdfcheck \\- linter and converter for SDFormat, URDF and xacro robot descriptions",
        ".SH SYNOPSIS",
        ".B sdfcheck",
        "COMMAND [OPTIONS] [ARGS]...",
        ".SH DESCRIPTION",
        *_paragraphs(sdfcheck.help or ""),
        ".SH COMMANDS",
    ]
    for name, command in _commands(sdfcheck, context):
        lines += [f".SS {_roff(name)}", *_paragraphs(command.help or "")]
        lines += _options(command, click.Context(command, context, name))
    lines += [".SH EXIT STATUS"]
    for code, meaning in _CODES:
        lines += [".TP", f".B {code}", _roff(meaning)]
    lines += [".SH SEE ALSO", _roff(HOME)]
    return "\n".join(lines) + "\n"


def _commands(
    group: click.Group, context: click.Context, before: str = ""
) -> Iterator[tuple[str, click.Command]]:
    for name in group.list_commands(context):
        command = group.get_command(context, name)
        assert command is not None
        yield f"{before}{name}", command
        if isinstance(command, click.Group):
            yield from _commands(command, context, f"{before}{name} ")


def _options(command: click.Command, context: click.Context) -> Iterator[str]:
    for parameter in command.get_params(context):
        record = parameter.get_help_record(context)
        if record is not None and record[1]:
            yield from (".TP", f".B {_roff(record[0])}", _roff(record[1]))


def _paragraphs(text: str) -> Iterator[str]:
    for paragraph in re.split(r"\n\s*\n", inspect.cleandoc(text).replace("\b", "").replace("\f", "")):
        yield from (".PP", _roff(" ".join(paragraph.split())))


def _roff(text: str) -> str:
    """A text in which nothing is a command of roff."""
    escaped = text.replace("\\", "\\e").replace("-", "\\-")
    return f"\\&{escaped}" if escaped.startswith((".", "'")) else escaped


if __name__ == "__main__":
    if len(sys.argv) > 1:
        Path(sys.argv[1]).parent.mkdir(parents=True, exist_ok=True)
        Path(sys.argv[1]).write_text(page(), encoding="utf-8")
    else:
        print(page(), end="")

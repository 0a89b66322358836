"""Where output goes, and whether it is colored: all text leaves the program here, and acts on nothing."""

from __future__ import annotations

import os
import sys
from collections.abc import Iterable, Mapping
from pathlib import Path
from typing import TextIO

import click

from sdfcheck.files.regular import read_on
from sdfcheck.source.errors import WrongUsage
from sdfcheck.source.visible import harmless, harmless_document


def wants_color(choice: str, stream: TextIO | None, environment: Mapping[str, str] = os.environ) -> bool:
    """Whether to color what goes to ``stream``; ``choice`` is auto, always or never."""
    if choice != "auto":
        return choice == "always"
    if environment.get("NO_COLOR"):
        return False
    if environment.get("FORCE_COLOR"):
        return True
    return stream is not None and stream.isatty() and environment.get("TERM") != "dumb"


_KNOWS_LINKS = ("VTE_VERSION", "WT_SESSION", "KONSOLE_VERSION", "KITTY_WINDOW_ID", "DOMTERM")
"""Variables of terminals that show links."""
_LINKING_PROGRAMS = {"iTerm.app", "WezTerm", "vscode", "ghostty", "Hyper"}
_LINKING_TERMS = {"xterm-kitty", "alacritty", "foot", "xterm-ghostty", "wezterm"}


def wants_links(choice: str, stream: TextIO | None, environment: Mapping[str, str] = os.environ) -> bool:
    """Whether ``stream`` goes to a terminal that is known to show links; never without colors."""
    if stream is None or not stream.isatty() or not wants_color(choice, stream, environment):
        return False
    term = environment.get("TERM", "")
    if environment.get("CI") or term == "dumb" or term.startswith(("screen", "tmux")):
        return False
    return (
        any(environment.get(name) for name in _KNOWS_LINKS)
        or environment.get("TERM_PROGRAM") in _LINKING_PROGRAMS
        or term in _LINKING_TERMS
    )


def width_of(stream: TextIO | None, environment: Mapping[str, str] = os.environ) -> int | None:
    """How many cells fit into a line of the terminal that ``stream`` goes to; None: it goes to none."""
    if stream is None or not stream.isatty():
        return None
    given = environment.get("COLUMNS", "")
    if given.isdecimal() and int(given):
        return int(given)
    try:
        return os.get_terminal_size(stream.fileno()).columns or None
    except OSError:
        return None


def emit_lines(lines: Iterable[str], *, color: bool = False) -> None:
    """Write text for people to stdout, each line harmless; with ``color`` colors pass. Raises as ``emit`` does."""
    _write("".join(f"{harmless(line, color=color)}\n" for line in lines))


def emit(text: str) -> None:
    """Write a document or what programs read to stdout: exactly, unless it is a terminal.

    Raises:
        WrongUsage: stdout is closed or takes no more.
    """
    is_shown = sys.stdout is not None and sys.stdout.isatty()
    _write(harmless_document(text) if is_shown else text)


def _write(text: str) -> None:
    """Write to stdout, as UTF-8 except on a terminal; a closed pipe is not an error.

    Raises:
        WrongUsage: stdout is closed or takes no more.
    """
    if sys.stdout is None:
        raise WrongUsage("cannot write the output: stdout is closed")
    try:
        if sys.stdout.isatty() or not hasattr(sys.stdout, "buffer"):
            encoding = sys.stdout.encoding or "utf-8"
            sys.stdout.write(text.encode(encoding, "backslashreplace").decode(encoding))
        else:
            sys.stdout.flush()
            sys.stdout.buffer.write(text.encode("utf-8", "backslashreplace"))
        sys.stdout.flush()
    except BrokenPipeError:
        # Python flushes once more at exit, which must not complain either.
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
    except OSError as error:
        raise WrongUsage(f"cannot write the output: {error.strerror}") from None


def read_stdin() -> bytes:
    """The content of stdin, up to the size of a file; raises WrongUsage."""
    if sys.stdin is None:
        raise WrongUsage("cannot read stdin: it is closed")
    try:
        return read_on(sys.stdin.buffer, Path("<stdin>"))
    except OSError as error:
        raise WrongUsage(f"cannot read stdin: {error.strerror}") from None


def lines_of(text: str) -> list[str]:
    """The lines of a text of our own, in which names are visible already."""
    return text.removesuffix("\n").split("\n") if text else []


def say(text: str) -> None:
    """Write one line to stderr, whatever is in it."""
    click.echo(harmless(text), err=True)


def say_lines(lines: Iterable[str], *, color: bool = False) -> None:
    """Write text for people to stderr."""
    click.echo("\n".join(harmless(line, color=color) for line in lines), err=True, color=color)


def say_exactly(text: str) -> None:
    """Write what programs read to stderr."""
    click.echo(text, err=True, nl=False)


def pair(text: str, sign: str, form: str) -> tuple[str, str]:
    """The two sides of ``sign`` in an argument.

    Raises:
        WrongUsage: the text is not of the ``form``.
    """
    name, found, value = text.partition(sign)
    if not found or not name:
        raise WrongUsage(f"`{text}` is not of the form {form}")
    return name, value

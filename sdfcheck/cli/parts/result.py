"""Where the result of a command goes: to stdout, or to the file of ``-o``."""

from __future__ import annotations

from collections.abc import Iterable
from pathlib import Path

from sdfcheck.cli.parts.output import refuse_inputs
from sdfcheck.cli.parts.terminal import emit, emit_lines
from sdfcheck.source.visible import harmless
from sdfcheck.source.wrong_usage import WrongUsage


def deliver(text: str, file: Path | None, inputs: Iterable[Path] = ()) -> None:
    """Write a document, or what programs read, exactly as it is.

    Raises:
        WrongUsage: the file is an input, or cannot be written.
    """
    if file is None:
        emit(text)
        return
    from sdfcheck.files.overwrite import overwrite

    refuse_inputs([file], inputs)
    try:
        overwrite(file, text.encode("utf-8", "backslashreplace"))
    except OSError as error:
        raise WrongUsage(f"cannot write {file}: {error.strerror}") from None


def deliver_lines(
    lines: Iterable[str], file: Path | None, inputs: Iterable[Path] = (), *, color: bool = False
) -> None:
    """Write text for people; ``color``: colors pass. Raises as ``deliver`` does."""
    if file is None:
        emit_lines(lines, color=color)
    else:
        deliver("".join(f"{harmless(line)}\n" for line in lines), file, inputs)

"""Where reports and other results go."""

from __future__ import annotations

import os
import sys
from collections.abc import Iterable, Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING

from sdfcheck.cli.parts.terminal import (
    emit,
    emit_lines,
    lines_of,
    say_exactly,
    say_lines,
    wants_color,
    wants_links,
    width_of,
)
from sdfcheck.files.regular import note_read
from sdfcheck.lint.run import Run
from sdfcheck.report import OutputFormat, render
from sdfcheck.report.summary import EVERYTHING, View
from sdfcheck.source.errors import WrongUsage
from sdfcheck.source.record import NamedTuple
from sdfcheck.source.visible import harmless

if TYPE_CHECKING:
    from sdfcheck.report.content import Robot

FORMATS = tuple(known.value for known in OutputFormat)


class Output(NamedTuple):
    """One report: its format, and the file it goes to (None: stdout)."""

    format: OutputFormat
    file: Path | None


def outputs(formats: Sequence[str], file: Path | None) -> tuple[Output, ...]:
    """The formats and files that ``FORMAT`` and ``FORMAT=FILE`` name; ``file`` is for the one without a file.

    Raises:
        WrongUsage: a format is unknown, two reports would go to one place, or none to ``file``.
    """
    wanted = []
    for text in formats:
        name, equals, place = text.partition("=")
        if name not in FORMATS:
            from sdfcheck.formats.near_names import did_you_mean

            near = did_you_mean(name, FORMATS) or f" (choose from {', '.join(FORMATS)})"
            raise WrongUsage(f"unknown output format `{name}`{near}")
        if equals and not place:
            raise WrongUsage(f"`{text}` names no file")
        wanted.append(Output(OutputFormat(name), Path(place) if place else file))
    if file is not None and all("=" in text for text in formats):
        raise WrongUsage(f"each --output-format names its own file, so that nothing goes to {file}")
    places = [output.file for output in wanted]
    for place_of_one in places:
        if places.count(place_of_one) > 1:
            raise WrongUsage(f"two reports would go to {place_of_one or 'stdout'}; write one as FORMAT=FILE")
    return tuple(wanted)


def refuse_to_write(places: Iterable[Path | None], inputs: Iterable[Path] = ()) -> None:
    """Make sure that all results can be written, before the first one is.

    ``inputs`` are files that are still to be read.

    Raises:
        WrongUsage: two results would go to one place, or one to what is read, or where nothing is written.
    """
    written = [place for place in places if place is not None]
    if not written:
        return
    from sdfcheck.files import overwrite

    note_read(inputs)
    seen: dict[str, Path] = {}
    for place in written:
        with _explained(place):
            if overwrite.goes_to_a_file(place):
                overwrite.refuse_to_write(place)
                first = seen.setdefault(os.path.realpath(place), place)
                if first is not place:
                    raise WrongUsage(f"two results would go to {place}")


@contextmanager
def _explained(file: Path) -> Iterator[None]:
    """Errors of writing a file as wrong usage."""
    try:
        yield
    except OSError as error:
        from sdfcheck.files.overwrite import why_not

        raise WrongUsage(why_not(file, error)) from None


def show(format: OutputFormat, text: str, *, color: bool, aside: bool = False) -> None:
    """Write a report to stdout, or aside to stderr; what programs read stays as it is."""
    if format.is_text:
        (say_lines if aside else emit_lines)(lines_of(text), color=color)
    else:
        (say_exactly if aside else emit)(text)


def write(
    output: Output,
    run: Run,
    *,
    color: str,
    aside: bool = False,
    view: View = EVERYTHING,
    robots: Sequence[Robot] = (),
) -> None:
    """Render a run and put it where it belongs; ``aside``: to stderr where that is stdout.

    ``color`` is auto, always or never. Output on a terminal fits it.

    Raises:
        WrongUsage: the file cannot be written.
    """
    if output.file is None:
        stream = sys.stderr if aside else sys.stdout
        painted = wants_color(color, stream)
        view = view._replace(width=width_of(stream), links=wants_links(color, stream))
        text = render(output.format, run, color=painted, view=view, robots=robots)
        show(output.format, text, color=painted, aside=aside)
        return
    deliver(render(output.format, run, color=False, view=view, robots=robots), output.file)


def deliver(text: str, file: Path | None) -> None:
    """Write a document, or what programs read, exactly as it is.

    Raises:
        WrongUsage: the file is an input, or cannot be written.
    """
    if file is None:
        emit(text)
        return
    from sdfcheck.files.overwrite import overwrite

    with _explained(file):
        overwrite(file, text.encode("utf-8", "backslashreplace"))


def deliver_lines(lines: Iterable[str], file: Path | None, *, color: bool = False) -> None:
    """Write text for people; ``color``: colors pass. Raises as ``deliver`` does."""
    if file is None:
        emit_lines(lines, color=color)
    else:
        deliver("".join(f"{harmless(line)}\n" for line in lines), file)

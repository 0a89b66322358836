"""Where reports and other results go."""

from __future__ import annotations

import sys
from collections.abc import Iterable, Iterator, Sequence
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
from sdfcheck.formats.suggest import did_you_mean
from sdfcheck.lint.run import Run
from sdfcheck.report import OutputFormat, render
from sdfcheck.report.summary import EVERYTHING, View
from sdfcheck.source.record import NamedTuple
from sdfcheck.source.visible import harmless
from sdfcheck.source.wrong_usage import WrongUsage

if TYPE_CHECKING:
    from sdfcheck.report.robots import Robot

FORMATS = tuple(known.value for known in OutputFormat)


class Output(NamedTuple):
    """One report: its format, and the file it goes to (None: stdout)."""

    format: OutputFormat
    file: Path | None


def outputs(formats: Sequence[str], file: Path | None) -> tuple[Output, ...]:
    """The formats and files that ``FORMAT`` and ``FORMAT=FILE`` name; ``file`` is for the one without a file.

    Raises:
        WrongUsage: a format is unknown, or two reports would go to one place.
    """
    wanted = []
    for text in formats:
        name, equals, place = text.partition("=")
        if name not in FORMATS:
            near = did_you_mean(name, FORMATS) or f" (choose from {', '.join(FORMATS)})"
            raise WrongUsage(f"unknown output format `{name}`{near}")
        if equals and not place:
            raise WrongUsage(f"`{text}` names no file")
        wanted.append(Output(OutputFormat(name), Path(place) if place else file))
    places = [output.file for output in wanted]
    for place_of_one in places:
        if places.count(place_of_one) > 1:
            raise WrongUsage(f"two reports would go to {place_of_one or 'stdout'}; write one as FORMAT=FILE")
    return tuple(wanted)


def inputs_of(paths: Sequence[Path], done: Run) -> Iterator[Path]:
    """The files that a run has read, or was asked to."""
    yield from (path for path in paths if not path.is_dir())
    yield from done.files
    yield from (path for path, _ in done.skipped)
    yield from {diagnostic.span.source.path for diagnostic in done.diagnostics}


def refuse_inputs(places: Iterable[Path | None], inputs: Iterable[Path]) -> None:
    """Make sure that nothing is written over what is read.

    Raises:
        WrongUsage: a place is an input, by whatever name.
    """
    written = [place for place in places if place is not None and place.exists()]
    if not written:
        return
    from sdfcheck.files.overwrite import identity

    own = set(map(identity, inputs))
    for place in written:
        if identity(place) in own:
            raise WrongUsage(f"{place} is an input and would be overwritten; name another file")


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

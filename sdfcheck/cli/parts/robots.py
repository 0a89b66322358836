"""The descriptions of a run that its HTML report draws."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from sdfcheck.cli.parts.descriptions import Around, load
from sdfcheck.report import OutputFormat
from sdfcheck.source.wrong_usage import WrongUsage

if TYPE_CHECKING:
    from sdfcheck.cli.parts.output import Output
    from sdfcheck.lint.run import Run
    from sdfcheck.lint.session import Options
    from sdfcheck.report.robots import Robot
    from sdfcheck.source.document import Document


def robots_of(run: Run, wanted: Iterable[Output], options: Options) -> Sequence[Robot]:
    """The robots and worlds of a small run, in the order of its files; none if no report shows them.

    Where xacro is not expanded, the robots would not be what was linted.
    """
    if not options.expand or not any(output.format is OutputFormat.HTML for output in wanted):
        return ()
    from sdfcheck.report.formats.html import MOST_ROBOTS

    if len(run.files) > MOST_ROBOTS:
        return ()
    from sdfcheck.report.robots import robots

    around = Around(options.configuration, options.arguments, options.search, options.variables)
    return list(robots(run, _documents(run, around)))


def _documents(run: Run, around: Around) -> Iterator[tuple[Path, Document]]:
    for file in run.files:
        if not file.is_file():
            continue  # read from stdin
        try:
            yield file, load(file, around, check=False)
        except WrongUsage:
            continue  # the report says what is wrong with it

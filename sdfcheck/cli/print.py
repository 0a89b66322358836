"""``sdfcheck print``."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import click

from sdfcheck.cli.parts.command import Command
from sdfcheck.cli.parts.descriptions import around, described, load
from sdfcheck.cli.parts.options import require_file, written
from sdfcheck.cli.parts.output import deliver
from sdfcheck.cli.parts.terminal import say
from sdfcheck.source.record import NamedTuple


class Request(NamedTuple):
    """The command line, as click read it."""

    file: Path
    degrees: bool | None
    snap: float | None
    precision: int | None
    expand_includes: bool
    expand_auto_inertials: bool
    output_file: Path | None


@click.command(cls=Command, name="print")
@click.argument("file", type=click.Path(path_type=Path))
@click.option(
    "--degrees/--radians",
    default=None,
    help="Write the angles of poses in degrees, or radians.  [default: as they are]",
)
@click.option(
    "--snap-to-degrees",
    "snap",
    type=click.FloatRange(min=0, max=0.5),
    metavar="TOL",
    help="Turn angles of poses within TOL degrees of a whole degree into that.",
)
@click.option(
    "--precision",
    type=click.IntRange(min=1, max=17),
    metavar="N",
    help="Round numbers to N significant digits.",
)
@click.option("--expand-includes", is_flag=True, help="Put what includes bring in their place.")
@click.option(
    "--expand-auto-inertials",
    is_flag=True,
    help="Compute automatic inertias (of meshes with the extra `mesh`).",
)
@written()
@described
def print_command(**given: Any) -> int:
    """Write a description in canonical form.

    Indentation is two spaces, numbers are as short as they can be without changing,
    comments stay; xacro is expanded. The version stays as it is. Unless rounding or
    snapping is asked for, the result is compared with the source, robot with robot.
    """
    from sdfcheck.convert.canonical import CanonicalStyle, NumberStyle, canonical

    surroundings = around(given)
    request = Request(**given)
    require_file(request.file)
    style = CanonicalStyle(
        NumberStyle(request.degrees, request.snap, request.precision),
        request.expand_includes,
        request.expand_auto_inertials,
    )
    result = canonical(load(request.file, surroundings), style)
    deliver(result.text, request.output_file)
    for note in result.notes:
        say(f"warning: {note}")
    return 0

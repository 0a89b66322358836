"""``sdfcheck diff``."""

from __future__ import annotations

import sys
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from sdfcheck.cli.parts.command import Command
from sdfcheck.cli.parts.descriptions import (
    SearchContext,
    around,
    check_arguments,
    described,
    load,
    warn_if_broken,
)
from sdfcheck.cli.parts.options import colored, formatted, require_file, written
from sdfcheck.cli.parts.output import deliver, deliver_lines
from sdfcheck.cli.parts.terminal import wants_color
from sdfcheck.source.errors import DescriptionError, WrongUsage
from sdfcheck.source.record import NamedTuple
from sdfcheck.source.visible import visible

if TYPE_CHECKING:
    from sdfcheck.convert.comparison import Change
    from sdfcheck.convert.file_difference import FileDifference

_SIGNS = {"added": "+", "removed": "-", "renamed": ">", "changed": "~"}
_COLORS = {"added": "green", "removed": "red", "renamed": "cyan", "changed": "yellow"}


class Request(NamedTuple):
    """The command line, as click read it."""

    a: Path
    b: Path
    form: str
    output_file: Path | None
    exit_zero: bool
    exit_code: bool
    tolerance: float
    color: str


@click.command(cls=Command)
@click.argument("a", type=click.Path(path_type=Path))
@click.argument("b", type=click.Path(path_type=Path))
@formatted("Lines to read, or JSON.", "text", "json")
@written()
@click.option("--exit-zero", is_flag=True, help="Exit with 0 also if the robots differ.")
@click.option("--exit-code/--no-exit-code", default=True, hidden=True)
@click.option(
    "--tolerance",
    type=click.FloatRange(min=0),
    default=1e-9,
    help="Smaller differences do not count (m, rad; relative for others).  [default: 1e-9]",
)
@described
@colored("When to color the text.")
def diff(**given: Any) -> int:
    """Show what changed in the robot from A to B, not in the text.

    A and B may be of different formats: SDFormat, URDF, xacro. The comparison covers
    models, links, joints and frames: poses, masses and inertias, shapes, axes, limits,
    dynamics, mimicking; and materials, surfaces, sensors, lights, plugins, physics and
    custom data. A default that is written out is not a difference.

    Exit code 0: the same robot; 1: another one; 2: could not compare.
    """
    surroundings = around(given)
    request = Request(**given)
    found = _compare(request, surroundings)
    if request.form == "json":
        deliver(_json(found), request.output_file)
    else:
        color = request.output_file is None and wants_color(request.color, sys.stdout)
        deliver_lines(_lines(found, color=color), request.output_file, color=color)
    return int(bool(found.changes) and request.exit_code and not request.exit_zero)


def _compare(request: Request, around: SearchContext) -> FileDifference:
    from sdfcheck.convert.file_difference import compare_files
    from sdfcheck.robot.motion.origin import PoseError

    for file in (request.a, request.b):
        require_file(file)
    check_arguments(around.arguments, (request.a, request.b), around.settings_for(request.a))
    documents = [load(file, around, check=False) for file in (request.a, request.b)]
    warn_if_broken(*documents)
    try:
        return compare_files(*documents, tolerance=request.tolerance)
    except DescriptionError as error:
        span = error.element.span
        raise WrongUsage(f"{span.source.path}:{span.begin.line}:{span.begin.column}: {error}") from None
    except PoseError as error:
        raise WrongUsage(str(error)) from None


def _lines(found: FileDifference, *, color: bool) -> list[str]:
    if not found.changes:
        parts = [
            f"{count} {word}{'s' * (count != 1)}"
            for count, word in (
                (found.models, "model"),
                (found.links, "link"),
                (found.joints, "joint"),
                *((count, word) for word, count in sorted(found.settings.items())),
            )
        ]
        return [f"the same robot: {', '.join(parts)}"]
    lines: list[str] = []
    for model, changes in found.changes:
        if not any(
            change.part == "model" and change.kind.value in {"added", "removed"} for change in changes
        ):
            lines.append(f"model {visible(model)}")
        lines += [_line(change, color) for change in changes]
    return lines


def _line(change: Change, color: bool) -> str:
    kind = change.kind.value
    if kind == "renamed":
        text = f"{change.part} `{change.before}` → `{change.after}`"
    else:
        text = f"{change.part} `{change.name}`"
    if kind == "changed":
        values = " → ".join(filter(None, (change.before, change.after)))
        text = f"{text}: {change.what} {values}"
    alone = change.part == "model" and kind in {"added", "removed"}
    line = f"{'' if alone else '  '}{_SIGNS[kind]} {visible(text)}"
    return click.style(line, fg=_COLORS[kind]) if color else line


def _json(found: FileDifference) -> str:
    import json

    models = [
        {"name": name, "changes": [_change(change) for change in changes]} for name, changes in found.changes
    ]
    document = {"version": 1, "equal": not found.changes, "models": models}
    return json.dumps(document, indent=2) + "\n"


def _change(change: Change) -> dict[str, str]:
    return {
        "kind": change.kind.value,
        "part": change.part,
        "name": change.name,
        "what": change.what,
        "before": change.before,
        "after": change.after,
    }

"""``sdfcheck inertia``."""

from __future__ import annotations

import sys
from collections.abc import Iterable, Iterator, Sequence
from math import isfinite
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from sdfcheck.cli.parts.command import Command
from sdfcheck.cli.parts.descriptions import around, described, load, warn_if_broken
from sdfcheck.cli.parts.options import colored, formatted, require_file, written
from sdfcheck.cli.parts.output import deliver, deliver_lines
from sdfcheck.cli.parts.terminal import say, wants_color
from sdfcheck.source.errors import DescriptionError, WrongUsage
from sdfcheck.source.record import NamedTuple
from sdfcheck.source.visible import visible

if TYPE_CHECKING:
    from rich.console import Console
    from rich.table import Table

    from sdfcheck.robot.motion.mass import MassProperties
    from sdfcheck.robot.motion.mass_report import LinkMass, MassReport, ModelMass
    from sdfcheck.source.document import Document

_HEADER = ("", "mass", "x", "y", "z", "ixx", "iyy", "izz", "ixy", "ixz", "iyz", "")
_UNITS = "kg, m, kg·m²; centers of mass and axes in the model's frame, moments about the center of mass"
_ENDLESS = 10_000
_ORIGINS = {
    "written": "",
    "automatic": "automatic",
    "default": "not written: what simulators take",
    "none": "no inertial: no mass",
    "unknown": "unknown",
}


class _Block(NamedTuple):
    """The table of one model, or of the file."""

    title: str
    rows: list[tuple[str, ...]]
    notes: tuple[str, ...]


@click.command(cls=Command)
@click.argument("file", type=click.Path(path_type=Path))
@formatted("A table to read, or JSON.", "text", "json", old={"table": "text"})
@written()
@click.option("--model", "name", metavar="NAME", help="Show this model only (`arm::hand` for a nested one).")
@described
@colored("When to color the table.")
def inertia(
    file: Path, form: str, output_file: Path | None, name: str | None, color: str, **given: Any
) -> int:
    """Show mass, center of mass and inertia of links and models, and of the whole file.

    Automatic inertias are computed; meshes need the extra `mesh`. Centers of mass are in
    the frame of the model, with all joints at zero; moments are about the center of
    mass, in axes parallel to those of the model.
    """
    require_file(file)
    document = load(file, around(given))
    warn_if_broken(document)
    report = measure(document)
    if name is not None:
        report = _only(report, name)
    if form == "json":
        deliver(_json(report), output_file)
    elif output_file is None and sys.stdout.isatty():
        from rich.console import Console

        draw(report, Console(highlight=False, no_color=not wants_color(color, sys.stdout)))
    else:
        deliver_lines(_lines(report), output_file)
    for note in _warnings(report):
        say(f"warning: {note}")
    return 0


def measure(document: Document) -> MassReport:
    """The report on a document.

    Raises:
        WrongUsage: its numbers cannot be read.
    """
    from sdfcheck.robot.motion.mass_report import mass_report
    from sdfcheck.robot.motion.origin import PoseError
    from sdfcheck.robot.root import root_of

    try:
        return mass_report(root_of(document).scopes)
    except DescriptionError as error:
        line, column = error.element.span.begin
        raise WrongUsage(f"{document.path}:{line}:{column}: {error}") from None
    except PoseError as error:
        raise WrongUsage(f"{document.path}: {error}") from None


def _only(report: MassReport, name: str) -> MassReport:
    from sdfcheck.robot.motion.mass_report import MassReport

    found = next((model for model in report.walk() if model.name == name), None)
    if found is None:
        names = tuple(model.name for model in report.walk())
        from sdfcheck.formats.near_names import did_you_mean

        near = did_you_mean(name, names) or f" (there is {', '.join(names) or 'none'})"
        raise WrongUsage(f"no model `{name}`{near}")
    return MassReport((found,), found.total)


def _warnings(report: MassReport) -> Iterator[str]:
    yield from report.notes
    for model in report.walk():
        yield from model.notes
        for link in model.links:
            if link.note:
                yield f"link `{model.name}::{link.name}`: {link.note}"


def _blocks(report: MassReport) -> Iterator[_Block]:
    for model in report.walk():
        rows = [_row(visible(link.name), link.body, _ORIGINS[link.origin.value]) for link in model.links]
        inside = " with nested models" if model.models else ""
        rows.append(
            _row(f"total{inside}", model.total, "" if model.is_complete else "without what is unknown")
        )
        yield _Block(
            f"model {visible(model.name)}{' (static)' if model.is_static else ''}", rows, model.notes
        )
    if len(report.models) > 1 or report.notes:
        static = sum(model.is_static for model in report.models)
        what = f"without {static} static model{'s' * (static != 1)}" if static else ""
        if not report.is_complete:
            what = ", ".join(filter(None, (what, "without what is unknown")))
        yield _Block("file", [_row("total", report.total, what)], report.notes)


def _row(name: str, body: MassProperties | None, note: str) -> tuple[str, ...]:
    if body is None:
        return (name, *["–"] * 10, note)
    return (name, *(_short(number) for number in _numbers(body)), note)


def _numbers(body: MassProperties) -> tuple[float, ...]:
    m = body.moments
    moments = (m[0, 0], m[1, 1], m[2, 2], m[0, 1], m[0, 2], m[1, 2])
    return tuple(float(number) for number in (body.mass, *body.center, *moments))


def _short(number: float) -> str:
    return f"{number if abs(number) > 1e-15 else 0:.5g}"


def _lines(report: MassReport) -> list[str]:
    """Columns of one width over all models, for pipes."""
    blocks = list(_blocks(report))
    rows = [_HEADER, *(row for block in blocks for row in block.rows)]
    widths = [max(len(row[at]) for row in rows) for at in range(len(_HEADER))]
    lines = [f"# {_UNITS}"]
    for block in blocks:
        lines += ["", block.title, *(_aligned(row, widths) for row in (_HEADER, *block.rows))]
    return lines


def _aligned(row: Iterable[str], widths: list[int]) -> str:
    name, *numbers, note = row
    cells = (number.rjust(width) for number, width in zip(numbers, widths[1:-1], strict=True))
    return "  ".join(("  " + name.ljust(widths[0]), *cells, note)).rstrip()


def draw(report: MassReport, console: Console) -> None:
    """Tables for a terminal; on a narrow one the moments have tables of their own, and no number is cut."""
    from rich.text import Text

    last = len(_HEADER) - 1
    endless = console.options.update(max_width=_ENDLESS)
    for block in _blocks(report):
        tables = [_table(block, range(last + 1))]
        if console.measure(tables[0], options=endless).maximum > console.width:
            tables = [_table(block, (*range(5), last)), _table(block, (0, *range(5, last)), titled=False)]
        for table in tables:
            table.width = console.measure(table, options=endless).maximum
            console.print(table, soft_wrap=True)
        console.print()
    console.print(Text(_UNITS, style="bright_black"))


def _table(block: _Block, columns: Sequence[int], *, titled: bool = True) -> Table:
    from rich.table import Table
    from rich.text import Text

    title = Text(block.title, style="bold cyan") if titled else None
    table = Table(title=title, title_justify="left", box=None, pad_edge=False)
    for at in columns:
        is_number = 0 < at < len(_HEADER) - 1
        table.add_column(
            _HEADER[at], justify="right" if is_number else "left", overflow="fold", no_wrap=is_number
        )
    for row in block.rows:
        style = "bold" if row[0].startswith("total") else None
        table.add_row(*(Text(row[at]) for at in columns), style=style)
    return table


def _json(report: MassReport) -> str:
    import json

    document = {
        "version": 1,
        "models": [_model(model) for model in report.models],
        "total": _body(report.total),
        "complete": report.is_complete,
    }
    return json.dumps(document, indent=2) + "\n"


def _model(model: ModelMass) -> dict[str, Any]:
    return {
        "name": model.name,
        "static": model.is_static,
        "links": [_link(link) for link in model.links],
        "models": [_model(inner) for inner in model.models],
        "total": _body(model.total),
        "complete": model.is_complete,
        "notes": list(model.notes),
    }


def _link(link: LinkMass) -> dict[str, Any]:
    body = _body(link.body) or dict.fromkeys(("mass", "centre_of_mass", "inertia"))
    return {"name": link.name, "from": link.origin.value, **body, "note": link.note}


def _body(body: MassProperties | None) -> dict[str, Any] | None:
    if body is None:
        return None
    mass, x, y, z, *moments = (number if isfinite(number) else None for number in _numbers(body))
    names = ("ixx", "iyy", "izz", "ixy", "ixz", "iyz")
    return {"mass": mass, "centre_of_mass": [x, y, z], "inertia": dict(zip(names, moments, strict=True))}

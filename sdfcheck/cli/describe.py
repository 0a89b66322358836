"""``sdfcheck describe``."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path
from textwrap import wrap

import click

from sdfcheck.cli.parts import options
from sdfcheck.cli.parts.command import Command
from sdfcheck.cli.parts.options import configured, formatted, sdf_version, written
from sdfcheck.cli.parts.output import deliver, deliver_lines
from sdfcheck.cli.parts.terminal import lines_of
from sdfcheck.files.library import Library
from sdfcheck.formats.describe import HOW_OFTEN, Description, Entry, UnknownPlace, describe
from sdfcheck.formats.vendor import BUILT_IN, known_tables
from sdfcheck.formats.version import Version
from sdfcheck.lint.config.configuration import Configuration
from sdfcheck.source.errors import WrongUsage

VERSION = 1
"""Of the JSON."""

_MANY = 3
"""From more places than this on, they are listed instead of described."""


@click.command(cls=Command, name="describe")
@click.argument("element", shell_complete=options.places)
@sdf_version("The version of SDFormat to describe", name="version")
@formatted("Text to read, or JSON.", "text", "json")
@written()
@configured
def describe_command(
    element: str, version: Version, form: str, output_file: Path | None, configuration: Configuration
) -> None:
    """Say what the format allows at a place.

    \b
    sdfcheck describe joint/axis                 an element of SDFormat
    sdfcheck describe pose/@degrees              an attribute
    sdfcheck describe urdf:joint/limit           an element of URDF
    sdfcheck describe drake:proximity_properties an element of Drake's own

    Elements of other vendors are known by the tables of packs, as the configuration names them.
    """
    try:
        found = describe(element, version, _tables(element, configuration))
    except UnknownPlace as error:
        raise WrongUsage(str(error)) from None
    if form == "json":
        import json

        places = [record(one) for one in found]
        deliver(json.dumps({"version": VERSION, "places": places}, indent=2) + "\n", output_file)
    elif len(found) > _MANY:
        deliver_lines(lines_of(_overview(element, found)), output_file)
    else:
        deliver_lines(lines_of("\n".join(text(one) for one in found)), output_file)


def _tables(element: str, configuration: Configuration) -> Mapping[str, Path]:
    """The tables of vendors, with those of packs where the question is about one that is not built in."""
    prefixes = {step.partition(":")[0].removeprefix("@") for step in element.split("/") if ":" in step}
    if prefixes <= {"sdf", "urdf", *BUILT_IN}:
        return BUILT_IN
    from sdfcheck.lint.rulebook.rulebook import RuleBook

    settings = configuration.settings_in(Path.cwd())
    RuleBook().index(settings)  # says what is wrong with a pack
    return known_tables(Library(settings.search))


def record(description: Description) -> dict[str, object]:
    """The content of the JSON output: all facts."""
    record: dict[str, object] = {}
    for key, value in description._asdict().items():
        if value or key in {"name", "format", "what"}:
            record[key] = [_field(item) for item in value] if isinstance(value, tuple) else value
    return record


def _field(item: str | Entry) -> object:
    return (
        {name: value for name, value in item._asdict().items() if value} if isinstance(item, Entry) else item
    )


def text(description: Description) -> str:
    """A page for people."""
    lines = [f"{description.name} ({description.format})"]
    lines += wrap(description.summary, 96, initial_indent="  ", subsequent_indent="  ")
    lines.append(f"  {_nature(description)}")
    facts = (
        ("default", description.default),
        ("unit", description.unit),
        ("range", description.range),
        ("values", ", ".join(description.choices)),
        ("since", description.since),
        ("until", description.until),
        ("instead", description.successor),
    )
    lines += [f"  {name:8} {value}" for name, value in facts if value]
    lines += [f"  {note}" for note in description.notes]
    is_attribute = description.what == "attribute"
    for title, entries in (
        ("found in", description.parents),
        ("attributes", description.attributes),
        ("elements", description.children),
    ):
        if entries:
            lines += ["", f"  {title}", *(f"    {line}" for line in _columns(entries, is_attribute))]
    return "\n".join(lines) + "\n"


def _nature(description: Description) -> str:
    words = [
        "deprecated " * description.deprecated + description.what,
        f"of type {description.type}" if description.type else "",
        "any content" if description.open else "",
    ]
    return ", ".join(filter(None, words))


def _columns(entries: Sequence[Entry], of_attribute: bool) -> Iterator[str]:
    rows = [(entry.name, _often(entry, of_attribute), entry.type, _remarks(entry)) for entry in entries]
    widths = [max(len(row[column]) for row in rows) for column in range(3)]
    for row in rows:
        cells = [f"{cell:{width}}" for cell, width in zip(row, widths, strict=False) if width]
        yield "  ".join((*cells, row[3])).rstrip()


def _often(entry: Entry, of_attribute: bool) -> str:
    if of_attribute or entry.name[0] == "@":
        return "required" if entry.multiplicity == "1" else "optional"
    return HOW_OFTEN[entry.multiplicity]


def _remarks(entry: Entry) -> str:
    parts = (
        f"default {entry.default}" if entry.default else "",
        entry.unit,
        f"since {entry.since}" if entry.since else "",
        "deprecated" if entry.deprecated else "",
        entry.note,
    )
    return ", ".join(filter(None, parts))


def _overview(element: str, found: Sequence[Description]) -> str:
    lines = [
        f"{element} is in {len(found)} places; ask for one of them, or for all with --output-format json"
    ]
    lines += [f"  {one.name}{f'  {one.type}' if one.type else ''}" for one in found]
    return "\n".join(lines) + "\n"

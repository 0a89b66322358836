"""``sdfcheck schema``."""

from __future__ import annotations

from pathlib import Path

import click
from click.core import ParameterSource

from sdfcheck.cli.parts.command import Command
from sdfcheck.cli.parts.options import PATH, formatted, require_file, sdf_version, written
from sdfcheck.cli.parts.output import deliver
from sdfcheck.cli.parts.terminal import say
from sdfcheck.files.regular import note_read, read_named
from sdfcheck.formats.version import NEWEST, Version
from sdfcheck.source.errors import WrongUsage


@click.command(cls=Command, name="schema")
@click.option(
    "--for",
    "file",
    type=PATH,
    metavar="FILE",
    help="Write the schema that fits FILE: its version of SDFormat, or the keys of a configuration.",
)
@sdf_version("The version of SDFormat", name="version")
@formatted("XML Schema 1.0 or RELAX NG, which can say more.", "xsd", "rng")
@written()
@click.pass_context
def schema_command(
    context: click.Context, file: Path | None, version: Version, form: str, output_file: Path | None
) -> None:
    """Write a version of SDFormat as a schema, for editors and XML tools.

    Children are free in their order, and elements and attributes with a (declared)
    prefix free altogether. XML Schema cannot say how often a child is then; RELAX NG can.
    """
    if file is not None:
        if context.get_parameter_source("version") is ParameterSource.COMMANDLINE:
            raise WrongUsage("--for and --sdf-version exclude each other")
        require_file(file)
        if file.suffix == ".toml":
            from sdfcheck.lint.config.schema import render

            note_read([file])
            deliver(render(), output_file)
            return
        version = _version_of(file)
    if form == "xsd":
        from sdfcheck.formats.export import xsd

        text = xsd(version)
    else:
        from sdfcheck.formats.export import rng

        text = rng(version)
    deliver(text, output_file)


def _version_of(file: Path) -> Version:
    """The version of SDFormat that a file declares; the newest if consumers do not know it.

    Raises:
        WrongUsage: the file is not SDFormat.
    """
    from sdfcheck.files.library import Library
    from sdfcheck.source.sniff import Kind, sniff

    try:
        kind = sniff(read_named(file), file)
    except OSError as error:
        raise WrongUsage(f"{file} cannot be read: {error.strerror}") from None
    document = Library().document(file, kind) if kind is Kind.SDF else None
    if document is None:
        raise WrongUsage(f"{file} looks like {kind.description}; schemas are for SDFormat and sdfcheck.toml")
    known = Version.parse(document.version or "")
    if known is None:
        say(f"note: {file} declares no known version of SDFormat; the schema is that of {NEWEST}")
    return known or NEWEST

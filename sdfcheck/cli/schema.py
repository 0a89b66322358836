"""``sdfcheck schema``."""

from __future__ import annotations

from pathlib import Path

import click

from sdfcheck.cli.describe import version
from sdfcheck.cli.parts.command import Command
from sdfcheck.cli.parts.options import formatted
from sdfcheck.cli.parts.terminal import emit
from sdfcheck.files.overwrite import overwrite
from sdfcheck.formats.sdf.version import NEWEST
from sdfcheck.source.wrong_usage import WrongUsage


@click.command(cls=Command, name="schema")
@click.option(
    "--sdf-version", metavar="VERSION", default=str(NEWEST), help=f"Of SDFormat.  [default: {NEWEST}]"
)
@formatted("XML Schema 1.0 or RELAX NG, which can say more.  [default: xsd]", "xsd", "rng")
@click.option("-o", "--output-file", type=click.Path(path_type=Path), metavar="FILE", help="Write it there.")
def schema_command(sdf_version: str, form: str, output_file: Path | None) -> None:
    """Write a version of SDFormat as a schema, for editors and XML tools.

    Children are free in their order, and elements and attributes with a (declared)
    prefix free altogether. XML Schema cannot say how often a child is then; RELAX NG can.
    """
    known = version(sdf_version)
    if form == "xsd":
        from sdfcheck.formats.export.xsd import xsd

        text = xsd(known)
    else:
        from sdfcheck.formats.export.rng import rng

        text = rng(known)
    if output_file is None:
        emit(text)
        return
    try:
        overwrite(output_file, text.encode())
    except OSError as error:
        raise WrongUsage(f"cannot write {output_file}: {error.strerror}") from None

"""``sdfcheck convert sdf-to-sdf``."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import click

from sdfcheck.cli.convert.command import convert_files
from sdfcheck.cli.convert.options import common, common_options
from sdfcheck.cli.parts.command import Command
from sdfcheck.source.sniff import Kind
from sdfcheck.source.wrong_usage import WrongUsage

if TYPE_CHECKING:
    from sdfcheck.convert.result import Conversion
    from sdfcheck.source.document import Document

_TARGETS = tuple(f"1.{minor}" for minor in range(12, 3, -1))


@click.command(cls=Command, name="sdf-to-sdf")
@click.option(
    "--to",
    "--sdf-version",
    "version",
    type=click.Choice(_TARGETS),
    required=True,
    metavar="VERSION",
    help="The version to write: 1.4 to 1.12.",
)
@click.option("--keep-unknown", is_flag=True, help="Keep what the version does not have.")
@common_options
def sdf_to_sdf(version: str, keep_unknown: bool, **given: Any) -> int:
    """Write SDFormat for the consumers of another version, newer or older.

    Comments, layout and elements of your own stay as they are.
    """
    from sdfcheck.convert.migrate.migrate import sdf_to_sdf as migrate
    from sdfcheck.formats.sdf.version import Version

    target = Version.parse(version)
    assert target is not None

    def convert(document: Document, verified: bool) -> Conversion:
        return migrate(document, target, keep_unknown=keep_unknown, verified=verified)

    request = common(given)
    if request.verify_with is not None:
        raise WrongUsage(
            f"--verify-with {request.verify_with} reads URDF, and neither the source nor the result is URDF"
        )
    return convert_files(request, {Kind.SDF: "SDFormat"}, ".sdf", convert)

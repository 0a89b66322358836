"""``sdfcheck convert sdf-to-sdf``."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import click

from sdfcheck.cli.convert.command import convert_files
from sdfcheck.cli.convert.options import common, common_options
from sdfcheck.cli.parts.command import Command
from sdfcheck.cli.parts.options import sdf_version
from sdfcheck.formats.version import Version
from sdfcheck.source.sniff import Kind
from sdfcheck.source.wrong_usage import WrongUsage

if TYPE_CHECKING:
    from sdfcheck.convert.result import Conversion
    from sdfcheck.source.document import Document


@click.command(cls=Command, name="sdf-to-sdf")
@sdf_version("The version to write", Version(1, 4), name="version", required=True)
@click.option("--keep-unknown", is_flag=True, help="Keep what the version does not have.")
@common_options
def sdf_to_sdf(version: Version, keep_unknown: bool, **given: Any) -> int:
    """Write SDFormat for the consumers of another version, newer or older.

    Comments, layout and elements of your own stay as they are.
    """
    from sdfcheck.convert.migrate.migrate import sdf_to_sdf as migrate

    def convert(document: Document, verified: bool) -> Conversion:
        return migrate(document, version, keep_unknown=keep_unknown, verified=verified)

    request = common(given)
    if blind := [name for name in request.verify_with if name not in {"gazebo", "drake"}]:
        raise WrongUsage(
            f"--verify-with {blind[0]} reads URDF, and neither the source nor the result is URDF"
        )
    return convert_files(request, {Kind.SDF: "SDFormat"}, ".sdf", convert)

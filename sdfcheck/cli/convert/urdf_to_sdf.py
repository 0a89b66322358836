"""``sdfcheck convert urdf-to-sdf``."""

from __future__ import annotations

from collections.abc import Callable
from enum import Enum
from typing import TYPE_CHECKING, Any

import click

from sdfcheck.cli.convert.command import convert_files
from sdfcheck.cli.convert.options import common, common_options
from sdfcheck.cli.parts.command import Command
from sdfcheck.cli.parts.options import sdf_version
from sdfcheck.consumers.reaction import Consumer
from sdfcheck.convert.urdf_to_sdf.options import FixedJoints, Massless, Options, PackageUris
from sdfcheck.formats.version import Version
from sdfcheck.source.sniff import Kind

if TYPE_CHECKING:
    from sdfcheck.convert.result import Conversion
    from sdfcheck.source.document import Document

_KINDS = {Kind.URDF: "URDF", Kind.XACRO: "xacro"}


def _choice(
    flag: str, kind: type[Enum], default: Enum, help: str
) -> Callable[[Callable[..., Any]], Callable[..., Any]]:
    choices = click.Choice([member.value for member in kind])
    shown = f"{help}  [default: {default.value}]"
    return click.option(flag, type=choices, default=default.value, help=shown)


@click.command(cls=Command, name="urdf-to-sdf")
@common_options
@sdf_version("The version to write", Version(1, 4))
@_choice("--fixed-joints", FixedJoints, FixedJoints.KEEP, "Keep them, or make one link of what they join.")
@_choice("--massless", Massless, Massless.MERGE, "What becomes of links without mass.")
@click.option(
    "--like",
    type=click.Choice([Consumer.GAZEBO.value]),
    help="Merge, drop and name what this simulator does when it reads URDF.",
)
@_choice("--package-uris", PackageUris, PackageUris.MODEL, "How to write package://.")
def urdf_to_sdf(**given: Any) -> int:
    """Convert URDF or xacro to SDFormat.

    Names, order, comments and numbers stay as they are; what SDFormat cannot say is
    reported. Arguments of xacro follow the files as NAME:=VALUE.

    \b
    --massless merge   make it part of what it is fixed to, else small
               small   give it a negligible mass
               auto    let the simulator compute its inertia (1.11), else small
               refuse  do not convert
    """
    request = common(given)
    like = None if given["like"] is None else Consumer(given["like"])
    if like and (given["fixed_joints"], given["massless"]) != (FixedJoints.KEEP.value, Massless.MERGE.value):
        raise click.UsageError(f"--like {like.value} decides what --fixed-joints and --massless ask for")
    options = Options(
        given["sdf_version"],
        FixedJoints(given["fixed_joints"]),
        Massless(given["massless"]),
        PackageUris(given["package_uris"]),
        like,
    )

    def convert(document: Document, verified: bool) -> Conversion:
        from sdfcheck.convert.urdf_to_sdf.conversion import urdf_to_sdf as run

        return run(document, options, verified=verified)

    return convert_files(request, _KINDS, ".sdf", convert)

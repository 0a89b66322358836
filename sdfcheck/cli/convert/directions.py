"""The commands ``convert urdf-to-sdf``, ``sdf-to-urdf`` and ``sdf-to-sdf``."""

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
from sdfcheck.source.errors import WrongUsage
from sdfcheck.source.sniff import Kind

if TYPE_CHECKING:
    from sdfcheck.convert.result import Conversion
    from sdfcheck.source.document import Document


# ``sdfcheck convert urdf-to-sdf``.

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


# ``sdfcheck convert sdf-to-urdf``.

_POLICIES = click.Choice(["floating", "fixed", "error"])


@click.command(cls=Command, name="sdf-to-urdf")
@click.option("--model", default="", metavar="NAME", help="The model to convert, if there are several.")
@click.option("--keep-link-frames", is_flag=True, help="Keep link frames; massless links are at the joints.")
@click.option("--frames", is_flag=True, help="Make frames massless links.")
@click.option(
    "--ball", type=_POLICIES, default="floating", help="What a ball joint becomes.  [default: floating]"
)
@click.option(
    "--forest",
    type=_POLICIES,
    default="floating",
    help="How free links are tied together.  [default: floating]",
)
@click.option(
    "--loops",
    type=click.Choice(["error", "cut"]),
    default="error",
    help="Joints that close loops: refuse, or leave them to libsdformat.  [default: error]",
)
@click.option(
    "--planes",
    type=click.Choice(["drop", "box"]),
    default="drop",
    help="Leave planes out, or write flat boxes.  [default: drop]",
)
@click.option(
    "--unlimited", type=float, default=1e16, metavar="NUMBER", help="Written for no limit.  [default: 1e16]"
)
@click.option(
    "--model-uris",
    type=click.Choice(["keep", "package"]),
    default="keep",
    help="How to write model://.  [default: keep]",
)
@click.option("--package-uris", is_flag=True, hidden=True)
@common_options
def sdf_to_urdf(**given: Any) -> int:
    """Write a model as URDF.

    The frame of a link in URDF is that of its joint: where SDF has it elsewhere, it moves,
    and everything in the link stays in place.
    """
    from sdfcheck.convert.sdf_to_urdf import Loops, Options, Planes, Unsupported
    from sdfcheck.convert.sdf_to_urdf import convert as convert_model

    request = common(given)
    given["package_uris"] |= given.pop("model_uris") == "package"
    kinds = {"ball": Unsupported, "forest": Unsupported, "loops": Loops, "planes": Planes}
    options = Options(**{**given, **{name: kind(given[name]) for name, kind in kinds.items()}})

    def convert(document: Document, verified: bool) -> Conversion:
        return convert_model(document, options, verified=verified)

    return convert_files(request, {Kind.SDF: "an SDF model"}, ".urdf", convert)


# ``sdfcheck convert sdf-to-sdf``.


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

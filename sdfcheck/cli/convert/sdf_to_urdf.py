"""``sdfcheck convert sdf-to-urdf``."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import click

from sdfcheck.cli.convert.command import convert_files
from sdfcheck.cli.convert.options import common, common_options
from sdfcheck.cli.parts.command import Command
from sdfcheck.source.sniff import Kind

if TYPE_CHECKING:
    from sdfcheck.convert.result import Conversion
    from sdfcheck.source.document import Document

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

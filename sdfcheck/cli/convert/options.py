"""The options that all conversions share."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import click

from sdfcheck.cli.parts.descriptions import ARGUMENT, SearchContext, around, surroundings
from sdfcheck.cli.parts.options import colored, configured, path, reported, together, written
from sdfcheck.cli.parts.output import FORMATS
from sdfcheck.formats.near_names import did_you_mean
from sdfcheck.lint.diagnostic import Severity
from sdfcheck.source.errors import WrongUsage
from sdfcheck.source.record import NamedTuple


class Request(NamedTuple):
    """The options of every command."""

    inputs: tuple[str, ...]
    output_file: Path | None
    output_dir: Path | None
    flat: bool
    uri_style: str
    copy_meshes: bool
    stdin_filename: Path | None
    verify: bool
    verify_with: tuple[str, ...]
    strict: bool
    lint: bool
    no_expand: bool
    losses: str
    min_severity: str
    output_format: tuple[str, ...]
    report: Path | None
    color: str
    quiet: bool
    around: SearchContext

    @property
    def paths(self) -> tuple[Path, ...]:
        """The files and folders that are named; ``-`` is stdin."""
        return tuple(Path(text) for text in self.inputs if ARGUMENT not in text)


URI_STYLES = ("keep", "package", "model", "file", "relative")
JUDGES = ("gazebo", "drake", "mujoco", "pybullet", "pinocchio", "yourdfpy")


def _judges(context: click.Context, parameter: click.Parameter, value: tuple[str, ...]) -> tuple[str, ...]:
    names = tuple(word.strip() for text in value for word in text.split(",") if word.strip())
    for name in names:
        if name not in JUDGES:
            near = did_you_mean(name, JUDGES) or f" (choose from {', '.join(JUDGES)})"
            raise WrongUsage(f"--verify-with: unknown consumer `{name}`{near}")
    return tuple(dict.fromkeys(names))


_PATH = click.Path(path_type=Path)
common_options = together(
    click.argument("inputs", nargs=-1, required=True, metavar="IN… [ARG:=VALUE]…"),
    written("Write the result there instead of to stdout."),
    click.option("--output-dir", type=_PATH, metavar="FOLDER", help="Write a file for each input there."),
    click.option(
        "--flat", is_flag=True, help="Make no folders in --output-dir: refuse inputs with the same name."
    ),
    click.option(
        "--uri-style",
        type=click.Choice(URI_STYLES),
        default="keep",
        help="How to write the addresses of meshes and other files.  [default: keep]",
    ),
    click.option(
        "--copy-meshes",
        is_flag=True,
        help="Copy meshes, with their textures, to the folder of the result, which names them there.",
    ),
    path("--stdin-filename", "What to call the text that `-` reads from stdin."),
    click.option(
        "--verify/--no-verify", default=True, help="Compare the result with its source.  [default: verify]"
    ),
    click.option(
        "--verify-with",
        multiple=True,
        callback=_judges,
        metavar="CONSUMERS",
        help=f"Let these read source and result as well: {', '.join(JUDGES)}.",
    ),
    click.option("--strict", is_flag=True, help="Exit with 1 if anything is lost."),
    click.option(
        "--lint/--no-lint",
        default=True,
        help="Stop at errors for which the format's own parser refuses the source.  [default: lint]",
    ),
    click.option(
        "--no-expand", is_flag=True, help="Read left-over xacro as URDF, whose consumers ignore it."
    ),
    click.option("--expand", type=click.Choice(["auto", "never"]), default="auto", hidden=True),
    click.option(
        "--losses",
        type=click.Choice(["grouped", "all"]),
        default="grouped",
        help="A line for each file and code, or each loss with its lines of code.  [default: grouped]",
    ),
    click.option(
        "--min-severity",
        type=click.Choice([severity.value for severity in Severity]),
        default=Severity.WARNING.value,
        help="Show what is at least so severe, and count the rest (text formats).  [default: warning]",
    ),
    reported(f"How to report all losses: {', '.join(FORMATS)}. May be repeated, with a file each."),
    click.option(
        "--report",
        type=_PATH,
        metavar="FILE",
        help="Write a page that shows the robot before and after, with losses at their parts (one input).",
    ),
    surroundings,
    configured,
    colored(),
    click.option("-q", "--quiet", is_flag=True, help="Report losses, and say nothing else."),
)
"""The options of all commands; they are listed below the command's own."""


def common(given: dict[str, Any]) -> Request:
    """Takes the common options out of what click has read; the rest is the command's own."""
    given["arguments"] = [text for text in given["inputs"] if ARGUMENT in text]
    given["around"] = around(given)
    given["no_expand"] |= given.pop("expand") == "never"
    return Request(**{name: given.pop(name) for name in Request._fields})

"""``--sdf-version``: a version of SDFormat, the same for all commands."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import click

from sdfcheck.cli.parts import completing
from sdfcheck.cli.parts.options import F, Renamed
from sdfcheck.formats.sdf.version import NEWEST, OLDEST, Version
from sdfcheck.source.wrong_usage import WrongUsage


def sdf_version(
    help: str, oldest: Version = OLDEST, *, name: str = "sdf_version", required: bool = False
) -> Callable[[F], F]:
    """The option, passed as a ``Version`` from ``oldest`` on; by default the newest."""

    def parsed(context: click.Context, parameter: click.Parameter, given: str) -> Version:
        known = Version.parse(given)
        if known is None or known < oldest:
            raise WrongUsage(f"unknown version `{given}` of SDFormat (choose from {oldest} to {NEWEST})")
        return known

    default: dict[str, Any] = {"required": True} if required else {"default": str(NEWEST)}
    shown = "required" if required else f"default: {NEWEST}"
    return click.option(
        "--sdf-version",
        name,
        cls=Renamed,
        old=["--to"],
        metavar="VERSION",
        callback=parsed,
        shell_complete=completing.versions,
        help=f"{help}: {oldest} to {NEWEST}.  [{shown}]",
        **default,
    )

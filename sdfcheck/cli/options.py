"""Options that several commands share."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any, TypeVar

import click

PATH = click.Path(path_type=Path)
F = TypeVar("F", bound=Callable[..., Any])


def configured(command: F) -> F:
    """``--config`` and ``--isolated``: by which configuration to go."""
    command = click.option("--isolated", is_flag=True, help="Use no configuration file.")(command)
    return click.option("--config", type=PATH, metavar="FILE", help="Use this configuration file.")(command)


def colored(help: str = "When to colour.") -> Callable[[F], F]:
    """``--color``: auto, always or never."""
    kind = click.Choice(["auto", "always", "never"])
    return click.option("--color", type=kind, default="auto", help=help)

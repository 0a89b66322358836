"""Options that several commands share."""

from __future__ import annotations

import os
from collections.abc import Callable
from functools import wraps
from pathlib import Path
from typing import Any, TypeVar

import click

from sdfcheck.cli.parts import completing
from sdfcheck.source.wrong_usage import WrongUsage

PATH = click.Path(path_type=Path)
F = TypeVar("F", bound=Callable[..., Any])


_CONFIGURATION = (
    click.option("--config", type=PATH, metavar="FILE", help="Use this configuration file and no other."),
    click.option("--isolated", is_flag=True, help="Use no configuration file."),
    click.option(
        "--trust-config",
        is_flag=True,
        help="Let the configuration that is found run code (plugins), write files and lead elsewhere.",
    ),
)


def configured(command: Callable[..., Any]) -> Any:
    """``--config``, ``--isolated`` and ``--trust-config``, passed as one ``configuration``."""

    @wraps(command)
    def with_configuration(
        *, config: Path | None, isolated: bool, trust_config: bool, **given: Any
    ) -> object:
        from sdfcheck.lint.config.configuration import Configuration

        if config is not None and isolated:
            raise WrongUsage("--config and --isolated exclude each other")
        if isolated and trust_config:
            raise WrongUsage("--isolated and --trust-config exclude each other")
        configuration = Configuration(config, isolated=isolated, trusted=trust_config)
        return command(configuration=configuration, **given)

    for option in reversed(_CONFIGURATION):
        with_configuration = option(with_configuration)
    return with_configuration


def colored(help: str = "When to color.") -> Callable[[F], F]:
    """``--color``: auto, always or never."""
    kind = click.Choice(["auto", "always", "never"])
    return click.option("--color", type=kind, default="auto", help=help)


def formatted(help: str, *choices: str) -> Callable[[F], F]:
    """``--format``, passed as ``form``: one of the choices, by default the first."""
    return click.option("--format", "form", type=click.Choice(choices), default=choices[0], help=help)


def _commas(
    context: click.Context, parameter: click.Parameter, value: tuple[str, ...]
) -> tuple[str, ...] | None:
    """Lists may be given in one option or in several; None if none is given."""
    if not value:
        return None
    return tuple(word.strip() for text in value for word in text.split(",") if word.strip())


def listing(flag: str, help: str, metavar: str = "RULES") -> Callable[[Any], Any]:
    """An option for a list: of rules, or else of targets."""
    offered = completing.rules if metavar == "RULES" else completing.targets
    return click.option(
        flag, multiple=True, callback=_commas, metavar=metavar, help=help, shell_complete=offered
    )


def path(flag: str, help: str) -> Callable[[Any], Any]:
    """An option for a file."""
    return click.option(flag, type=PATH, metavar="FILE", help=help)


def folders(flag: str, name: str, help: str) -> Callable[[Any], Any]:
    """An option for a folder, which may be repeated."""
    return click.option(flag, name, multiple=True, type=PATH, metavar="FOLDER", help=help)


def require_file(file: Path) -> None:
    """Make sure that an input is a file.

    Raises:
        WrongUsage: there is none, or it is a folder, a pipe or a device.
    """
    if not file.is_file():
        from sdfcheck.files.regular import oddity

        raise WrongUsage(f"{file}: {oddity(file)}" if os.path.lexists(file) else f"no such file: {file}")

"""``sdfcheck completion``."""

from __future__ import annotations

import click

from sdfcheck.cli.parts.command import Command
from sdfcheck.cli.parts.terminal import emit
from sdfcheck.source.errors import WrongUsage

_VARIABLE = "_SDFCHECK_COMPLETE"


@click.command(cls=Command)
@click.argument("shell", type=click.Choice(["bash", "zsh", "fish"]))
@click.pass_context
def completion(context: click.Context, shell: str) -> None:
    """Write the script that completes commands, options, rules and places in a SHELL."""
    from click.shell_completion import get_completion_class

    kind = get_completion_class(shell)
    if kind is None:
        raise WrongUsage(f"no completion for {shell}")
    root = context.find_root().command
    try:
        emit(kind(root, {}, "sdfcheck", _VARIABLE).source())
    except RuntimeError as error:
        raise WrongUsage(str(error)) from None

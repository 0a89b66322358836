"""A group of commands that are imported when they are called."""

from __future__ import annotations

from collections.abc import Mapping
from importlib import import_module
from typing import Any

import click

from sdfcheck.source.record import NamedTuple


class LazyCommand(NamedTuple):
    """Where a command is, as ``module:name``, and its line in the list of commands."""

    place: str
    summary: str

    def load(self) -> click.Command:
        module, _, name = self.place.partition(":")
        command = getattr(import_module(module), name)
        assert isinstance(command, click.Command)
        return command


class LazyGroup(click.Group):
    """Lists its commands without importing one."""

    def __init__(
        self,
        *args: Any,
        lazy: Mapping[str, LazyCommand],
        meant: Mapping[str, str] | None = None,
        endings: Mapping[str, str] | None = None,
        **kwargs: Any,
    ) -> None:
        super().__init__(*args, **kwargs)
        self._lazy = lazy
        self._meant = meant or {}
        """Words that people try for a command → what to write instead."""
        self._endings = endings or {}
        """Ends of names of files → the command that takes such a file."""

    def parse_args(self, ctx: click.Context, args: list[str]) -> list[str]:
        if not args and not ctx.resilient_parsing:
            # In some versions of click this is an error whose message is the help.
            click.echo(ctx.get_help(), color=ctx.color)
            ctx.exit(2)
        return super().parse_args(ctx, args)

    def list_commands(self, ctx: click.Context) -> list[str]:
        return list(self._lazy)

    def get_command(self, ctx: click.Context, cmd_name: str) -> click.Command | None:
        lazy = self._lazy.get(cmd_name)
        return lazy.load() if lazy else None

    def resolve_command(
        self, ctx: click.Context, args: list[str]
    ) -> tuple[str | None, click.Command | None, list[str]]:
        if args and args[0] not in self._lazy and not args[0].startswith("-"):
            meant = self._meant.get(args[0].lower()) or self._for_file(args[0])
            hint = f"; try `{meant}`" if meant else self._guess(args[0])
            ctx.fail(f"no such command: {args[0]}{hint}")
        return super().resolve_command(ctx, args)

    def _guess(self, word: str) -> str:
        """The question after a misspelled command, or usual name of one."""
        from sdfcheck.formats.near_names import nearest

        near = nearest(word.lower(), (*self._lazy, *self._meant))
        return "" if near is None else f"; did you mean `{self._meant.get(near, near)}`?"

    def _for_file(self, name: str) -> str | None:
        """The command to write where a file is named in its place."""
        commands = (command for ending, command in self._endings.items() if name.endswith(ending))
        command = next(commands, None)
        return f"{command} {name}" if command else None

    def format_commands(self, ctx: click.Context, formatter: click.HelpFormatter) -> None:
        with formatter.section("Commands"):
            formatter.write_dl([(name, lazy.summary) for name, lazy in self._lazy.items()])

"""The classes of commands and groups: help lists options by subject, commands are imported when called."""

from __future__ import annotations

from collections.abc import Mapping
from importlib import import_module
from typing import Any

import click

from sdfcheck.source.record import NamedTuple

# A group of commands that are imported when they are called.


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


# The class of all commands: the help lists options by subject, and ends with examples.


_SECTIONS = {
    "Input": """
        stdin_filename kind no_expand packages package_paths model_paths env exclude changed_since force_exclude
        skip_unrelated
    """.split(),
    "Selection": "select extend_select ignore preview target baseline write_baseline".split(),
    "Fixes": "fix unsafe_fixes fix_only show_fixes diff add_ignore reason".split(),
    "Verification": "verify verify_with strict lint".split(),
    "Simulation": "run simulators seconds time_limit".split(),
    "Output": """
        output_dir flat output_format output_file form losses statistics min_severity max_diagnostics no_fold
        color quiet
    """.split(),
    "Exit code": "fail_on fail_on_missing max_warnings exit_zero".split(),
    "Configuration": "config isolated trust_config show_settings show_files".split(),
}
"""Heading → the options that are listed below it, by name; others come first."""
_OWN = "Options"
_REST = "Other"

_EXAMPLES = {
    "lint": (
        ("sdfcheck lint", "all robot descriptions below the current folder"),
        ("sdfcheck lint --fix models/", "apply the safe fixes"),
        ("sdfcheck lint --target drake arm.urdf.xacro side:=left", "what matters to Drake"),
    ),
    "expand": (
        ("sdfcheck expand arm.urdf.xacro side:=left", "what xacro makes of a file"),
        ("sdfcheck expand --annotate arm.urdf.xacro", "with where each element came from"),
    ),
    "graph": (
        ("sdfcheck graph joints arm.urdf", "the kinematic tree"),
        ("sdfcheck graph frames --output-format mermaid arm.sdf", "for a page in Markdown"),
    ),
    "targets": (
        ("sdfcheck targets arm.urdf", "who accepts it, and why others do not"),
        ("sdfcheck targets --run arm.urdf", "and what those that are installed really do"),
        ("sdfcheck targets --output-format json model.sdf", "for a program"),
    ),
    "simulate": (
        ("sdfcheck simulate arm.urdf", "in the first simulator that is installed"),
        ("sdfcheck simulate --in mujoco,drake model.sdf", "in two, compared"),
    ),
    "describe": (
        ("sdfcheck describe joint/axis", "an element of SDFormat"),
        ("sdfcheck describe urdf:joint/limit", "an element of URDF"),
    ),
    "diff": (
        ("sdfcheck diff old.sdf new.sdf", "what changed in the robot"),
        ("sdfcheck diff arm.urdf arm.sdf", "between formats"),
    ),
    "inertia": (
        ("sdfcheck inertia arm.urdf", "each link, and the total"),
        ("sdfcheck inertia --output-format json arm.sdf", "for a program"),
    ),
    "print": (
        ("sdfcheck print arm.sdf", "in canonical form"),
        ("sdfcheck print --expand-includes world.sdf", "as one file"),
    ),
    "schema": (
        ("sdfcheck schema --for model.sdf -o sdf.xsd", "for the version of a file"),
        ("sdfcheck schema --output-format rng -o sdf.rng", "for xmllint"),
    ),
    "rules": (
        ("sdfcheck rules", "all of them"),
        ("sdfcheck rules NS --output-format json", "a family, for a program"),
    ),
    "rule": (
        ("sdfcheck rule NS", "a family"),
        ("sdfcheck rule ALL --output-format json", "all, for a program"),
    ),
    "urdf-to-sdf": (
        ("sdfcheck convert urdf-to-sdf arm.urdf -o arm.sdf", "one file"),
        ("sdfcheck convert urdf-to-sdf robots/ --output-dir sdf", "a folder"),
    ),
    "sdf-to-urdf": (
        ("sdfcheck convert sdf-to-urdf model.sdf -o arm.urdf", "one file"),
        ("sdfcheck convert sdf-to-urdf --model arm world.sdf", "a model of a world"),
    ),
    "sdf-to-sdf": (
        ("sdfcheck convert sdf-to-sdf old.sdf --sdf-version 1.12 -o new.sdf", "up"),
        ("sdfcheck convert sdf-to-sdf new.sdf --sdf-version 1.6 -o old.sdf", "down"),
    ),
    "server": (
        ("sdfcheck server", "what an editor starts"),
        ("sdfcheck server --tcp --port 5007", "to look at what is said"),
    ),
    "view": (
        ("sdfcheck view arm.urdf", "show a robot in the browser"),
        ("sdfcheck view before.urdf after.sdf -o both.html", "two robots beside each other"),
    ),
    "config": (
        ("sdfcheck config", "all keys of a configuration"),
        ("sdfcheck config --output-format schema -o sdfcheck.schema.json", "for editors"),
    ),
    "init": (
        ("sdfcheck init", "write sdfcheck.toml here"),
        ("sdfcheck init --target gazebo,drake", "for these simulators"),
    ),
    "completion": (
        ("sdfcheck completion bash > ~/.local/share/bash-completion/completions/sdfcheck", "for bash"),
        ("sdfcheck completion fish > ~/.config/fish/completions/sdfcheck.fish", "for fish"),
    ),
}
"""Command → what to type, and what it does."""


class Command(click.Command):
    """A command whose help is in sections, and which knows the options that people try."""

    def parse_args(self, ctx: click.Context, args: list[str]) -> list[str]:
        try:
            return super().parse_args(ctx, args)
        except click.NoSuchOption as error:
            known = [name for parameter in self.get_params(ctx) for name in parameter.opts]
            raise click.UsageError(_no_option(error.option_name, known), ctx) from None

    def format_options(self, ctx: click.Context, formatter: click.HelpFormatter) -> None:
        sections: dict[str, list[tuple[str, str]]] = {heading: [] for heading in (_OWN, *_SECTIONS)}
        sections[_REST] = []
        for parameter in self.get_params(ctx):
            row = parameter.get_help_record(ctx) if isinstance(parameter, click.Option) else None
            if row:
                sections[_heading(parameter)].append(row)
        for heading, rows in sections.items():
            if rows:
                with formatter.section(heading):
                    formatter.write_dl(rows)

    def format_epilog(self, ctx: click.Context, formatter: click.HelpFormatter) -> None:
        super().format_epilog(ctx, formatter)
        examples = _EXAMPLES.get(self.name or "", ())
        if examples:
            with formatter.section("Examples"):
                formatter.write_dl([*examples])


_MEANT = {
    **dict.fromkeys(("--output", "--reporter", "--report"), "--output-format"),
    **{f"--{form}": f"--output-format {form}" for form in ("json", "sarif", "junit", "html", "markdown")},
    **dict.fromkeys(("--xunit", "--xunit-file"), "--output-format junit=FILE"),
    **dict.fromkeys(("--out", "--outfile"), "--output-file"),
    **dict.fromkeys(("--rule", "--rules", "--enable", "--only"), "--select"),
    **dict.fromkeys(("--disable", "--skip", "--exclude-rule"), "--ignore"),
    **dict.fromkeys(("--severity", "--level"), "--min-severity"),
    **dict.fromkeys(("--strict", "--fail-level", "--error-on"), "--fail-on"),
    **dict.fromkeys(("--no-fail", "--soft-fail"), "--exit-zero"),
    **dict.fromkeys(("--autofix", "--write", "--fix-unsafe"), "--fix"),
    **dict.fromkeys(("--unsafe",), "--unsafe-fixes"),
    **dict.fromkeys(("--simulator", "--consumer", "--consumers", "--targets", "--for"), "--target"),
    **dict.fromkeys(("--arg", "--args", "--xacro-args", "--xacro-arg"), "NAME:=VALUE"),
    **dict.fromkeys(("--workers", "--parallel", "--processes", "--threads"), "--jobs"),
}
"""Options of other programs → what to write here."""


def _no_option(name: str, known: list[str]) -> str:
    from sdfcheck.formats.near_names import suggest

    meant = _MEANT.get(name, "")
    if meant.startswith("--") and meant.partition(" ")[0] not in known:
        meant = ""
    meant = meant or suggest(name, known) or ""
    return f"no such option: {name}" + (f"; try `{meant}`" if meant else "")


def _heading(option: click.Parameter) -> str:
    if option.name == "jobs" or "--help" in option.opts:
        return _REST
    return next((heading for heading, names in _SECTIONS.items() if option.name in names), _OWN)

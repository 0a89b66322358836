"""The command ``sdfcheck``.

Exit codes: 0 clean, 1 findings, 2 could not run, 130 interrupted.
"""

from __future__ import annotations

import os
import sys
import warnings
from collections.abc import Sequence
from io import StringIO
from typing import NoReturn

import click

from sdfcheck.cli.parts.command import LazyCommand, LazyGroup
from sdfcheck.cli.parts.terminal import say
from sdfcheck.files.regular import noting
from sdfcheck.release import HOME, __version__
from sdfcheck.source.errors import REPORT_IT, WrongUsage

COMMANDS = {
    "lint": LazyCommand("sdfcheck.cli.lint:lint", "Check files and folders."),
    "convert": LazyCommand("sdfcheck.cli.convert.command:convert", "Convert between formats."),
    "expand": LazyCommand("sdfcheck.cli.expand:expand", "Expand a xacro file."),
    "graph": LazyCommand("sdfcheck.cli.graph:graph_command", "Show frames, poses or joints as a tree."),
    "view": LazyCommand("sdfcheck.cli.view:view", "Show a robot in a browser."),
    "targets": LazyCommand("sdfcheck.cli.targets:targets_command", "Say which consumers accept a file."),
    "simulate": LazyCommand("sdfcheck.cli.simulate:simulate", "Let a robot run in a simulator."),
    "describe": LazyCommand("sdfcheck.cli.describe:describe_command", "Say what a format allows somewhere."),
    "diff": LazyCommand("sdfcheck.cli.diff:diff", "Show what changed in the robot."),
    "inertia": LazyCommand("sdfcheck.cli.inertia:inertia", "Show masses, centers of mass and inertias."),
    "print": LazyCommand("sdfcheck.cli.print:print_command", "Write a file in canonical form."),
    "schema": LazyCommand("sdfcheck.cli.schema:schema_command", "Write SDFormat as XML Schema or RELAX NG."),
    "server": LazyCommand("sdfcheck.cli.server:server_command", "Run the language server."),
    "rules": LazyCommand("sdfcheck.cli.rules:rules", "List all rules."),
    "rule": LazyCommand("sdfcheck.cli.rules:rule", "Explain rules."),
    "init": LazyCommand("sdfcheck.cli.config:init", "Write a configuration to begin with."),
    "config": LazyCommand("sdfcheck.cli.config:config", "List the keys of a configuration."),
    "completion": LazyCommand("sdfcheck.cli.completion:completion", "Write the completion of a shell."),
}
_MEANT = {
    **dict.fromkeys(("check", "validate", "verify", "test", "run", "analyze"), "sdfcheck lint"),
    **dict.fromkeys(("fix", "autofix"), "sdfcheck lint --fix"),
    **dict.fromkeys(("explain", "why", "docs", "doc", "info"), "sdfcheck rule RULE"),
    **dict.fromkeys(("format", "fmt", "pretty", "canonical"), "sdfcheck print FILE"),
    **dict.fromkeys(("tree", "joints", "links"), "sdfcheck graph joints FILE"),
    **dict.fromkeys(("frames", "poses"), "sdfcheck graph frames FILE"),
    **dict.fromkeys(("mass", "inertias", "inertial"), "sdfcheck inertia FILE"),
    **dict.fromkeys(("compare", "cmp"), "sdfcheck diff OLD NEW"),
    **dict.fromkeys(("xacro", "preprocess"), "sdfcheck expand FILE"),
    **dict.fromkeys(("urdf2sdf", "urdf-to-sdf", "to-sdf"), "sdfcheck convert urdf-to-sdf FILE"),
    **dict.fromkeys(("sdf2urdf", "sdf-to-urdf", "to-urdf"), "sdfcheck convert sdf-to-urdf FILE"),
    **dict.fromkeys(("sdf-to-sdf", "upgrade", "migrate", "update"), "sdfcheck convert sdf-to-sdf FILE"),
    **dict.fromkeys(("list", "list-rules"), "sdfcheck rules"),
    **dict.fromkeys(("configure", "new"), "sdfcheck init"),
    **dict.fromkeys(("settings", "show-settings"), "sdfcheck config"),
    **dict.fromkeys(("consumers", "simulators", "target", "compat"), "sdfcheck targets FILE"),
    **dict.fromkeys(("behave", "physics", "drop", "sim"), "sdfcheck simulate FILE"),
    **dict.fromkeys(("xsd", "rng"), "sdfcheck schema"),
    **dict.fromkeys(("help", "man"), "sdfcheck --help"),
    **dict.fromkeys(("version",), "sdfcheck --version"),
}
"""Usual names of a command → the name here."""


def _show_version(context: click.Context, _: click.Parameter, is_wanted: bool) -> None:
    if not is_wanted:
        return
    click.echo(f"sdfcheck {__version__}")
    if context.params["verbose"]:
        from sdfcheck.xacro.expansion import Expander

        with Expander() as expander:
            walls = expander.walls()
        click.echo(f"Python {sys.version.split()[0]} on {sys.platform}")
        click.echo("expansion of xacro files, in a process of its own:")
        for wall, is_standing in {"interpreter of expressions": True, **walls}.items():
            click.echo(f"  {wall}: {'active' if is_standing else 'not available'}")
    context.exit()


@click.group(
    cls=LazyGroup,
    lazy=COMMANDS,
    meant=_MEANT,
    endings=dict.fromkeys((".sdf", ".world", ".urdf", ".xacro", "model.config"), "sdfcheck lint"),
    context_settings={"help_option_names": ["-h", "--help"], "max_content_width": 100},
    epilog=f"Documentation: {HOME}",
)
@click.option(
    "-V",
    "--version",
    is_flag=True,
    expose_value=False,
    callback=_show_version,
    help="Show the version and exit.",
)
@click.option(
    "--verbose",
    is_flag=True,
    is_eager=True,
    help="With --version: show what locks up the expansion of xacro files.",
)
def sdfcheck(verbose: bool) -> None:
    """Linter and converter for SDFormat, URDF and xacro robot descriptions.

    To begin: `sdfcheck lint` in the folder of a robot. Each finding names its rule, and
    `sdfcheck rule NAME` explains it.
    """
    if verbose:
        raise click.UsageError("`--verbose` goes with `--version`")


def run() -> NoReturn:
    """The program ``sdfcheck``: a short-lived process, which is not taken apart piece by piece in the end."""
    if not sys.warnoptions:
        # Warnings of numpy about a document's numbers are of no use to its author.
        warnings.simplefilter("ignore")
    # Threads for the small matrices of a robot cost more than they bring.
    os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")
    code = main()
    try:
        for stream in filter(None, (sys.stdout, sys.stderr)):
            stream.flush()
    except OSError:
        code = code or 2
    os._exit(code)


def main(arguments: Sequence[str] | None = None) -> int:
    """Run a command line (default: the process's own); returns the exit code."""
    try:
        with noting():
            result = sdfcheck.main(arguments, prog_name="sdfcheck", standalone_mode=False)
        return result if isinstance(result, int) else 0
    except (click.Abort, KeyboardInterrupt):
        return 130
    except click.ClickException as error:
        _complain(error)
        return 2
    except WrongUsage as error:
        say(f"error: {error}")
        return 2
    except Exception as error:
        if os.environ.get("SDFCHECK_DEBUG"):
            raise
        say(_apology(error))
        return 2


def _complain(error: click.ClickException) -> None:
    """Say what is wrong with the command line; the message may repeat any name of a file."""
    if isinstance(error, getattr(click.exceptions, "NoArgsIsHelpError", ())):
        for line in error.format_message().splitlines():
            say(line)
        return
    message = f"Error: {error.format_message()}"
    with StringIO() as shown:
        error.show(shown)
        usage = shown.getvalue().removesuffix(f"{message}\n")
    if isinstance(error, click.MissingParameter):
        message = " ".join(message.split())  # it lists choices one below the other
    for line in usage.splitlines():
        say(line)
    # Click lists choices in lines.
    say(message.replace(":\n\t", ": ").replace(",\n\t", ", "))


def _apology(error: Exception) -> str:
    """One line about a bug; errors that know their file say so themselves."""
    text = str(error) if error.__cause__ else f"{type(error).__name__}: {error}"
    return f"internal error: {' '.join(text.split())} ({REPORT_IT})"

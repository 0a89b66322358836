"""``sdfcheck simulate``."""

from __future__ import annotations

import sys
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from sdfcheck.cli.parts.command import Command
from sdfcheck.cli.parts.descriptions import around, described, expander_for, load
from sdfcheck.cli.parts.options import colored, limited, reported, require_file, written
from sdfcheck.cli.parts.output import FORMATS, Output, outputs, refuse_to_write, write
from sdfcheck.cli.parts.terminal import say
from sdfcheck.cli.parts.view_options import Request, exit_code, gate_of, shown, view_of
from sdfcheck.consumers.engines import SIMULATORS as ENGINES
from sdfcheck.consumers.engines import Engine, Limits, is_installed
from sdfcheck.consumers.reaction import Manner
from sdfcheck.convert.simulation import MissingEngine, Settings
from sdfcheck.convert.simulation import simulate as run
from sdfcheck.formats.near_names import did_you_mean
from sdfcheck.lint.diagnostic import Severity
from sdfcheck.lint.engine import Dispatch, lint_document
from sdfcheck.lint.kinds import SIMULATED, SimKind
from sdfcheck.lint.one_file import silence_simulated
from sdfcheck.lint.rulebook.rulebook import RuleBook
from sdfcheck.lint.run import Run
from sdfcheck.report import OutputFormat
from sdfcheck.source.errors import WrongUsage
from sdfcheck.source.sniff import Kind

if TYPE_CHECKING:
    from sdfcheck.lint.config.settings import Settings as Configured
    from sdfcheck.lint.diagnostic import Diagnostic
    from sdfcheck.report.content import Robot
    from sdfcheck.source.document import Document

SIMULATORS = ("mujoco", "drake", "pybullet")
_MOVING = frozenset({"GEO", "JNT"})
"""The families of rules about shapes and joints: of a robot that moves, they say what no simulator notices."""


def _simulators(
    context: click.Context, parameter: click.Parameter, value: tuple[str, ...]
) -> tuple[str, ...]:
    names = tuple(word.strip() for text in value for word in text.split(",") if word.strip())
    for name in names:
        if name not in SIMULATORS:
            near = did_you_mean(name, SIMULATORS) or f" (choose from {', '.join(SIMULATORS)})"
            raise WrongUsage(f"--in: unknown simulator `{name}`{near}")
    return tuple(dict.fromkeys(names))


@click.command(cls=Command)
@click.argument("file", type=click.Path(path_type=Path))
@click.option(
    "--in",
    "simulators",
    multiple=True,
    callback=_simulators,
    metavar="SIMULATORS",
    help=f"Where to run it: {', '.join(SIMULATORS)}.  [default: the first that is installed]",
)
@click.option(
    "--seconds",
    type=click.FloatRange(min=0, min_open=True, max=60),
    default=2.0,
    metavar="SECONDS",
    help="How long the robot moves.  [default: 2]",
)
@limited
@shown
@reported(f"How to report: {', '.join(FORMATS)}. May be repeated, with a file each.  [default: full]")
@written("Write the report there instead of to stdout.")
@described
@colored()
@click.option("-q", "--quiet", is_flag=True, help="Report, and say nothing else.")
def simulate(  # noqa: PLR0913, PLR0917 - one for each option
    file: Path,
    simulators: tuple[str, ...],
    seconds: float,
    time_limit: float,
    output_format: tuple[str, ...],
    output_file: Path | None,
    color: str,
    quiet: bool,
    **given: Any,
) -> int:
    """Let a robot run in a simulator, and say what goes wrong, at its place in the text.

    It is loaded, let fall with its root link held and no force in its joints, its joints are
    moved through their ranges, and a robot with wheels is put on the ground. SDFormat is
    converted for the simulator.
    """
    require_file(file)
    surroundings = around(given)
    request = Request(**given)
    wanted = outputs(output_format or ("full",), output_file)
    refuse_to_write([output.file for output in wanted], [file])
    engines = _engines(simulators)
    from sdfcheck.convert.new_errors import refuse_broken

    document = load(file, surroundings)
    refuse_broken(document)
    settings = Settings(engines, seconds, Limits(time_limit))
    configured = surroundings.settings_for(file)
    failing, book = configured.fail_on, RuleBook()
    findings = _findings(document, settings, book.dispatch(configured, file), configured, quiet=quiet)
    found, silenced = silence_simulated(findings, (*book.rules(configured), *SIMULATED), configured, file)
    done = Run(tuple(found), (file,), suppressed=silenced, gate=gate_of(request, failing))
    drawn = _drawn(done, document, wanted)
    for output in wanted:
        write(output, done, color=color, view=view_of(request, failing), robots=drawn)
    if not quiet:
        converted = ", converted to URDF for it" if document.kind is Kind.SDF else ""
        say(f"simulated in {', '.join(engine.value for engine in engines)}{converted}: {seconds:g} s")
    return exit_code(request, done)


def _drawn(done: Run, document: Document, wanted: Sequence[Output]) -> Sequence[Robot]:
    """The robot for a page, which shows what is found when it happens."""
    if not any(output.format is OutputFormat.HTML for output in wanted):
        return ()
    from sdfcheck.report.content import robots

    return list(robots(done, [(document.path, document)]))


def _engines(names: Sequence[str]) -> tuple[Engine, ...]:
    """The simulators that are named, else the first that is installed."""
    usual = (engine for engine in ENGINES if is_installed(engine))
    chosen = tuple(map(Engine, names)) or tuple(usual)[:1]
    if not chosen:
        raise WrongUsage(f"no simulator is installed: {Engine.MUJOCO.advice}")
    return chosen


def _findings(
    document: Document, settings: Settings, dispatch: Dispatch, configured: Configured, *, quiet: bool
) -> list[Diagnostic]:
    """Of the simulation, and of a robot that is loaded, what rules about shapes and joints warn of, without fixes."""
    progress = _Progress(quiet=quiet)
    try:
        with expander_for(configured) as expander:
            found = run(document, settings, expander, progress)
    except MissingEngine as error:
        raise WrongUsage(str(error)) from None
    finally:
        progress.clear()
    if all(each.code != SimKind.NOT_LOADED.code for each in found):
        linted = (each for each in lint_document(document, dispatch) if each.code[:3] in _MOVING)
        found += (each.without_fix for each in linted if _concerns(each, settings))
    return sorted(found, key=lambda one: one.sort_key)


def _concerns(found: Diagnostic, settings: Settings) -> bool:
    """Is a finding about how the robot moves: not about this computer, nor what all simulators ignore?"""
    names = {engine.value for engine in settings.engines}
    reactions = [reaction.manner for consumer, reaction in found.affects if consumer in names]
    is_ignored = len(reactions) == len(names) and set(reactions) == {Manner.IGNORE}
    return found.severity is not Severity.INFO and not found.missing and not is_ignored


class _Progress:
    """One line of a terminal that says what runs now."""

    def __init__(self, *, quiet: bool) -> None:
        self._shown = sys.stderr.isatty() and not quiet

    def __call__(self, text: str) -> None:
        if self._shown:
            sys.stderr.write(f"\r\x1b[K{text} …")
            sys.stderr.flush()

    def clear(self) -> None:
        if self._shown:
            sys.stderr.write("\r\x1b[K")

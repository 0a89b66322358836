"""``sdfcheck lint``."""

from __future__ import annotations

import os
import sys
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from sdfcheck.cli.parts.command import Command
from sdfcheck.cli.parts.descriptions import ARGUMENT, arguments_in, check_arguments, robots_of
from sdfcheck.cli.parts.options import PATH, colored, configured, path, reported, settable, taken, written
from sdfcheck.cli.parts.output import FORMATS, Output, outputs, refuse_to_write, write
from sdfcheck.cli.parts.progress import Notifier, Progress
from sdfcheck.cli.parts.terminal import (
    emit,
    emit_lines,
    lines_of,
    read_stdin,
    say,
    wants_color,
    wants_links,
    width_of,
)
from sdfcheck.cli.parts.view_options import Request, exit_code, gate_of, shown, view_of
from sdfcheck.lint.config.settings import GIVEN
from sdfcheck.lint.parallel import run_in_parallel
from sdfcheck.lint.session import Level, Notice, Options, find, selected
from sdfcheck.source.errors import WrongUsage
from sdfcheck.source.sniff import Kind

if TYPE_CHECKING:
    from sdfcheck.lint.run import Run
    from sdfcheck.report.summary import View

_KINDS = (Kind.SDF, Kind.URDF, Kind.XACRO, Kind.MODEL_CONFIG)
_STDIN = Path("-")


@click.command(cls=Command)
@click.argument("paths", nargs=-1, type=PATH)
@settable(*GIVEN)
@click.option("--fix", is_flag=True, help="Apply safe fixes; report what is left.")
@click.option(
    "--unsafe-fixes", is_flag=True, help="With --fix or --diff: also those that a person should check."
)
@click.option(
    "--fix-only", is_flag=True, help="Apply safe fixes; do not report what is left, nor fail for it."
)
@click.option("--show-fixes", is_flag=True, help="List the fixes that were made.")
@click.option("--diff", is_flag=True, help="Show what --fix would change; exit with 1 if that is anything.")
@click.option("--add-ignore", is_flag=True, help="Silence what is found, by comments in the files.")
@click.option(
    "--reason", default="", metavar="TEXT", help="With --add-ignore: what the comments give as reason."
)
@path("--baseline", "Report only findings that this baseline does not hold.")
@click.option("--write-baseline", is_flag=True, help="Write what is found to the file of --baseline.")
@shown
@reported(f"How to report: {', '.join(FORMATS)}. May be repeated, with a file each.  [default: full]")
@written("Write the report there instead of to stdout.")
@click.option("--statistics", is_flag=True, help="Count diagnostics by rule instead of showing them.")
@path("--stdin-filename", "What to call the text that `-` reads from stdin.")
@click.option(
    "--kind",
    type=click.Choice([kind.value for kind in _KINDS]),
    help="What the named files are, whatever they look like.",
)
@click.option("--no-expand", is_flag=True, help="Check xacro files only as they are written.")
@click.option(
    "--exclude",
    type=PATH,
    multiple=True,
    metavar="PATH",
    help="A file or folder to leave out. May be repeated.",
)
@click.option(
    "--changed-since",
    default="",
    metavar="REF",
    help="Check only files that changed since a commit or branch of git, and those that name one of them.",
)
@click.option("--force-exclude", is_flag=True, help="Exclude also files that are named.")
@click.option(
    "--skip-unrelated",
    is_flag=True,
    help="Skip named files that are not robot descriptions, without a notice.",
)
@configured
@click.option("--show-files", is_flag=True, help="List the files that would be checked.")
@click.option("--show-settings", is_flag=True, help="Show the settings that apply to the first path.")
@click.option(
    "--jobs",
    type=click.IntRange(1),
    metavar="N",
    help="Lint many files in N processes.  [default: one for each processor, at most 8]",
)
@colored()
@click.option("-q", "--quiet", is_flag=True, help="Report, and say nothing else.")
def lint(**given: Any) -> int:
    """Check SDFormat, URDF, xacro and model.config files.

    PATHS are files, folders to walk (default: the current one), or - for stdin; NAME:=VALUE
    among them is an argument for the expansion of xacro files.
    """
    request = _request(given)
    options, paths = _options(request)
    settings = options.configuration.settings_in(Path.cwd())
    if request.show_settings:
        return _show_settings(request, paths, options)
    if request.show_files:
        return _show_files(request, paths, options)
    wanted = outputs(request.output_format or settings.output_format, request.output_file)
    notifier = Notifier(quiet=request.quiet)
    done = _run(request, paths, options, notifier)
    places = (*(output.file for output in wanted), request.baseline if request.write_baseline else None)
    refuse_to_write(places)
    if request.rewrites or request.diff:
        from sdfcheck.cli.rewrite import Rewriter, work

        rewriter = Rewriter(paths, options, notifier, work(request), request)
        if request.diff:
            changes = rewriter.show(done)
            return 2 if notifier.flush() else 0 if request.exit_zero else changes
        done = rewriter.write(done)
    if request.baseline is not None:
        from sdfcheck.cli import rewrite as baseline

        if request.write_baseline:
            notifier.flush()
            written = baseline.write(done, request.baseline, quiet=request.quiet)
            return 2 if notifier.failed else written
        done = baseline.without_known(done, request.baseline, notifier)
    notifier.flush()
    if request.fix_only:
        return 2 if notifier.failed else 0
    done = done._replace(gate=gate_of(request, settings.fail_on))
    _report(request, options, wanted, done, view_of(request, settings.fail_on))
    return 2 if notifier.failed else exit_code(request, done)


def _warn_of_missing_folders(options: Options, notifier: Notifier) -> None:
    settings = options.configuration.settings_in(Path.cwd())
    if settings.files and (settings.model_paths or settings.package_paths or settings.packages):
        from sdfcheck.lint.config.show import missing_folders

        for words in missing_folders(settings):
            notifier(Notice(Level.WARNING, words))


def _request(given: dict[str, Any]) -> Request:
    configuration = given["configuration"].with_given(taken(given))
    fix = given["fix"] or given["fix_only"]
    rewrites = fix or given["add_ignore"]
    return Request(**{**given, "configuration": configuration, "fix": fix, "rewrites": rewrites})


def _run(request: Request, paths: Sequence[Path], options: Options, notifier: Notifier) -> Run:
    progress = (
        Progress(sys.stderr, width_of(sys.stderr)) if sys.stderr.isatty() and not request.quiet else None
    )
    _warn_of_missing_folders(options, notifier)
    try:
        return run_in_parallel(paths, options, request.jobs, progress=progress, notify=notifier)
    finally:
        if progress:
            progress.clear()


def _report(request: Request, options: Options, wanted: Sequence[Output], done: Run, view: View) -> None:
    """Write the reports; where none is for people, sum up on stderr."""
    aside = request.rewrites and options.stdin is not None  # stdout gets the text
    robots = robots_of(done, wanted, options)
    for output in wanted:
        if output.file is not None or not request.statistics:
            write(output, done, color=request.color, aside=aside, view=view, robots=robots)
    if request.statistics:
        from sdfcheck.report import digest as statistics

        color, links = wants_color(request.color, sys.stdout), wants_links(request.color, sys.stdout)
        view = view._replace(width=width_of(sys.stdout), links=links)
        emit_lines(lines_of(statistics.render(done, color=color, view=view)), color=color)
    elif not request.quiet and not any(o.file is None and o.format.is_text for o in wanted):
        from sdfcheck.lint.diagnostic import Severity
        from sdfcheck.report.summary import closing_line

        say(closing_line(done, view._replace(least=Severity.INFO)))


def _options(request: Request) -> tuple[Options, tuple[Path, ...]]:
    """The settings of the session, and the paths without ``-``."""
    if request.show_fixes and not (request.fix or request.diff):
        raise WrongUsage("--show-fixes goes with --fix, --fix-only or --diff")
    if request.add_ignore and (request.fix or request.baseline):
        raise WrongUsage("--add-ignore goes with neither --fix nor --baseline")
    if request.reason and not request.add_ignore:
        raise WrongUsage("--reason goes with --add-ignore")
    if request.write_baseline and request.baseline is None:
        raise WrongUsage("--write-baseline needs --baseline FILE")
    arguments = arguments_in(str(path) for path in request.paths if ARGUMENT in str(path))
    paths = tuple(path for path in request.paths if ARGUMENT not in str(path)) or (Path(),)
    stdin = None
    if _STDIN in paths:
        stdin = read_stdin()
    elif request.stdin_filename is not None:
        raise WrongUsage("--stdin-filename needs - among the paths")
    options = Options(
        request.configuration,
        exclude=request.exclude,
        changed_since=request.changed_since,
        force_exclude=request.force_exclude,
        skip_unrelated=request.skip_unrelated,
        kind=Kind(request.kind) if request.kind else None,
        stdin=stdin,
        stdin_path=request.stdin_filename or Path("<stdin>"),
        expand=not request.no_expand,
        arguments=arguments,
    )
    paths = tuple(path for path in paths if path != _STDIN)
    if arguments:
        files = [file.path for file in find(paths, options).files]
        texts = {} if stdin is None else {options.stdin_path: stdin}
        check_arguments(arguments, files, options.settings_for(Path()), texts)
    return options, paths


def _show_files(request: Request, paths: Sequence[Path], options: Options) -> int:
    notifier = Notifier(quiet=request.quiet)
    found = find(paths, options)
    skipped = list(found.skipped)
    files = [file.path for file in selected(found, options, skipped, notify=notifier)]
    emit_lines(map(str, files))
    notifier.flush()
    if not request.quiet:
        for path, reason in sorted(skipped):
            say(f"skipped: {path}: {reason}")
    return 2 if notifier.failed else 0


def _show_settings(request: Request, paths: Sequence[Path], options: Options) -> int:
    from sdfcheck.lint.config import show as config_show

    first = paths[0] if paths else options.stdin_path
    if not (os.path.exists(first) or options.stdin is not None):
        raise WrongUsage(f"no such file or folder: {first}")
    configuration = options.configuration
    settings = (
        configuration.settings_in(first.resolve())
        if os.path.isdir(first)
        else configuration.settings_for(first)
    )
    asked = {"fail-on": request.fail_on, "output-format": request.output_format}
    emit(config_show.render(settings, {key: value for key, value in asked.items() if value}))
    return 0

"""``sdfcheck convert``: what its commands have in common.

A command's own module names its options and the function that converts a document;
reading, linting, reporting and writing are done here.
"""

from __future__ import annotations

import sys
from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from sdfcheck.cli.descriptions import ARGUMENT, Around, around, check_arguments, surroundings
from sdfcheck.cli.group import LazyCommand, LazyGroup
from sdfcheck.cli.options import F, colored, configured
from sdfcheck.cli.output import FORMATS, Output, outputs, refuse_inputs
from sdfcheck.cli.terminal import emit, say, wants_color
from sdfcheck.source.record import NamedTuple
from sdfcheck.source.sniff import Kind
from sdfcheck.source.wrong_usage import WrongUsage

if TYPE_CHECKING:
    from sdfcheck.cli.convert.inputs import Input
    from sdfcheck.convert.result import Conversion
    from sdfcheck.lint.diagnostic import Diagnostic
    from sdfcheck.source.document import Document
    from sdfcheck.source.text import Span

    Convert = Callable[[Document, bool], Conversion]
    """Converts a document; compares the result with it if the second argument is true."""

COMMANDS = {
    "urdf-to-sdf": LazyCommand("sdfcheck.cli.convert.urdf_to_sdf:urdf_to_sdf", "URDF or xacro to SDFormat."),
    "sdf-to-urdf": LazyCommand("sdfcheck.cli.convert.sdf_to_urdf:sdf_to_urdf", "SDFormat to URDF."),
    "sdf-to-sdf": LazyCommand("sdfcheck.cli.convert.sdf_to_sdf:sdf_to_sdf", "Between versions of SDFormat."),
}


@click.group(cls=LazyGroup, lazy=COMMANDS)
def convert() -> None:
    """Convert between formats, and prove that the robot stayed the same robot.

    Errors in the source are shown. One stops the conversion, and nothing is written, if the
    format's own reader refuses the file for it: urdfdom for URDF, libsdformat for SDFormat.
    """


class Request(NamedTuple):
    """What every command takes."""

    inputs: tuple[str, ...]
    output: Path | None
    output_dir: Path | None
    verify: bool
    verify_with: str | None
    strict: bool
    lint: bool
    output_format: tuple[str, ...]
    color: str
    quiet: bool
    around: Around

    @property
    def files(self) -> tuple[Path, ...]:
        return tuple(Path(text) for text in self.inputs if ARGUMENT not in text)


_PATH = click.Path(path_type=Path)
_OPTIONS = (
    click.argument("inputs", nargs=-1, required=True, metavar="IN… [ARG:=VALUE]…"),
    click.option("-o", "--output", type=_PATH, metavar="FILE", help="Where to write.  [default: stdout]"),
    click.option("--output-dir", type=_PATH, metavar="FOLDER", help="Write a file for each input there."),
    click.option(
        "--verify/--no-verify", default=True, help="Compare the result with its source.  [default: verify]"
    ),
    click.option(
        "--verify-with", type=click.Choice(["yourdfpy"]), help="Let this library read the URDF as well."
    ),
    click.option("--strict", is_flag=True, help="Exit with 1 if anything is lost."),
    click.option(
        "--lint/--no-lint",
        default=True,
        help="Stop at errors for which the format's own reader refuses the source.  [default: lint]",
    ),
    click.option(
        "--output-format",
        multiple=True,
        metavar="FORMAT[=FILE]",
        help=f"How to report losses: {', '.join(FORMATS)}.  [default: full]",
    ),
    surroundings,
    configured,
    colored(),
    click.option("-q", "--quiet", is_flag=True, help="Report losses, and say nothing else."),
)


def common_options(command: F) -> F:
    """Adds the options of all commands below the command's own."""
    for option in reversed(_OPTIONS):
        command = option(command)
    return command


def common(given: dict[str, Any]) -> Request:
    """Takes the common options out of what click has read; the rest is the command's own."""
    given["arguments"] = [text for text in given["inputs"] if ARGUMENT in text]
    given["around"] = around(given)
    return Request(**{name: given.pop(name) for name in Request._fields})


class _Outcome(NamedTuple):
    file: Path
    errors: Sequence[Diagnostic]
    """Those of the source."""
    losses: Sequence[Diagnostic] = ()
    conversion: Conversion | None = None
    failed: bool = False
    is_unsound: bool = False
    """Whether errors of the source stopped it."""
    broken: Span | None = None
    """Where the text of the source is no XML."""

    @property
    def has_losses(self) -> bool:
        """Whether anything is worse than worth knowing."""
        return any(one.severity.value != "info" for one in self.losses)


def convert_files(
    request: Request,
    kinds: Mapping[Kind, str],
    suffix: str,
    convert: Convert,
) -> int:
    """Convert each input, write what was verified, report; returns the exit code.

    ``kinds`` are those that can be converted, with what to call them; ``suffix`` ends the
    names of files in --output-dir.

    Raises:
        WrongUsage: the options contradict each other, or a file cannot be read or written.
    """
    from sdfcheck.cli.convert.inputs import Reader

    targets = _targets(request, suffix)
    wanted = outputs(request.output_format or ("full",), None)
    _refuse_to_overwrite(request.files, targets, wanted, stays=suffix == ".sdf" and Kind.SDF in kinds)
    outcomes = []
    unusable = 0
    with Reader(request.around, lint=request.lint) as reader:
        for file, target in zip(request.files, targets, strict=True):
            try:
                outcome = _convert(reader.read(file, kinds), convert, request)
                if outcome.conversion is not None and not outcome.failed:
                    _write(outcome.conversion, target)
            except WrongUsage as error:
                if len(targets) == 1:
                    raise
                # The other files are not to blame.
                say(f"error: {error}")
                unusable += 1
                continue
            outcomes.append(outcome)
    to_stdout = request.output is None and request.output_dir is None
    _report(outcomes, wanted, request, sys.stderr if to_stdout else sys.stdout)
    if unusable:
        return 2
    return int(any(one.failed or (request.strict and one.has_losses) for one in outcomes))


def _targets(request: Request, suffix: str) -> list[Path | None]:
    """Where each result goes; None is stdout."""
    files = request.files
    if not files:
        raise WrongUsage("no file is named")
    check_arguments(request.around.arguments, files, request.around.settings_for(files[0]))
    if request.output is not None and request.output_dir is not None:
        raise WrongUsage("--output and --output-dir exclude each other")
    if request.output_dir is None:
        if len(files) > 1:
            raise WrongUsage("several inputs need --output-dir")
        return [None if request.output in {None, Path("-")} else request.output]
    targets = [request.output_dir / f"{_stem(file)}{suffix}" for file in files]
    inputs = {file.resolve() for file in files}
    first: dict[Path, Path] = {}
    for file, target in zip(files, targets, strict=True):
        if target in first:
            raise WrongUsage(f"{first[target]} and {file} would both go to {target}")
        first[target] = file
        if target.resolve() in inputs:
            raise WrongUsage(f"{target} is an input; name it with -o to replace it")
    return list(targets)


def _refuse_to_overwrite(
    files: Sequence[Path], targets: Sequence[Path | None], wanted: Sequence[Output], *, stays: bool
) -> None:
    """Keep reports off inputs and results, and results off inputs unless the format ``stays`` the same."""
    reports = [output.file for output in wanted]
    refuse_inputs(reports, files)
    if not stays:
        refuse_inputs(targets, files)
    named = {report.resolve() for report in reports if report is not None}
    for target in targets:
        if target is not None and target.resolve() in named:
            raise WrongUsage(f"the result and a report would both go to {target}")


def _stem(file: Path) -> str:
    name = file.name.removesuffix(".xacro")
    return name.rpartition(".")[0] or name


def _convert(given: Input, convert: Convert, request: Request) -> _Outcome:
    from sdfcheck.convert.broken_text import guess_in
    from sdfcheck.convert.loss import NotConvertible, to_diagnostic

    if given.document is None or not given.is_sound:
        unsound = given.document is not None
        return _Outcome(given.file, given.errors, failed=True, is_unsound=unsound)
    try:
        done = convert(given.document, request.verify)
    except NotConvertible as error:
        return _Outcome(given.file, given.errors, [to_diagnostic(error.loss)], failed=True)
    losses = [to_diagnostic(loss) for loss in done.losses]
    found = list(done.verification.differences) if done.verification is not None else []
    if request.verify_with is not None:
        from sdfcheck.convert.independent import differences

        found += differences(done, given.document)
    if found and given.document.root is not None:
        from sdfcheck.convert.loss import Loss, LossKind
        from sdfcheck.lint.diagnostic import Severity

        span = given.document.root.span
        for one in found:
            text = f"the result is not the same robot: {one.what} of `{one.name}` {one.text}"
            losses.append(to_diagnostic(Loss(LossKind.NOT_VERIFIED, span, text, Severity.ERROR)))
    broken = guess_in(given.document) if request.verify else None
    return _Outcome(given.file, given.errors, losses, done, bool(found), broken=broken)


def _write(done: Conversion, target: Path | None) -> None:
    from sdfcheck.convert.writer import write_atomically

    if target is None:
        emit(done.text)
        return
    try:
        target.parent.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise WrongUsage(f"cannot make the folder {target.parent}: {error.strerror}") from None
    for path, text in done.files:
        write_atomically(target.parent / path, text)
    write_atomically(target, done.text)


def _report(outcomes: Sequence[_Outcome], wanted: Sequence[Output], request: Request, stream: Any) -> None:
    from sdfcheck.cli.output import show, write
    from sdfcheck.lint.run import Run
    from sdfcheck.report import render

    diagnostics = [one for outcome in outcomes for one in (*outcome.errors, *outcome.losses)]
    diagnostics.sort(key=lambda one: one.sort_key)
    done = Run(tuple(diagnostics), tuple(outcome.file for outcome in outcomes))
    for output in wanted:
        if output.format.is_text and not diagnostics:
            continue
        if output.file is None and stream is sys.stderr:
            color = wants_color(request.color, stream)
            show(output.format, render(output.format, done, color=color), color=color, aside=True)
        else:
            write(output, done, color=wants_color(request.color, sys.stdout))
    if request.quiet:
        return
    for outcome in outcomes:
        _sum_up(outcome, named=len(outcomes) > 1)


def _sum_up(outcome: _Outcome, *, named: bool) -> None:
    prefix = f"{outcome.file}: " if named else ""
    verification = outcome.conversion.verification if outcome.conversion is not None else None
    if outcome.failed:
        advice = "; --no-lint converts it anyway" if outcome.is_unsound else ""
        say(f"{prefix}not converted, nothing written{advice}")
    elif verification is not None:
        say(f"{prefix}verified: {verification}")
    elif outcome.broken is not None:
        line, column = outcome.broken.begin
        say(f"{prefix}not verified: the text is broken at {line}:{column}; `sdfcheck lint` says how")
    else:
        say(f"{prefix}not verified")

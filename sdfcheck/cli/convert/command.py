"""``sdfcheck convert``: what its commands have in common.

A command's own module names its options and the function that converts a document;
reading, linting, reporting and writing are done here.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING

import click

from sdfcheck.cli.convert.before_and_after import write_page
from sdfcheck.cli.convert.options import Request
from sdfcheck.cli.convert.outcome import converted
from sdfcheck.cli.convert.places import Source, refuse_to_overwrite, sources, targets
from sdfcheck.cli.parts.descriptions import check_arguments
from sdfcheck.cli.parts.group import LazyCommand, LazyGroup
from sdfcheck.cli.parts.output import outputs
from sdfcheck.cli.parts.terminal import emit
from sdfcheck.source.sniff import Kind
from sdfcheck.source.wrong_usage import WrongUsage

if TYPE_CHECKING:
    from sdfcheck.cli.convert.inputs import Input, Reader
    from sdfcheck.cli.convert.outcome import Convert, Outcome
    from sdfcheck.cli.convert.reporting import Reporting
    from sdfcheck.convert.result import Conversion
    from sdfcheck.source.document import Document

COMMANDS = {
    "urdf-to-sdf": LazyCommand("sdfcheck.cli.convert.urdf_to_sdf:urdf_to_sdf", "URDF or xacro to SDFormat."),
    "sdf-to-urdf": LazyCommand("sdfcheck.cli.convert.sdf_to_urdf:sdf_to_urdf", "SDFormat to URDF."),
    "sdf-to-sdf": LazyCommand("sdfcheck.cli.convert.sdf_to_sdf:sdf_to_sdf", "Between versions of SDFormat."),
}
_OTHER_WORK = frozenset({Kind.SDF, Kind.URDF, Kind.XACRO, Kind.SRDF, Kind.MJCF, Kind.MODEL_CONFIG})
"""Files that are often beside those to convert."""


_MEANT = {
    **dict.fromkeys(
        ("sdf", "to-sdf", "urdf2sdf", "xacro-to-sdf", "xacro"), "sdfcheck convert urdf-to-sdf FILE"
    ),
    **dict.fromkeys(("urdf", "to-urdf", "sdf2urdf"), "sdfcheck convert sdf-to-urdf FILE"),
    **dict.fromkeys(("upgrade", "migrate", "update", "downgrade"), "sdfcheck convert sdf-to-sdf FILE"),
    "xacro-to-urdf": "sdfcheck expand FILE",
}
"""Usual names of a conversion → the name here."""
_ENDINGS = {
    ".urdf": "sdfcheck convert urdf-to-sdf",
    ".xacro": "sdfcheck convert urdf-to-sdf",
    ".sdf": "sdfcheck convert sdf-to-urdf",
    ".world": "sdfcheck convert sdf-to-sdf",
}
"""The end of a file's name → the conversion that was meant where the file is named in its place."""


@click.group(cls=LazyGroup, lazy=COMMANDS, meant=_MEANT, endings=_ENDINGS)
def convert() -> None:
    """Convert between formats, and prove that the robot stayed the same robot.

    Errors in the source are shown. One stops the conversion, and nothing is written, if the
    format's own parser refuses the file for it: urdfdom for URDF, libsdformat for SDFormat.
    IN may be a folder, or - for stdin.
    """


def convert_files(request: Request, kinds: Mapping[Kind, str], suffix: str, convert: Convert) -> int:
    """Convert each input, write what was verified, report; returns the exit code.

    ``kinds`` are those that can be converted, with what to call them; ``suffix`` ends the
    names of files in --output-dir.

    Raises:
        WrongUsage: the options contradict each other, or a file cannot be read or written.
    """
    from sdfcheck.cli.convert.inputs import Reader
    from sdfcheck.cli.convert.reporting import Reporting

    files = sources(request)
    wanted = outputs(request.output_format, None)
    places = targets(request, files, suffix)
    paths = [file.path for file in files if file.data is None]
    others = [*(output.file for output in wanted), request.report]
    refuse_to_overwrite(paths, places, others, stays=suffix == ".sdf" and Kind.SDF in kinds)
    _check_arguments(request, files)
    done = Reporting(request, wanted)
    with Reader(request.around, lint=request.lint, expand=not request.no_expand) as reader:
        for file, target in zip(files, places, strict=True):
            try:
                given = reader.read(file, kinds)
                outcome = _judged(given, converted(given, convert, request), reader)
                if request.report is not None:
                    write_page(request.report, given, outcome)
                if outcome.conversion is not None and not outcome.failed:
                    _write(outcome.conversion, file, target)
            except WrongUsage as error:
                _give_up(file, files, error, done)
                continue
            done.add(outcome, target)
            if len(files) > 1:
                _release(given.document, outcome.conversion)
    return done.finish()


def _judged(given: Input, outcome: Outcome, reader: Reader) -> Outcome:
    """An outcome whose result was linted, if there is one."""
    if outcome.conversion is None or outcome.failed:
        return outcome
    return outcome.judged(reader.judge(given, outcome.conversion.document))


def _release(source: Document | None, done: Conversion | None) -> None:
    """Release trees and robots: they refer to themselves, and those of many files would fill the memory."""
    if source is not None:
        source.release()
    if done is not None:
        done.document.release()


def _give_up(file: Source, files: Sequence[Source], error: WrongUsage, done: Reporting) -> None:
    """Ignore a file of another kind that was found, or is one of several."""
    from sdfcheck.cli.convert.inputs import OtherKind

    if isinstance(error, OtherKind) and (not file.named or (len(files) > 1 and error.kind in _OTHER_WORK)):
        done.ignore(file.path, error.kind.description)
    elif len(files) == 1:
        raise error
    else:
        done.fail(file.path, str(error))


def _check_arguments(request: Request, files: Sequence[Source]) -> None:
    texts = {file.path: file.data for file in files if file.data is not None}
    if request.report is not None and len(files) > 1:
        raise WrongUsage("--report shows one conversion, and there are several inputs")
    settings = request.around.settings_for(files[0].path)
    check_arguments(request.around.arguments, [file.path for file in files], settings, texts)


def _write(done: Conversion, source: Source, target: Path | None) -> None:
    from sdfcheck.convert.result_paths import seen_from
    from sdfcheck.convert.writer import write_atomically
    from sdfcheck.files.regular import identity

    if target is None:
        emit(done.text)
        return
    try:
        target.parent.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise WrongUsage(f"cannot make the folder {target.parent}: {error.strerror}") from None
    for path, text in done.files:
        write_atomically(target.parent / path, text)
    # Between versions of SDFormat a file may be replaced by its result.
    is_source = source.data is None and identity(target) == identity(source.path)
    write_atomically(target, seen_from(done, source.path.parent, target.parent), instead=is_source)

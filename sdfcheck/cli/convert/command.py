"""The conversion of files on the command line: each is converted, verified and written, or says why not."""

from __future__ import annotations

import os
import sys
from collections import Counter
from collections.abc import Callable, Iterator, Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING

import click

from sdfcheck.cli.convert.files import OtherKind, Reader, Source, refuse_to_overwrite, sources, targets
from sdfcheck.cli.convert.options import Request
from sdfcheck.cli.parts.command import LazyCommand, LazyGroup
from sdfcheck.cli.parts.descriptions import check_arguments
from sdfcheck.cli.parts.output import Output, deliver, outputs, show, write
from sdfcheck.cli.parts.terminal import emit, emit_lines, say, say_lines, wants_color, width_of
from sdfcheck.consumers.reaction import Consumer
from sdfcheck.lint.diagnostic import Diagnostic, Severity, counted, listed
from sdfcheck.lint.run import Run
from sdfcheck.report import OutputFormat, render
from sdfcheck.report.summary import View
from sdfcheck.source.errors import WrongUsage
from sdfcheck.source.record import NamedTuple
from sdfcheck.source.sniff import Kind

if TYPE_CHECKING:
    from sdfcheck.cli.convert.files import Input, Judgement
    from sdfcheck.convert.comparison import Verification
    from sdfcheck.convert.result import Conversion
    from sdfcheck.source.document import Document
    from sdfcheck.source.text import Span

    Convert = Callable[[Document, bool], Conversion]
    """Converts a document; compares the result with it if the second argument is true."""


PARSERS = {Consumer.GAZEBO: "libsdformat", Consumer.URDFDOM: "urdfdom"}
"""The parsers of the consumers that a result is for."""


class Outcome(NamedTuple):
    """The result; ``failed``: nothing is written."""

    file: Path
    errors: Sequence[Diagnostic]
    """Those of the source."""
    losses: Sequence[Diagnostic] = ()
    conversion: Conversion | None = None
    """The result, until it is written."""
    verification: Verification | None = None
    failed: bool = False
    way_out: str = ""
    """The option that converts it anyway, and how."""
    stopping: Sequence[Diagnostic] = ()
    """For what it is not written."""
    broken: Span | None = None
    """Where the text of the source is not XML."""
    also_by: str = ""
    """The consumers that have read source and result as well."""
    encoding: str = ""
    """That of the source, where the result has another."""
    refusal: tuple[Consumer, Diagnostic] | None = None
    """A consumer that refuses the result, like the source, and why."""

    def judged(self, judgement: Judgement) -> Outcome:
        """With what the consumers of the result say of it."""
        errors = judgement.errors
        if not errors:
            return self._replace(refusal=judgement.refusal)
        new = [one for one in errors if one not in self.errors]
        return self._replace(losses=[*self.losses, *new], failed=True, stopping=errors)

    @property
    def has_losses(self) -> bool:
        """Whether anything is worse than worth knowing."""
        return self.refusal is not None or any(one.severity.value != "info" for one in self.losses)

    @property
    def diagnostics(self) -> tuple[Diagnostic, ...]:
        return (*self.errors, *self.losses)

    @property
    def verdict(self) -> str:
        """Whether the result is the same robot, and how that is known."""
        if self.failed:
            return "; ".join(filter(None, ("not converted, nothing written", self.way_out)))
        if self.verification is not None:
            text = f"verified: {self.verification}"
            text += f", also by {self.also_by}" if self.also_by else ""
            return text + self._refused
        if self.broken is not None:
            line, column = self.broken.begin
            return f"not verified: the text is broken at {line}:{column}; `sdfcheck lint` says how"
        return "not verified"

    @property
    def _refused(self) -> str:
        if self.refusal is None:
            return ""
        consumer, why = self.refusal
        return f"; {PARSERS[consumer]} refuses it: {why.message} ({why.code})"

    @property
    def reason(self) -> str:
        """Why nothing is written."""
        first = next(iter((*self.stopping, *self.diagnostics)), None)
        if first is None:
            return "it cannot be expanded"
        line, column = first.span.begin
        return f"{first.message} ({line}:{column}, {first.code})"


def converted(given: Input, convert: Convert, request: Request) -> Outcome:
    """Convert a document, and compare it with its source if that is asked for."""
    from sdfcheck.convert.loss import NotConvertible, to_diagnostic
    from sdfcheck.convert.soundness import guess_in

    if given.document is None or given.stopping:
        way_out = "--no-lint converts it anyway" if given.document is not None else ""
        if given.document is None and given.file.suffix == ".urdf":
            way_out = "--no-expand leaves out what is for xacro"
        return Outcome(given.file, given.errors, failed=True, way_out=way_out, stopping=given.stopping)
    try:
        done = convert(given.document, request.verify)
    except NotConvertible as error:
        refused = [to_diagnostic(error.loss)]
        return Outcome(given.file, given.errors, refused, failed=True, stopping=refused)
    losses = [to_diagnostic(loss) for loss in done.losses]
    different = _differences(done, given.document, request)
    return Outcome(
        given.file,
        given.errors,
        [*losses, *different],
        done,
        done.verification,
        bool(different),
        stopping=different,
        broken=guess_in(given.document) if request.verify else None,
        also_by=listed(request.verify_with),
        encoding=given.encoding,
    )


def _differences(done: Conversion, document: Document, request: Request) -> list[Diagnostic]:
    """The findings of the comparison, as diagnostics of the source."""
    found = list(done.verification.differences) if done.verification is not None else []
    if request.verify_with:
        from sdfcheck.convert.independent import Judge, differences

        found += differences(done, document, map(Judge, request.verify_with))
    if not found or document.root is None:
        return []
    from sdfcheck.convert.loss import Loss, LossKind, to_diagnostic

    texts = (f"the result is not the same robot: {one.what} of `{one.name}` {one.text}" for one in found)
    span = document.root.span
    return [to_diagnostic(Loss(LossKind.NOT_VERIFIED, span, text, Severity.ERROR)) for text in texts]


# ``sdfcheck convert``: what its commands have in common: results and the report.

# ``--report``: the page that shows a robot before and after its conversion, with losses at their parts.


def write_page(page: Path, given: Input, outcome: Outcome) -> None:
    """Write the page to a file: both robots, or the source alone where there is no result.

    Raises:
        WrongUsage: the file is the input, or cannot be written.
    """
    if given.document is None:
        say(f"note: {page} is not written: {given.file} cannot be expanded")
        return
    deliver(_page(given.document, outcome), page)


def _page(source: Document, outcome: Outcome) -> str:
    from sdfcheck.view.meshes import Meshes
    from sdfcheck.view.notes import differences, findings
    from sdfcheck.view.page import page
    from sdfcheck.view.scene import scene

    documents = [source]
    if outcome.conversion is not None:
        documents.append(outcome.conversion.document)
    meshes = Meshes()
    scenes = [scene(document, meshes) for document in documents]
    for shown, name in zip(scenes, ("before", "after"), strict=False):
        shown["file"] = f"{shown['file']} ({name})"
    return page(
        f"{source.path.name}: {outcome.verdict}",
        scenes,
        meshes.entries,
        findings=findings(outcome.diagnostics, source),
        heading="Losses and errors",
        differences=differences(*documents) if len(documents) > 1 else (),
    )


# The report of conversions: losses, then a line for each file.


class _Row(NamedTuple):
    """A file in the table at the end: how it went, and what there is to say of it."""

    how: str
    text: str


class Reporting:
    """Collects what came of the files of a run, and reports it."""

    def __init__(self, request: Request, wanted: Sequence[Output]) -> None:
        self._request = request
        self._wanted = wanted
        self._done: list[Outcome] = []
        self._rows: list[_Row] = []
        self._unusable = 0

    def add(self, outcome: Outcome, target: Path | None) -> None:
        """A file was converted, or refused."""
        self._done.append(outcome._replace(conversion=None))
        if outcome.failed:
            self._rows.append(_Row("not written", f"{outcome.file}: {outcome.reason}"))
            return
        losses = sum(one.severity is not Severity.INFO for one in outcome.losses)
        how = "verified" if outcome.verification is not None else "not verified"
        how += f", {losses} {'loss' if losses == 1 else 'losses'}" if losses else ""
        where = f" → {target}" if target is not None else ""
        why = f" ({outcome.verdict.removeprefix('not verified: ')})" if outcome.broken is not None else ""
        self._rows.append(_Row(how, f"{outcome.file}{where}{why}"))

    def ignore(self, file: Path, description: str) -> None:
        """A file is of another kind, which is not a mistake."""
        self._rows.append(_Row("ignored", f"{file}: looks like {description}"))

    def fail(self, file: Path, text: str) -> None:
        """A file cannot be used."""
        say(f"error: {text}")
        self._rows.append(_Row("unusable", str(file)))
        self._unusable += 1

    def finish(self) -> int:
        """Report everything; returns the exit code."""
        self._losses()
        if not self._request.quiet:
            self._sum_up()
        if self._unusable:
            return 2
        strict = self._request.strict
        return int(any(one.failed or (strict and one.has_losses) for one in self._done))

    @property
    def _aside(self) -> bool:
        """Whether reports go to stderr, since a result goes to stdout."""
        request = self._request
        return request.output_dir is None and request.output_file is None

    def _losses(self) -> None:
        request, aside = self._request, self._aside
        diagnostics = sorted(
            (one for outcome in self._done for one in outcome.diagnostics), key=lambda one: one.sort_key
        )
        run = Run(tuple(diagnostics), tuple(outcome.file for outcome in self._done))
        stream = sys.stderr if aside else sys.stdout
        color = wants_color(request.color, stream)
        view = View(Severity(request.min_severity), width=width_of(stream))
        for output in self._wanted:
            if diagnostics or not output.format.is_text:
                write(output, run, color=request.color, aside=aside, view=view)
        if self._wanted or not view.shown(run):
            return
        refused = len(self._done) == 1 and self._done[0].failed
        if request.losses == "all" or refused:
            view = view._replace(folds=request.losses != "all")
            show(
                OutputFormat.FULL,
                render(OutputFormat.FULL, run, color=color, view=view),
                color=color,
                aside=aside,
            )
            return
        lines = list(self._grouped(view.shown(run), color=color))
        if view.width is not None:
            from sdfcheck.report.table import folded

            lines = [part for line in lines for part in folded(line, view.width)]
        (say_lines if aside else emit_lines)(lines, color=color)

    def _grouped(self, diagnostics: Sequence[Diagnostic], *, color: bool) -> Iterator[str]:
        from sdfcheck.report.colors import painter
        from sdfcheck.report.losses import by_file_and_code
        from sdfcheck.report.paths import Paths

        return by_file_and_code(diagnostics, Paths(), painter(color))

    def _sum_up(self) -> None:
        if len(self._rows) == 1 and self._done:
            (outcome,) = self._done
            say(outcome.verdict)
        else:
            width = max((len(row.how) for row in self._rows), default=0)
            for row in self._rows:
                say(f"{row.how:{width}}  {row.text}")
            say(self._closing())
        for outcome in self._done:
            if outcome.encoding and not outcome.failed:
                say(f"note: {outcome.file}: {outcome.encoding} becomes UTF-8")
        hidden = self._hidden()
        if hidden:
            say(f"{counted(hidden, 'info')}: shown with --min-severity info")

    def _closing(self) -> str:
        counts = []
        for how in ("verified", "not verified", "not written", "unusable", "ignored"):
            rows = [row for row in self._rows if row.how.partition(",")[0] == how]
            losing = sum("," in row.how for row in rows)
            if rows:
                counts.append(f"{len(rows)} {how}" + (f" ({losing} with losses)" if losing else ""))
        judges = self._request.verify_with
        also = f"; also compared by {listed(judges)}" if judges else ""
        return f"{counted(len(self._rows), 'file')}: {listed(counts)}{also}"

    def _hidden(self) -> int:
        """How many findings are not shown; reports in a format that was asked for say so themselves."""
        if self._wanted:
            return 0
        least = Severity(self._request.min_severity)
        return sum(not one.severity >= least for outcome in self._done for one in outcome.diagnostics)


# ``sdfcheck convert``: what its commands have in common.
#
# A command's own module names its options and the function that converts a document;
# reading, linting, reporting and writing are done here.


COMMANDS = {
    "urdf-to-sdf": LazyCommand("sdfcheck.cli.convert.directions:urdf_to_sdf", "URDF or xacro to SDFormat."),
    "sdf-to-urdf": LazyCommand("sdfcheck.cli.convert.directions:sdf_to_urdf", "SDFormat to URDF."),
    "sdf-to-sdf": LazyCommand("sdfcheck.cli.convert.directions:sdf_to_sdf", "Between versions of SDFormat."),
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
    files = sources(request)
    wanted = outputs(request.output_format, None)
    places = targets(request, files, suffix)
    paths = [file.path for file in files if file.data is None]
    others = [*(output.file for output in wanted), request.report]
    refuse_to_overwrite(paths, places, others, stays=suffix == ".sdf" and Kind.SDF in kinds)
    _check_arguments(request, files)
    done = Reporting(request, wanted)
    folders = Counter(target.parent for target in places if target is not None)
    with Reader(request.around, lint=request.lint, expand=not request.no_expand) as reader:
        for file, target in zip(files, places, strict=True):
            try:
                given = reader.read(file, kinds)
                outcome = _judged(given, converted(given, convert, request), reader)
                if request.report is not None:
                    write_page(request.report, given, outcome)
                if outcome.conversion is not None and not outcome.failed:
                    is_alone = target is not None and folders[target.parent] == 1
                    _write(outcome.conversion, file, target, request, is_alone=is_alone)
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


def _write(
    done: Conversion, source: Source, target: Path | None, request: Request, *, is_alone: bool
) -> None:
    """Write a result; ``is_alone``: no other result goes to its folder."""
    from sdfcheck.convert.writer import write_atomically
    from sdfcheck.files.regular import identity

    folder = Path() if target is None else target.parent
    text = _text(done, source, folder, request)
    if target is None:
        emit(text)
        return
    _make(folder)
    for path, extra in done.files:
        write_atomically(folder / path, extra)
    # Between versions of SDFormat a file may be replaced by its result.
    is_source = source.data is None and identity(target) == identity(source.path)
    write_atomically(target, text, instead=is_source)
    if request.copy_meshes and is_alone:
        _write_config(done, target)


def _text(done: Conversion, source: Source, folder: Path, request: Request) -> str:
    """The text of a result for the folder that it goes to; what it names is copied there if that is asked for."""
    from sdfcheck.convert.addresses import UriStyle, addressed, copy
    from sdfcheck.convert.result import seen_from

    if request.uri_style == "keep" and not request.copy_meshes:
        goes_out = request.output_dir is None and request.output_file is None
        return done.text if goes_out else seen_from(done, source.path.parent, folder)
    style = UriStyle(request.uri_style)
    placed = addressed(done, source.path.parent, folder, style, copies=request.copy_meshes)
    if placed.copies:
        _make(folder)
        count = copy(done, placed.copies)
        if not request.quiet:
            there = len(placed.copies) - count
            rest = f", {there} there already" if there else ""
            say(f"{counted(count, 'file')} copied to {folder}{rest}")
    if placed.left and not request.quiet:
        say(f"note: addresses that stay as they are: {len(placed.left)}, such as {placed.left[0]}")
    return placed.text


def _make(folder: Path) -> None:
    try:
        folder.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise WrongUsage(f"cannot make the folder {folder}: {error.strerror}") from None


def _write_config(done: Conversion, target: Path) -> None:
    """Write a ``model.config`` beside a model of SDFormat, unless there is one."""
    from sdfcheck.convert.addresses import config_of
    from sdfcheck.convert.writer import write_atomically
    from sdfcheck.files.discover import MODEL_CONFIG
    from sdfcheck.robot.root import root_of

    config, root = target.parent / MODEL_CONFIG, root_of(done.document)
    if not root.is_urdf and root.models and not os.path.exists(config):
        write_atomically(config, config_of(root.models[0].name, target.name, root.version or ""))

"""The conversion of files on the command line: each is converted, verified and written, or says why not."""

from __future__ import annotations

import os
import sys
from collections import Counter
from collections.abc import Callable, Collection, Iterator, Mapping, Sequence
from pathlib import Path
from types import TracebackType
from typing import TYPE_CHECKING

import click

from sdfcheck.cli.convert.options import Request
from sdfcheck.cli.parts.command import LazyCommand, LazyGroup
from sdfcheck.cli.parts.descriptions import SearchContext, check_arguments, chosen_arguments, expander_for
from sdfcheck.cli.parts.output import Output, deliver, outputs, refuse_to_write, show, write
from sdfcheck.cli.parts.terminal import emit, emit_lines, read_stdin, say, say_lines, wants_color, width_of
from sdfcheck.consumers.reaction import Consumer
from sdfcheck.convert.new_errors import has_refusals, means_another_robot, new_errors, new_refusals
from sdfcheck.files.discover import discover
from sdfcheck.files.library import Library, SearchPaths
from sdfcheck.files.regular import identity, read_named
from sdfcheck.lint.config.settings import UNSET, Settings
from sdfcheck.lint.diagnostic import Diagnostic, Severity, counted, listed
from sdfcheck.lint.engine import Dispatch, lint_document
from sdfcheck.lint.rulebook.rulebook import RuleBook
from sdfcheck.lint.run import Run
from sdfcheck.lint.targets import ELSEWHERE, OWN_CONSUMER, obstacles, own_consumer
from sdfcheck.report import OutputFormat, render
from sdfcheck.report.summary import View
from sdfcheck.source.errors import WrongUsage
from sdfcheck.source.record import NamedTuple
from sdfcheck.source.sniff import Kind, sniff
from sdfcheck.source.text import relative_path

if TYPE_CHECKING:
    from sdfcheck.convert.comparison import Verification
    from sdfcheck.convert.result import Conversion
    from sdfcheck.source.document import Document
    from sdfcheck.source.text import Span
    from sdfcheck.xacro.expansion import Expander

    Convert = Callable[[Document, bool], Conversion]
    """Converts a document; compares the result with it if the second argument is true."""


# Where results go.

_STDIN = Path("-")


class Source(NamedTuple):
    """Something to convert; ``data`` is what stdin has given. ``named``: a person wrote its path."""

    path: Path
    named: bool = True
    data: bytes | None = None


def sources(request: Request) -> list[Source]:
    """The files that are named, those in the folders that are named, and stdin for ``-``.

    Raises: WrongUsage: no file is found.
    """
    paths = request.paths
    if not paths:
        raise WrongUsage("no file is named")
    if request.stdin_filename is not None and _STDIN not in paths:
        raise WrongUsage("--stdin-filename needs - among the inputs")
    folders = [path for path in paths if os.path.isdir(path)]
    configuration = request.around.configuration
    found = discover(folders, exclude=lambda path: configuration.settings_for(path).excludes(path))
    if folders and not found.files and len(folders) == len(paths):
        raise WrongUsage(f"no SDFormat, URDF or xacro file in {folders[0]}")
    wanted = []
    for path in paths:
        if path == _STDIN:
            name = request.stdin_filename or Path("<stdin>")
            wanted.append(Source(name, data=read_stdin()))
        elif path not in folders:
            wanted.append(Source(path))
    inside = (Source(each.path, named=False) for each in found.files if each.path.name != "model.config")
    return [*wanted, *inside]


def targets(request: Request, files: Sequence[Source], suffix: str) -> list[Path | None]:
    """Where each result goes; None is stdout.

    Results of the same name go to folders as those of their sources, unless --flat forbids it.

    Raises:
        WrongUsage: the options contradict each other, or two results would go to one place.
    """
    folder = _folder(request)
    if folder is None:
        if len(files) > 1:
            raise WrongUsage("several inputs need --output-dir; the result of one goes to -o FILE")
        return [request.output_file]
    paths = [file.path if file.data is None else Path(_stem(file.path.name).strip("<>")) for file in files]
    names = [Path(f"{_stem(path.name)}{suffix}") for path in paths]
    if len(set(names)) < len(names):
        if request.flat:
            raise WrongUsage(_clash(paths, names, folder))
        names = _mirrored(paths, names)
    if len(set(names)) < len(names):
        taken = {name for name in names if names.count(name) > 1}
        names = [
            name.with_name(f"{path.name}{suffix}") if name in taken else name
            for path, name in zip(paths, names, strict=True)
        ]
        if len(set(names)) < len(names):
            raise WrongUsage(_clash(paths, names, folder))
    return [folder / name for name in names]


def _folder(request: Request) -> Path | None:
    """The folder for the results, each under a name of its own; None where one place is named, or none."""
    if request.output_file is not None and request.output_dir is not None:
        raise WrongUsage("--output-file and --output-dir exclude each other")
    if request.copy_meshes and request.output_file is None and request.output_dir is None:
        raise WrongUsage("--copy-meshes needs a place: -o FILE or --output-dir FOLDER")
    folder = request.output_dir
    if request.output_file is not None and os.path.isdir(request.output_file):
        folder = request.output_file
    if request.flat and folder is None:
        raise WrongUsage("--flat goes with --output-dir")
    return folder


def _stem(name: str) -> str:
    name = name.removesuffix(".xacro")
    return name.rpartition(".")[0] or name


def _mirrored(paths: Sequence[Path], names: Sequence[Path]) -> list[Path]:
    """The names below folders that are those of the paths, as seen from the folder that holds all of them."""
    folders = [os.path.abspath(path.parent) for path in paths]
    try:
        top = os.path.commonpath(folders)
    except ValueError:  # several drives
        return list(names)
    return [Path(relative_path(folder, top), name) for folder, name in zip(folders, names, strict=True)]


def _clash(paths: Sequence[Path], names: Sequence[Path], folder: Path) -> str:
    first: dict[Path, Path] = {}
    for path, name in zip(paths, names, strict=True):
        if name in first:
            return f"{first[name]} and {path} would both go to {folder / name}"
        first[name] = path
    raise AssertionError("two of the names are equal")


def refuse_to_overwrite(
    files: Collection[Path], targets: Sequence[Path | None], others: Sequence[Path | None], *, stays: bool
) -> None:
    """Keep reports off inputs and results, and results off inputs unless the one file's format ``stays`` the same.

    Raises:
        WrongUsage: one would be written over another, or where nothing is written.
    """
    inputs = {identity(file) for file in files}
    replaced = [each for each in targets if stays and each is not None and identity(each) in inputs - {None}]
    if replaced and len(files) > 1:
        raise WrongUsage(f"{replaced[0]} is an input; name it with -o to replace it")
    refuse_to_write([each for each in (*targets, *others) if each not in replaced], files)


# The source of a conversion: the document, expanded if it is xacro, and the errors in it.


class Input(NamedTuple):
    """A file as it was read, its errors, and the warnings for which the result means another robot to its consumers.

    ``stopping`` are the errors that stop the conversion.
    """

    file: Path
    document: Document | None
    errors: Sequence[Diagnostic] = ()
    stopping: Sequence[Diagnostic] = ()
    encoding: str = ""
    """The encoding of its bytes, if that is not plain UTF-8."""
    found: Sequence[Diagnostic] | None = None
    """All that the configured rules find in it; None if nobody has looked."""


class Judgement(NamedTuple):
    """The verdict on a result: the errors for which it is not written, or why a consumer refuses it like the source."""

    errors: Sequence[Diagnostic] = ()
    refusal: tuple[Consumer, Diagnostic] | None = None


class OtherKind(WrongUsage):
    """A file is of a kind that is not converted."""

    def __init__(self, text: str, kind: Kind) -> None:
        super().__init__(text)
        self.kind = kind


class Reader:
    """Reads the inputs of one run. Use it as a context manager: it may start a process to expand xacro."""

    def __init__(self, around: SearchContext, *, lint: bool = True, expand: bool = True) -> None:
        self._book = RuleBook()
        self._around = around
        self._lint = lint
        self._expands = expand
        self._libraries: dict[SearchPaths, Library] = {}
        self._expander: Expander | None = None

    def __enter__(self) -> Reader:
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        if self._expander is not None:
            self._expander.close()

    def read(self, source: Source, kinds: Mapping[Kind, str]) -> Input:
        """Read a file that must be of one of ``kinds``, or what stdin has given.

        Raises:
            OtherKind: it is of another kind.
            WrongUsage: it does not exist, cannot be read or brings too many models.
        """
        file = source.path
        settings = self._around.settings_for(file)
        search = settings.search
        # Shared, so that what lies around the files is looked up once.
        library = self._libraries.setdefault(search, Library(search, settings.size_limit))
        try:
            data = read_named(file, settings.size_limit) if source.data is None else source.data
        except OSError as error:
            raise WrongUsage(f"{file} cannot be read: {error.strerror}") from None
        kind = sniff(data, file)
        is_by_root = kind is Kind.BROKEN_XML or (kind is Kind.XACRO and not self._expands)
        from sdfcheck.robot.includes.included import refuse_too_many
        from sdfcheck.source.document import read

        document = read(data, file, None if is_by_root else kind)
        document.library = library
        if document.kind is Kind.XACRO and Kind.URDF in kinds and self._expands:
            expanded, problems = self._expand(document, settings)
            if expanded is None:
                document.problems = [*document.problems, *problems]  # type: ignore[list-item]
                return _unexpanded(self._judged(document, settings))
            document = expanded
        if document.kind not in kinds or document.root is None:
            names = " or ".join(kinds.values())
            text = f"{file} looks like {document.kind.description}, not like {names}"
            raise OtherKind(text, document.kind)
        if not source.named and document.kind is Kind.URDF and not document.root.has("link"):
            raise OtherKind(f"{file} has no link", Kind.XACRO)
        refuse_too_many(document)
        given = self._judged(document, settings) if self._lint else Input(file, document)
        return given._replace(encoding=spelled(data))

    def _expand(self, document: Document, settings: Settings) -> tuple[Document | None, Sequence[object]]:
        if self._expander is None:
            self._expander = expander_for(settings)
        done = self._expander.expand(document, chosen_arguments(document.path, settings, self._around))
        if done.document is not None:
            done.document.library = document.library
        return done.document, done.problems

    def _judged(self, document: Document, settings: Settings) -> Input:
        """A document with the errors that the configured rules find in it.

        Not those about bodies that only warn: a conversion keeps shapes and masses as they are.
        """
        file = document.path
        found = lint_document(document, self._book.dispatch(settings, file).of_errors)
        shown = [one for one in found if one.severity is Severity.ERROR or means_another_robot(one)]
        stopping = obstacles(found, own_consumer(document), ELSEWHERE)
        return Input(file, document, shown, stopping, found=found)

    def judge(self, given: Input, result: Document) -> Judgement:
        """The verdict on a result; a good one if nobody has looked at the source."""
        source = given.document
        if given.found is None or source is None:
            return Judgement()
        settings = self._around.settings_for(given.file)
        dispatch = self._book.dispatch(settings, given.file, tuple(ELSEWHERE)).of_errors
        after = lint_document(result, dispatch)
        found = new_errors(source, given.found, result, after)
        if found and (brought := _included(source)):
            # An included file may have the same faults in the source.
            before = [*given.found, *(one for other in brought for one in lint_document(other, dispatch))]
            found = new_errors(source, before, result, after)
        if found:
            return Judgement(found)
        others = self._others(settings, given.file)
        after = [*after, *lint_document(result, others)]
        if not has_refusals(result, after):
            return Judgement()
        before = [*given.found, *lint_document(source, others)]
        return Judgement(*new_refusals(source, before, result, after))

    def _others(self, settings: Settings, file: Path) -> Dispatch:
        """The rules that predict what the consumers of results do, and are not asked for: those in preview, too."""
        asked = (facts.code for facts in self._book.active(settings, file, tuple(ELSEWHERE)).facts)
        consumers = tuple(consumer.value for consumer in OWN_CONSUMER.values())
        every = settings._replace(given=UNSET._replace(preview=True, target=consumers))
        return self._book.dispatch(every, file, (*ELSEWHERE, *asked))


def _unexpanded(judged: Input) -> Input:
    """A file that cannot be expanded, with the reasons."""
    # An argument that lacks its value is a warning, since others may give it one.
    warnings = [one for one in judged.found or () if one.severity is Severity.WARNING]
    why = judged.stopping or warnings
    return judged._replace(document=None, errors=judged.errors or why, stopping=why)


def _included(document: Document) -> list[Document]:
    """The files that a document includes, and those that these include."""
    from sdfcheck.robot.includes.included import included, includes_of

    found: list[Document] = []
    waiting = [document]
    while waiting:
        at = waiting.pop()
        for include in includes_of(at):
            other = included(at, include).document
            if other is not None and other is not document and other not in found:
                found.append(other)
                waiting.append(other)
    return found


def spelled(data: bytes) -> str:
    """How the bytes of a file spell its text; empty for UTF-8 without a byte order mark."""
    from sdfcheck.source.decode import encoding_of

    encoding = encoding_of(data)
    name = "" if encoding.codec == "utf-8" else encoding.codec.upper()
    if encoding.mark and not name:
        return "UTF-8 with a byte order mark"
    return name


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
            return "; ".join(filter(None, (f"not converted, nothing written: {self.reason}", self.way_out)))
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
    from sdfcheck.convert.new_errors import guess_in

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
    different, also_by = _differences(done, given.document, request)
    return Outcome(
        given.file,
        given.errors,
        [*losses, *different],
        done,
        done.verification,
        bool(different),
        stopping=different,
        broken=guess_in(given.document) if request.verify else None,
        also_by=also_by,
        encoding=given.encoding,
    )


def _differences(done: Conversion, document: Document, request: Request) -> tuple[list[Diagnostic], str]:
    """The findings of the comparison, as diagnostics of the source, and which consumers have compared."""
    found = list(done.verification.differences) if done.verification is not None else []
    texts, also_by = [], ""
    if request.verify_with:
        from sdfcheck.convert.independent import Judge, second_opinion

        judges = list(map(Judge, request.verify_with))
        opinion = second_opinion(done, document, judges)
        found += opinion.differences
        also_by = listed([judge.value for judge in judges if judge not in opinion.blind])
        blind = [f"{judge.value} does not read the source: {why}" for judge, why in opinion.blind.items()]
        if not also_by:
            texts += [f"nothing was compared: {text}" for text in blind]
        elif blind:
            also_by += f" ({'; '.join(blind)})"
    texts += [f"the result is not the same robot: {one.what} of `{one.name}` {one.text}" for one in found]
    if not texts or document.root is None:
        return [], also_by
    from sdfcheck.convert.loss import Loss, LossKind, to_diagnostic

    span = document.root.span
    losses = (Loss(LossKind.NOT_VERIFIED, span, text, Severity.ERROR) for text in texts)
    return [to_diagnostic(loss) for loss in losses], also_by


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
            from sdfcheck.report.table import wrapped

            lines = [part for line in lines for part in wrapped(line, view.width)]
        (say_lines if aside else emit_lines)(lines, color=color)

    def _grouped(self, diagnostics: Sequence[Diagnostic], *, color: bool) -> Iterator[str]:
        from sdfcheck.report.colors import painter
        from sdfcheck.report.formats.concise import by_file_and_code
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
_OTHER_WORK = frozenset(
    {Kind.SDF, Kind.URDF, Kind.XACRO, Kind.SRDF, Kind.MJCF, Kind.WEBOTS, Kind.MODEL_CONFIG}
)
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

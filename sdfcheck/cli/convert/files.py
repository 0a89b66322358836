"""The files of a conversion: what is converted, and where results and reports go."""

from __future__ import annotations

import os
from collections.abc import Collection, Mapping, Sequence
from pathlib import Path
from types import TracebackType
from typing import TYPE_CHECKING

from sdfcheck.cli.convert.options import Request
from sdfcheck.cli.parts.descriptions import Around, chosen_arguments, expander_for
from sdfcheck.cli.parts.output import refuse_to_write
from sdfcheck.cli.parts.terminal import read_stdin
from sdfcheck.consumers.reaction import Consumer
from sdfcheck.convert.soundness import has_refusals, means_another_robot, new_errors, new_refusals
from sdfcheck.files.discover import discover
from sdfcheck.files.library import Library, SearchPaths
from sdfcheck.files.regular import identity, read_named
from sdfcheck.lint.config.settings import UNSET, Settings
from sdfcheck.lint.diagnostic import Diagnostic, Severity
from sdfcheck.lint.engine import Dispatch, lint_document
from sdfcheck.lint.rulebook.rulebook import RuleBook
from sdfcheck.lint.targets import ELSEWHERE, OWN_CONSUMER, obstacles, own_consumer
from sdfcheck.source.errors import WrongUsage
from sdfcheck.source.record import NamedTuple
from sdfcheck.source.sniff import Kind, sniff
from sdfcheck.source.text import relative_path

if TYPE_CHECKING:
    from sdfcheck.source.document import Document
    from sdfcheck.xacro.expansion import Expander


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
            raise WrongUsage("several inputs need --output-dir")
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

    def __init__(self, around: Around, *, lint: bool = True, expand: bool = True) -> None:
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
        from sdfcheck.robot.includes.multiplied import refuse_too_many
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
        """A document with the errors that the configured rules find in it."""
        file = document.path
        found = lint_document(document, self._book.dispatch(settings, file))
        shown = [one for one in found if one.severity is Severity.ERROR or means_another_robot(one)]
        stopping = obstacles(found, own_consumer(document), ELSEWHERE)
        return Input(file, document, shown, stopping, found=found)

    def judge(self, given: Input, result: Document) -> Judgement:
        """The verdict on a result; a good one if nobody has looked at the source."""
        source = given.document
        if given.found is None or source is None:
            return Judgement()
        settings = self._around.settings_for(given.file)
        dispatch = self._book.dispatch(settings, given.file, tuple(ELSEWHERE))
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

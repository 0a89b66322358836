"""The robot of an open text, expanded where it is xacro, and the texts that are made of it."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING

from sdfcheck.lint.fix import TextEdit
from sdfcheck.lsp.actions import differences
from sdfcheck.lsp.workspace import Buffer, Workspace
from sdfcheck.source.document import Document
from sdfcheck.source.errors import WrongUsage
from sdfcheck.source.record import NamedTuple
from sdfcheck.source.sniff import Kind
from sdfcheck.source.text import Source, Span
from sdfcheck.xacro.origins import ExpandedDocument

if TYPE_CHECKING:
    from collections.abc import Iterable

    from sdfcheck.convert.result import Conversion

_ROBOTS = frozenset({Kind.SDF, Kind.URDF})


class Robot(NamedTuple):
    """A document that describes a robot or world, and the files that it was made of."""

    document: Document
    files: tuple[Source, ...]


class Place(NamedTuple):
    """Lines of a made text, from 0, and the place that they come from."""

    first: int
    last: int
    span: Span


def robot_of(workspace: Workspace, buffer: Buffer, arguments: Mapping[str, str] | None = None) -> Robot:
    """The robot that a text describes; ``arguments`` are for xacro, over those of the configuration.

    Raises:
        WrongUsage: it describes none, or cannot be expanded.
    """
    from sdfcheck.robot.includes.multiplied import refuse_too_many

    document = workspace.document(buffer.path)
    files: tuple[Source, ...] = ()
    if document is not None and document.kind is Kind.XACRO:
        document = _expanded(workspace, document, arguments or {})
        files = tuple(document.provenance.files)
    if document is None or document.root is None or document.kind not in _ROBOTS:
        raise WrongUsage(
            f"{buffer.path.name} looks like {buffer.kind.description}, not like a robot or world"
        )
    refuse_too_many(document)
    return Robot(document, files or (document.source,))


def _expanded(workspace: Workspace, document: Document, arguments: Mapping[str, str]) -> ExpandedDocument:
    from sdfcheck.xacro.prepare import expand_as_launched

    settings = workspace.settings_for(document.path)
    expander, sets = workspace.caches.xacro(settings, document.path)
    if expander is None:
        raise WrongUsage("the setting expandXacro is off")
    done = expand_as_launched(document, expander.expand, {**(sets[0] if sets else {}), **arguments})
    if done.document is None:
        first = done.problems[0].span if done.problems else document.source.span(0, 0)
        place = f"{first.source.path.name}:{first.begin.line}"
        raise WrongUsage(f"{document.path.name} cannot be expanded: see the diagnostics of {place}")
    done.document.library = document.library
    return done.document


def expanded_text(
    workspace: Workspace, buffer: Buffer, arguments: Mapping[str, str] | None = None
) -> tuple[str, list[Place]]:
    """The text to which a xacro file expands, and where each of its elements was written.

    Raises:
        WrongUsage: as for :func:`robot_of`; or there is nothing to expand.
    """
    document = workspace.document(buffer.path)
    if document is None or document.kind is not Kind.XACRO:
        raise WrongUsage(f"{buffer.path.name} is {buffer.kind.description}: there is nothing to expand")
    expanded = _expanded(workspace, document, arguments or {})
    source, scan = expanded.source, expanded.scan
    places = [
        Place(
            source.position(scan.starts[element.index]).line - 1,
            source.position(scan.close_ends[element.index]).line - 1,
            element.span,
        )
        for element in expanded.elements
    ]
    return source.text, places


def converted(
    workspace: Workspace, buffer: Buffer, to: str, arguments: Mapping[str, str] | None = None
) -> Conversion:
    """The conversion of a text to ``"sdf"`` or ``"urdf"``, verified.

    Raises:
        WrongUsage: as for :func:`robot_of`; or there is no such conversion.
        NotConvertible: its own consumer refuses the text, or the target cannot say it in any way.
    """
    from sdfcheck.convert.call import convert
    from sdfcheck.robot.root import root_of

    return convert(root_of(robot_of(workspace, buffer, arguments).document), to)


def canonical_edits(workspace: Workspace, buffer: Buffer) -> Iterable[TextEdit]:
    """The edits that bring a text into canonical form.

    Raises:
        WrongUsage: it has none, or is broken.
    """
    from sdfcheck.convert.rewrite.canonical import CanonicalStyle, canonical

    document = workspace.document(buffer.path)
    if document is not None and document.kind is Kind.XACRO:
        raise WrongUsage("xacro has no canonical form: `sdfcheck print` would expand it")
    if document is None or document.root is None or document.kind not in _ROBOTS:
        raise WrongUsage(
            f"{buffer.path.name} looks like {buffer.kind.description}, not like a robot or world"
        )
    return differences(buffer.source, canonical(document, CanonicalStyle()).text)


def keeps_expansion(workspace: Workspace, buffer: Buffer, edits: Iterable[TextEdit]) -> bool:
    """Does a text expand to the same elements after edits? Also true where it is not expanded on its own."""
    from sdfcheck.source.splice import replaced
    from sdfcheck.xacro.static.definitions import is_robot

    document = workspace.document(buffer.path)
    if document is None or not is_robot(document):
        return True
    try:
        before = _expanded(workspace, document, {})
    except WrongUsage:
        return True
    text = replaced(document.source.text, [(edit.span.start, edit.span.end, edit.text) for edit in edits])
    changed = Document(Source(document.path, text), Kind.XACRO, [])
    changed.library = document.library
    try:
        after = _expanded(workspace, changed, {})
    except WrongUsage:
        return False
    return _content(before) == _content(after)


def _content(document: Document) -> list[tuple[str, list[tuple[str, object]], object, int]]:
    """The elements with their attributes and texts; numbers as what they mean."""
    return [
        (
            element.name,
            [(name, _meaning(value)) for name, value in element.attributes.items()],
            _meaning(element.content),
            len(list(element.around)),
        )
        for element in document.elements
    ]


def _meaning(text: str) -> tuple[object, ...]:
    return tuple(map(_number, text.split()))


def _number(word: str) -> object:
    try:
        return float(word)
    except ValueError:
        return word

"""The parameters of a macro, while its call is typed."""

from __future__ import annotations

from collections.abc import Iterator

from sdfcheck.lsp.completion.context import Context, Where, context
from sdfcheck.lsp.workspace import Buffer, Workspace
from sdfcheck.source.document import Comment, Document
from sdfcheck.source.record import NamedTuple
from sdfcheck.xacro.language import KEYWORDS, PREFIX, Parameter
from sdfcheck.xacro.static.definitions import Macro, visible_definitions


class Signature(NamedTuple):
    """A call as it could be written; ``parameters`` are places in the label, ``active`` the number of one."""

    label: str
    parameters: tuple[tuple[int, int], ...]
    notes: tuple[str, ...]
    """A note about each parameter."""
    active: int | None
    story: str
    """The comment before the macro."""


def signature(workspace: Workspace, buffer: Buffer, offset: int) -> Signature | None:
    """The macro whose call is being typed at a place."""
    place = context(buffer.source.text, offset, buffer.checkpoints)
    if place.where not in {Where.ATTRIBUTE, Where.VALUE} or not place.tag.startswith(PREFIX):
        return None
    name = place.tag.removeprefix(PREFIX)
    if name == "call":
        name = dict(place.given).get("macro", "")
    document = workspace.document(buffer.path)
    macro = None if document is None or name in KEYWORDS else macro_of(document, name)
    return None if macro is None else _signature(macro, place)


def macro_of(document: Document, name: str) -> Macro | None:
    """The macro that a call in a document means."""
    known = visible_definitions(document).macros
    found = known.get(name) or known.get(name.rpartition(".")[2])
    return found[-1] if found else None


def described(macro: Macro) -> Iterator[str]:
    """The comment before a macro, and its parameters."""
    if story := _story(macro):
        yield story
    if rows := [f"- `{_written(each)}`: {_note(each)}" for each in macro.parameters]:
        yield "\n".join(rows)


def _signature(macro: Macro, place: Context) -> Signature:
    label = f"{PREFIX}{macro.name}"
    places: list[tuple[int, int]] = []
    for parameter in macro.parameters:
        text = _written(parameter)
        places.append((len(label) + 1, len(label) + 1 + len(text)))
        label = f"{label} {text}"
    notes = tuple(map(_note, macro.parameters))
    return Signature(label, tuple(places), notes, _active(macro, place), _story(macro))


def _written(parameter: Parameter) -> str:
    if not parameter.is_optional:
        return parameter.name
    marks = ("^|" if parameter.default else "^") if parameter.forwards else ""
    return f"{parameter.name}:={marks}{parameter.default or ''}"


def _note(parameter: Parameter) -> str:
    if parameter.name.startswith("**"):
        return "all that an element inside of the call holds"
    if parameter.is_block:
        return "an element inside of the call"
    if parameter.forwards:
        return "if it is not given, that of the caller"
    return "required" if parameter.default is None else "optional"


def _active(macro: Macro, place: Context) -> int | None:
    """The parameter whose attribute is being typed, or else the first that is not given yet."""
    names = [parameter.name for parameter in macro.parameters]
    typed = place.attribute if place.where is Where.VALUE else ""
    if typed:
        return names.index(typed) if typed in names else None
    given = dict(place.given)
    return next((n for n, name in enumerate(names) if not name.startswith("*") and name not in given), None)


def _story(macro: Macro) -> str:
    last = next(macro.element.before, None)
    return " ".join(last.text.split()) if isinstance(last, Comment) else ""

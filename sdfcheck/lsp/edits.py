"""Edits, commands and lines that go with a text, in the protocol's own types."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from functools import partial
from typing import Any, TypeVar

from lsprotocol import types

from sdfcheck.convert.loss import NotConvertible, to_diagnostic
from sdfcheck.lsp.colors import colors, written
from sdfcheck.lsp.derived import canonical_edits, converted, expanded_text, keeps_expansion
from sdfcheck.lsp.extract import extractions
from sdfcheck.lsp.lenses import counted, lenses
from sdfcheck.lsp.moves import moved, moves_of
from sdfcheck.lsp.signature import Signature, signature
from sdfcheck.lsp.speech import Speech, path_of, plain
from sdfcheck.lsp.tags import NAME_PATTERN, linked, selections
from sdfcheck.lsp.workspace import Buffer, Workspace
from sdfcheck.source.document import Document
from sdfcheck.source.errors import DescriptionError, WrongUsage
from sdfcheck.source.sniff import Kind
from sdfcheck.source.text import Span

T = TypeVar("T")

EXTRACT = f"{types.CodeActionKind.RefactorExtract.value}.sdfcheck"
REFERENCES = "sdfcheck.references"
"""The command of a client that shows places; one that has it lists it in ``experimental.commands``."""
MOVABLE = "**/*.{sdf,world,urdf,xacro,srdf,config,yaml,stl,obj,dae,glb,gltf,png,jpg,jpeg}"

_LANGUAGES = {"sdf": "sdformat", "urdf": "urdf"}


class Impossible(Exception):
    """A request that cannot be answered; the message says why."""


class Edits:
    """The answers about edits, request by request; all of it runs in the worker's thread."""

    def __init__(self, workspace: Workspace, speech: Speech) -> None:
        self.workspace = workspace
        self.speech = speech

    def document(self, buffer: Buffer) -> Document:
        """The document of an open text, with its library."""
        document = self.workspace.document(buffer.path)
        assert document is not None, "an open text is a document"
        return document

    # While typing

    def linked(
        self, buffer: Buffer, params: types.LinkedEditingRangeParams
    ) -> types.LinkedEditingRanges | None:
        document = self.document(buffer)
        found = linked(document, self.speech.offset(document.source, params.position))
        if found is None:
            return None
        return types.LinkedEditingRanges([self.speech.range(span) for span in found], NAME_PATTERN)

    def selections(
        self, buffer: Buffer, params: types.SelectionRangeParams
    ) -> list[types.SelectionRange] | None:
        document = self.document(buffer)
        return [
            self._nested(selections(document, self.speech.offset(document.source, position)))
            for position in params.positions
        ]

    def _nested(self, spans: Sequence[Span]) -> types.SelectionRange:
        outer: types.SelectionRange | None = None
        for span in reversed(spans):
            outer = types.SelectionRange(self.speech.range(span), outer)
        assert outer is not None, "a place is within a range"
        return outer

    def signature(self, buffer: Buffer, params: types.SignatureHelpParams) -> types.SignatureHelp | None:
        found = signature(self.workspace, buffer, self.speech.offset(buffer.source, params.position))
        return None if found is None else types.SignatureHelp([_signature(found)], 0, found.active)

    def formatted(self, buffer: Buffer, _: Any) -> list[types.TextEdit]:
        return list(self.speech.text_edits(_tried(partial(canonical_edits, self.workspace, buffer))))

    # Colors

    def colors(self, buffer: Buffer, _: Any) -> list[types.ColorInformation]:
        return [
            types.ColorInformation(self.speech.range(color.span), types.Color(*color.channels))
            for color in colors(self.document(buffer))
        ]

    def presentations(
        self, buffer: Buffer, params: types.ColorPresentationParams
    ) -> list[types.ColorPresentation]:
        before = self.speech.span(buffer.source, params.range).text
        color = params.color
        text = written(before, (color.red, color.green, color.blue, color.alpha))
        return [types.ColorPresentation(text, types.TextEdit(params.range, text))]

    # Refactorings

    def extractions(self, buffer: Buffer, chosen: types.Range) -> list[types.CodeAction]:
        """The actions that give a name to what is selected."""
        span = self.speech.span(buffer.source, chosen)
        data = {"uri": buffer.uri, "extract": [span.start, span.end]}
        resolves = self.speech.is_able("text_document", "code_action", "resolve_support")
        return [
            types.CodeAction(
                found.title,
                kind=EXTRACT,
                data=data if resolves else None,
                edit=None if resolves else self.speech.workspace_edit(found.edits),
            )
            for found in extractions(self.document(buffer), span)
        ]

    def extracted(self, buffer: Buffer, action: types.CodeAction, wanted: Sequence[int]) -> types.CodeAction:
        """The edits of an extraction that was offered without them.

        Raises:
            Impossible: the expansion would be another one, or the text is another one now.
        """
        span = buffer.source.span(*wanted)
        for found in extractions(self.document(buffer), span):
            if found.title == action.title:
                if not keeps_expansion(self.workspace, buffer, found.edits):
                    raise Impossible("the robot would be expanded to something else")
                action.edit = self.speech.workspace_edit(found.edits)
                return action
        raise Impossible("the text has changed")

    # Lines above definitions

    def lenses(self, buffer: Buffer, _: Any) -> list[types.CodeLens]:
        if not self.workspace.choices.lenses:
            return []
        return [
            types.CodeLens(self.speech.range(lens.span), data={"uri": buffer.uri, "file": lens.is_file})
            for lens in lenses(self.document(buffer))
        ]

    def counted(self, buffer: Buffer, lens: types.CodeLens) -> types.CodeLens:
        """A line with its words."""
        document = self.document(buffer)
        place = lens.range.start
        is_file = bool(plain(lens.data)["file"])
        offset = self.speech.offset(document.source, place)
        found = counted(self.workspace, document, offset, is_file=is_file)
        if found is None:
            lens.command = types.Command("not included by a file" if is_file else "", "")
            return lens
        has_command = REFERENCES in _commands_of(self.speech.client)
        where = [self.speech.location(span) for span in found.places]
        arguments = [buffer.uri, place, where] if has_command and where else None
        lens.command = types.Command(found.title, REFERENCES if arguments else "", arguments=arguments)
        return lens

    # Files

    def moved(self, renames: Iterable[types.FileRename]) -> types.WorkspaceEdit | None:
        moves = moves_of((path_of(each.old_uri), path_of(each.new_uri)) for each in renames)
        edits = moved(self.workspace, moves)
        return self.speech.workspace_edit(edits) if edits else None

    # Commands

    def expanded(self, buffer: Buffer, arguments: Mapping[str, str]) -> dict[str, Any]:
        """The expanded text, and the place in the sources of each range of lines."""
        text, places = _tried(lambda: expanded_text(self.workspace, buffer, arguments))
        root = self.document(buffer).root
        return {
            "text": text,
            "language": _LANGUAGES["sdf" if root is not None and root.name == "sdf" else "urdf"],
            "places": [
                {"first": place.first, "last": place.last, "location": self.speech.location(place.span)}
                for place in places
            ],
        }

    def converted(self, buffer: Buffer, to: str, arguments: Mapping[str, str]) -> dict[str, Any]:
        """The text in another format, and what it lacks."""
        wanted = to or ("urdf" if self.document(buffer).kind is Kind.SDF else "sdf")
        if wanted not in _LANGUAGES:
            raise Impossible(f"`{wanted}` is not a format to convert to: use sdf or urdf")
        done = _tried(lambda: converted(self.workspace, buffer, wanted, arguments))
        lost = [to_diagnostic(loss) for loss in done.losses]
        return {
            "text": done.text,
            "language": _LANGUAGES[wanted],
            "verified": done.verification is not None and done.verification.is_equal,
            "verdict": "not verified" if done.verification is None else str(done.verification),
            "losses": [
                {"uri": self.speech.location(loss.span).uri, "diagnostic": self.speech.diagnostic(loss)}
                for loss in lost
            ],
        }


def _tried(job: Callable[[], T]) -> T:
    """The result of a job.

    Raises:
        Impossible: it cannot be done, for a reason that a person can change.
    """
    try:
        return job()
    except (WrongUsage, NotConvertible, DescriptionError) as error:
        raise Impossible(str(error)) from None


def _commands_of(client: types.ClientCapabilities) -> Sequence[Any]:
    known = plain(client.experimental)
    found = known.get("commands") if isinstance(known, dict) else None
    return found if isinstance(found, list) else ()


def _signature(found: Signature) -> types.SignatureInformation:
    parameters = [
        types.ParameterInformation(place, note)
        for place, note in zip(found.parameters, found.notes, strict=True)
    ]
    return types.SignatureInformation(found.label, found.story or None, parameters)

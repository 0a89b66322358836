"""The answers to requests, from what is known of open texts, in the protocol's own types."""

from __future__ import annotations

import re
from bisect import bisect_right
from collections.abc import Iterable, Iterator
from itertools import chain
from json import dumps
from pathlib import Path
from typing import Any

from lsprotocol import types

from sdfcheck.files.regular import read_regular
from sdfcheck.lsp.actions import Offer, fix_all, offers
from sdfcheck.lsp.completion import complete
from sdfcheck.lsp.context import Item, Sort
from sdfcheck.lsp.edits import EXTRACT, Edits
from sdfcheck.lsp.findings import Findings
from sdfcheck.lsp.hints import hints, tokens
from sdfcheck.lsp.hover import hover
from sdfcheck.lsp.names import LARGEST, definitions, occurrences, project_files, references
from sdfcheck.lsp.outline import Maker, Mover, Outlined, Part, folds, links, outline, target_of
from sdfcheck.lsp.rename import Refused, Target, rename, target
from sdfcheck.lsp.speech import NAME, ProtocolTypes, Units, Written, place_of, plain
from sdfcheck.lsp.workspace import Buffer, Workspace
from sdfcheck.robot.naming.occurrences import Occurrence
from sdfcheck.source.decode import decode
from sdfcheck.source.document import Document
from sdfcheck.source.record import NamedTuple
from sdfcheck.source.text import Source, Span

# The parts of a whole project that have a name, found without reading its files as trees.


_NAMED = re.compile(
    r"<(world|model|link|joint|frame|sensor|robot|xacro:macro|xacro:property|xacro:arg)\b"
    r"[^<>]*?\sname\s*=\s*([\"'])(.*?)\2",
    re.DOTALL,
)
_MOST = 500


class Found(NamedTuple):
    """A part of the project: the name of its element, its own, and where that is."""

    kind: str
    name: str
    span: Span


def survey(workspace: Workspace, query: str) -> list[Found]:
    """The parts whose names have the letters of a query, in their order; not all of very many."""
    letters = re.compile(".*?".join(map(re.escape, query.strip())), re.IGNORECASE | re.DOTALL)
    found: list[Found] = []
    for path in _paths(workspace):
        source = _source(workspace, path)
        if source is None:
            continue
        found += (
            Found(match[1], match[3], source.span(match.start(3), match.end(3)))
            for match in _NAMED.finditer(source.text)
            if letters.search(match[3])
        )
        if len(found) >= _MOST:
            break
    return sorted(found[:_MOST], key=lambda each: (len(each.name), each.name))


def _paths(workspace: Workspace) -> Iterator[Path]:
    seen: set[str] = set()
    starts = [folder / "all" for folder in workspace.folders]
    starts += [buffer.path for buffer in workspace.buffers.values()]
    for start in starts[:20]:
        for path in project_files(workspace, start):
            key = workspace.key(path)
            if key not in seen:
                seen.add(key)
                yield path


def _source(workspace: Workspace, path: Path) -> Source | None:
    buffer = workspace.buffers.get(workspace.key(path))
    if buffer is not None:
        return buffer.source
    try:
        return decode(read_regular(path, LARGEST), path)[0]
    except OSError:
        return None


FIX_ALL = f"source.fixAll.{NAME}"

_ITEMS = {
    Sort.ELEMENT: types.CompletionItemKind.Property,
    Sort.ATTRIBUTE: types.CompletionItemKind.Field,
    Sort.CHOICE: types.CompletionItemKind.EnumMember,
    Sort.NAME: types.CompletionItemKind.Reference,
    Sort.FILE: types.CompletionItemKind.File,
    Sort.FOLDER: types.CompletionItemKind.Folder,
    Sort.MACRO: types.CompletionItemKind.Function,
    Sort.PROPERTY: types.CompletionItemKind.Variable,
    Sort.WORD: types.CompletionItemKind.Keyword,
}
_SYMBOLS = {
    "sdf": types.SymbolKind.File,
    "world": types.SymbolKind.Namespace,
    "model": types.SymbolKind.Class,
    "robot": types.SymbolKind.Class,
    "link": types.SymbolKind.Object,
    "joint": types.SymbolKind.Interface,
    "frame": types.SymbolKind.Key,
    "include": types.SymbolKind.Module,
    "xacro:include": types.SymbolKind.Module,
    "xacro:macro": types.SymbolKind.Function,
    "xacro:property": types.SymbolKind.Variable,
    "xacro:arg": types.SymbolKind.Constant,
    "plugin": types.SymbolKind.Package,
    "sensor": types.SymbolKind.Event,
    "light": types.SymbolKind.Event,
}
_OTHER = types.SymbolKind.Property
_LINE = re.compile(r'(?<!\\)"line":(\d+)')
"""The number of a line in what is written of a symbol, whose strings have no quotation mark without a backslash."""
_Row = tuple[str, str, tuple[int, int], str]
"""A part in an outline without steps: its kind, its name, where that is, and the part around it."""


class Answers:
    """The answers of the server, request by request; all of it runs in the worker's thread."""

    def __init__(self, workspace: Workspace, findings: Findings, speech: ProtocolTypes) -> None:
        self.workspace = workspace
        self.findings = findings
        self.speech = speech
        self.edits = Edits(workspace, speech)
        self._outlined: dict[str, Outlined[str]] = {}
        """The address of the text that was asked about last, and its outline."""

    def document(self, buffer: Buffer) -> Document:
        """The document of an open text, with its library."""
        document = self.workspace.document(buffer.path)
        assert document is not None, "an open text is a document"
        return document

    # Diagnostics

    def actions(self, buffer: Buffer, params: types.CodeActionParams) -> list[types.CodeAction]:
        """The actions for the diagnostics in a range."""
        wanted = [str(getattr(kind, "value", kind)) for kind in params.context.only or ()]
        found: list[types.CodeAction] = []
        self.findings.lint(buffer)
        if _is_wanted("quickfix", wanted):
            at = self.speech.span(buffer.source, params.range)
            known = self.findings.at(buffer.path)
            found += map(self._action, offers(self.workspace, buffer, known, at))
        if _is_wanted(FIX_ALL, wanted):
            found += self._fix_all(buffer, asked=bool(wanted))
        if _is_wanted(EXTRACT, wanted):
            found += self.edits.extractions(buffer, params.range)
        return found

    def _action(self, offer: Offer) -> types.CodeAction:
        return types.CodeAction(
            title=offer.title,
            kind=types.CodeActionKind.QuickFix,
            diagnostics=[self.speech.diagnostic(offer.diagnostic)],
            is_preferred=True if offer.is_fix and offer.is_safe else None,
            edit=self.speech.workspace_edit(offer.edits),
        )

    def _fix_all(self, buffer: Buffer, *, asked: bool) -> Iterable[types.CodeAction]:
        safe = [d for d in self.findings.at(buffer.path) if d.fix is not None and d.fix.is_safe]
        if not safe:
            return
        action = types.CodeAction(f"Fix all safe problems of {NAME}", kind=FIX_ALL)
        if not asked and self.speech.is_able("text_document", "code_action", "resolve_support"):
            action.data = {"uri": buffer.uri}
            yield action
        elif edits := fix_all(self.workspace, buffer):
            action.edit = self.speech.workspace_edit(edits)
            yield action

    def resolved(self, buffer: Buffer, action: types.CodeAction) -> types.CodeAction:
        """The edits of what was offered without them."""
        data = plain(action.data)
        if isinstance(data, dict) and "extract" in data:
            return self.edits.extracted(buffer, action, data["extract"])
        action.edit = self.speech.workspace_edit(fix_all(self.workspace, buffer))
        return action

    # Facts

    def hover(self, buffer: Buffer, params: types.HoverParams) -> types.Hover | None:
        offset = self.speech.offset(buffer.source, params.position)
        document = self.findings.near(buffer, offset) or self.document(buffer)
        found = hover(document, offset, self.findings.at(buffer.path), self.workspace)
        if found is None:
            return None
        content = types.MarkupContent(types.MarkupKind.Markdown, found.text)
        return types.Hover(content, self.speech.range(found.span))

    def completion(self, buffer: Buffer, params: types.CompletionParams) -> types.CompletionList:
        source = buffer.source
        offset = self.speech.offset(source, params.position)
        found = complete(self.workspace, buffer, offset)
        has_snippets = self.speech.is_able(
            "text_document", "completion", "completion_item", "snippet_support"
        )
        place = types.Range(
            self.speech.position(source, found.start), self.speech.position(source, found.end)
        )
        return types.CompletionList(
            False, [_item(n, item, place, has_snippets) for n, item in enumerate(found.items)]
        )

    def symbols(self, buffer: Buffer, _: Any) -> Written | list[types.SymbolInformation]:
        source = buffer.source
        if self.speech.is_able("text_document", "document_symbol", "hierarchical_document_symbol_support"):
            before = self._outlined.get(buffer.uri)
            if before is None or before.source is not source:
                before = outline(source, self._written_symbol(source), before, self._moved_symbol(source))
                self._outlined = {buffer.uri: before}
            return Written(f"[{','.join(before.parts)}]")
        return [
            types.SymbolInformation(
                self.speech.location(source.span(*place)),
                name,
                _SYMBOLS.get(kind, _OTHER),
                container_name=holder,
            )
            for rows in outline(source, _flat).parts
            for kind, name, place, holder in rows
        ]

    def _written_symbol(self, source: Source) -> Maker[str]:
        """Writes parts of an outline as the protocol does."""
        starts, units = [*source.line_starts, len(source.text) + 1], self.speech.units
        is_plain = units is Units.UTF32 or source.text.isascii()

        def place(offset: int) -> str:
            line, column = place_of(source, offset, units)
            return f'{{"line":{line},"character":{column}}}'

        heads: dict[str, str] = {}

        def written(part: Part[str], end: int) -> str:
            kind, detail, name, start, first, last, parts = part
            head = heads.get(detail)
            if head is None:
                head = f'"kind":{int(_SYMBOLS.get(kind, _OTHER))},"detail":{dumps(detail)},"name":'
                heads[detail] = head
            own = f'{head}"{name}"' if name.isidentifier() else head + dumps(name)
            line = bisect_right(starts, start)
            before = starts[line - 1]
            if is_plain and last < starts[line]:  # as nearly always
                below = bisect_right(starts, end, line - 1) - 1
                row = f'{{"line":{line - 1},"character":'
                places = (
                    f'"range":{{"start":{row}{start - before}}},'
                    f'"end":{{"line":{below},"character":{end - starts[below]}}}}},'
                    f'"selectionRange":{{"start":{row}{first - before}}},"end":{row}{last - before}}}}}'
                )
            else:
                places = (
                    f'"range":{{"start":{place(start)},"end":{place(end)}}},'
                    f'"selectionRange":{{"start":{place(first)},"end":{place(last)}}}'
                )
            return f'{{{own},{places},"children":[{",".join(parts)}]}}' if parts else f"{{{own},{places}}}"

        return written

    def _moved_symbol(self, source: Source) -> Mover[str] | None:
        """Writes a part of an outline again for an equal text on other lines; None where columns may differ."""
        if self.speech.units is not Units.UTF32 and not source.text.isascii():
            return None
        starts = source.line_starts
        forms: dict[str, tuple[str, list[int]]] = {}

        def moved(written: str, first: int, start: int) -> str | None:
            here, there = bisect_right(starts, first) - 1, bisect_right(starts, start) - 1
            if first - starts[here] != start - starts[there]:
                return None
            if written not in forms:
                form = _LINE.sub('"line":%d', written.replace("%", "%%"))
                forms[written] = form, [int(line) - here for line in _LINE.findall(written)]
            form, lines = forms[written]
            return form % tuple([line + there for line in lines])

        return moved

    def folds(self, buffer: Buffer, _: Any) -> Written:
        kinds = {True: ',"kind":"comment"', False: ""}
        written = (
            f'{{"startLine":{first},"endLine":{last}{kinds[is_comment]}}}'
            for first, last, is_comment in folds(self.document(buffer))
        )
        return Written(f"[{','.join(written)}]")

    def links(self, buffer: Buffer, _: Any) -> list[types.DocumentLink]:
        return [
            types.DocumentLink(self.speech.range(link.span), self.speech.uri(link.target))
            for link in links(self.document(buffer))
        ]

    def hints(self, buffer: Buffer, params: types.InlayHintParams) -> list[types.InlayHint]:
        within = self.speech.span(buffer.source, params.range)
        return [
            types.InlayHint(
                self.speech.position(buffer.source, hint.offset),
                hint.text,
                tooltip=hint.note,
                padding_left=True,
            )
            for hint in hints(self.document(buffer), within)
        ]

    def tokens(
        self, buffer: Buffer, params: types.SemanticTokensParams | types.SemanticTokensRangeParams
    ) -> types.SemanticTokens:
        given = params.range if isinstance(params, types.SemanticTokensRangeParams) else None
        within = None if given is None else self.speech.span(buffer.source, given)
        data: list[int] = []
        line, column = 0, 0
        for token in tokens(self.document(buffer), within):
            at = self.speech.position(buffer.source, token.span.start)
            start = at.character - column if at.line == line else at.character
            length = self.speech.units.width(token.span.text)
            data += [at.line - line, start, length, token.kind, int(token.is_definition)]
            line, column = at.line, at.character
        return types.SemanticTokens(data)

    def survey(self, query: str) -> list[types.WorkspaceSymbol]:
        return [
            types.WorkspaceSymbol(
                self.speech.location(found.span),
                found.name,
                _SYMBOLS.get(found.kind, _OTHER),
                container_name=found.span.source.path.name,
            )
            for found in survey(self.workspace, query)
        ]

    # Names

    def named(self, buffer: Buffer, position: types.Position) -> Occurrence | None:
        """The name at a place."""
        document = self.document(buffer)
        return occurrences(document).at(self.speech.offset(document.source, position))

    def definition(
        self, buffer: Buffer, params: types.DefinitionParams
    ) -> types.Location | list[types.Location] | None:
        from sdfcheck.lsp.cursor import at

        document = self.document(buffer)
        named = self.named(buffer, params.position)
        found = [] if named is None else definitions(self.workspace, document, named)
        if found:
            places = list(map(self.speech.location, found))
            return places if len(places) > 1 else places[0]
        cursor = at(document, self.speech.offset(document.source, params.position))
        target = None if cursor is None or cursor.value is None else target_of(document, cursor.value)
        if target is None:
            return None
        start = types.Position(0, 0)
        return types.Location(self.speech.uri(target), types.Range(start, start))

    def references(self, buffer: Buffer, params: types.ReferenceParams) -> list[types.Location] | None:
        named = self.named(buffer, params.position)
        if named is None:
            return None
        found = references(self.workspace, self.document(buffer), named)
        wanted = [each for each in found if params.context.include_declaration or not each.is_definition]
        return [self.speech.location(each.span) for each in wanted]

    def highlights(
        self, buffer: Buffer, params: types.DocumentHighlightParams
    ) -> list[types.DocumentHighlight] | None:
        named = self.named(buffer, params.position)
        if named is None:
            return None
        kinds = {True: types.DocumentHighlightKind.Write, False: types.DocumentHighlightKind.Read}
        return [
            types.DocumentHighlight(self.speech.range(each.span), kinds[each.is_definition])
            for each in occurrences(self.document(buffer)).all
            if each.symbol.key == named.symbol.key
        ]

    def prepared(
        self, buffer: Buffer, params: types.PrepareRenameParams
    ) -> types.PrepareRenamePlaceholder | Refused | None:
        found = self._target(buffer, params.position)
        if isinstance(found, Refused):
            return found
        if found is None:
            return None
        return types.PrepareRenamePlaceholder(self.speech.range(found.piece), found.shown)

    def rename(self, buffer: Buffer, params: types.RenameParams) -> types.WorkspaceEdit | Refused:
        self.workspace.look_again(buffer)
        found = self._target(buffer, params.position)
        if isinstance(found, Refused):
            return found
        if found is None:
            return Refused("there is nothing with a name here")
        try:
            edits = rename(self.workspace, self.document(buffer), found, params.new_name)
            return self.speech.workspace_edit(edits)
        except Refused as refusal:
            return refusal

    def _target(self, buffer: Buffer, position: types.Position) -> Target | Refused | None:
        document = self.document(buffer)
        try:
            return target(document, self.speech.offset(document.source, position))
        except Refused as refusal:
            return refusal


def _flat(part: Part[list[_Row]], end: int) -> list[_Row]:
    kind, _, name, _, first, last, parts = part
    return [
        (kind, name, (first, last), ""),
        *((*row[:3], row[3] or name) for row in chain.from_iterable(parts)),
    ]


def _is_wanted(kind: str, wanted: list[str]) -> bool:
    return not wanted or any(kind == each or kind.startswith(f"{each}.") for each in wanted)


def _item(number: int, item: Item, place: types.Range, has_snippets: bool) -> types.CompletionItem:
    text = item.snippet if has_snippets and item.snippet else item.text
    return types.CompletionItem(
        label=item.label,
        kind=_ITEMS[item.sort],
        detail=item.detail or None,
        sort_text=f"{number:04}",
        filter_text=item.label if item.sort is not Sort.ELEMENT else text,
        insert_text_format=types.InsertTextFormat.Snippet
        if has_snippets and item.snippet
        else types.InsertTextFormat.PlainText,
        tags=[types.CompletionItemTag.Deprecated] if item.is_deprecated else None,
        text_edit=types.TextEdit(place, text),
        documentation=item.note or None,
    )

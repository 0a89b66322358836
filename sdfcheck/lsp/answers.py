"""The answers to requests, from what is known of open texts, in the protocol's own types."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

from lsprotocol import types

from sdfcheck.lsp.actions import Offer, fix_all, offers
from sdfcheck.lsp.completion.complete import complete
from sdfcheck.lsp.completion.item import Item, Sort
from sdfcheck.lsp.findings import Findings
from sdfcheck.lsp.hints import hints, tokens
from sdfcheck.lsp.hover import hover
from sdfcheck.lsp.names.index import everywhere, occurrences
from sdfcheck.lsp.names.rename import Refused, rename
from sdfcheck.lsp.outline import Entry, folds, links, outline, target_of
from sdfcheck.lsp.speech import NAME, Speech
from sdfcheck.lsp.survey import survey
from sdfcheck.lsp.workspace import Buffer, Workspace
from sdfcheck.robot.naming.occurrences import Occurrence
from sdfcheck.source.document import Document

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


class Answers:
    """The answers of the server, request by request; all of it runs in the worker's thread."""

    def __init__(self, workspace: Workspace, findings: Findings, speech: Speech) -> None:
        self.workspace = workspace
        self.findings = findings
        self.speech = speech

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
        action.edit = self.speech.workspace_edit(fix_all(self.workspace, buffer))
        return action

    # Facts

    def hover(self, buffer: Buffer, params: types.HoverParams) -> types.Hover | None:
        document = self.document(buffer)
        offset = self.speech.offset(document.source, params.position)
        found = hover(document, offset, self.findings.at(buffer.path))
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
        return types.CompletionList(False, [_item(item, place, has_snippets) for item in found.items])

    def symbols(self, buffer: Buffer, _: Any) -> list[types.DocumentSymbol] | list[types.SymbolInformation]:
        entries = outline(self.document(buffer))
        if self.speech.is_able("text_document", "document_symbol", "hierarchical_document_symbol_support"):
            return list(map(self._symbol, entries))
        return list(self._flat(entries, ""))

    def _symbol(self, entry: Entry) -> types.DocumentSymbol:
        return types.DocumentSymbol(
            name=entry.name,
            detail=entry.detail,
            kind=_SYMBOLS.get(entry.kind, types.SymbolKind.Property),
            range=self.speech.range(entry.whole),
            selection_range=self.speech.range(entry.place),
            children=list(map(self._symbol, entry.children)),
        )

    def _flat(self, entries: Iterable[Entry], holder: str) -> Iterable[types.SymbolInformation]:
        for entry in entries:
            kind = _SYMBOLS.get(entry.kind, types.SymbolKind.Property)
            yield types.SymbolInformation(
                self.speech.location(entry.place), entry.name, kind, container_name=holder
            )
            yield from self._flat(entry.children, entry.name)

    def folds(self, buffer: Buffer, _: Any) -> list[types.FoldingRange]:
        return [
            types.FoldingRange(
                fold.first, fold.last, kind=types.FoldingRangeKind.Comment if fold.is_comment else None
            )
            for fold in folds(self.document(buffer))
        ]

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
                _SYMBOLS.get(found.kind, types.SymbolKind.Property),
                container_name=found.span.source.path.name,
            )
            for found in survey(self.workspace, query)
        ]

    # Names

    def named(self, buffer: Buffer, position: types.Position) -> Occurrence | None:
        """The name at a place."""
        document = self.document(buffer)
        return occurrences(document).at(self.speech.offset(document.source, position))

    def definition(self, buffer: Buffer, params: types.DefinitionParams) -> types.Location | None:
        from sdfcheck.lsp.cursor import at

        named = self.named(buffer, params.position)
        if named is not None:
            return self.speech.location(named.symbol.span)
        document = self.document(buffer)
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
        found = everywhere(self.workspace, self.document(buffer), named.symbol)
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
    ) -> types.PrepareRenamePlaceholder | None:
        named = self.named(buffer, params.position)
        if named is None:
            return None
        return types.PrepareRenamePlaceholder(self.speech.range(named.span), named.symbol.name)

    def rename(self, buffer: Buffer, params: types.RenameParams) -> types.WorkspaceEdit | Refused:
        named = self.named(buffer, params.position)
        if named is None:
            return Refused("there is nothing with a name here")
        try:
            edits = rename(self.workspace, self.document(buffer), named, params.new_name)
            return self.speech.workspace_edit(edits)
        except Refused as refusal:
            return refusal


def _is_wanted(kind: str, wanted: list[str]) -> bool:
    return not wanted or any(kind == each or kind.startswith(f"{each}.") for each in wanted)


def _item(item: Item, place: types.Range, has_snippets: bool) -> types.CompletionItem:
    text = item.snippet if has_snippets and item.snippet else item.text
    return types.CompletionItem(
        label=item.label,
        kind=_ITEMS[item.sort],
        detail=item.detail or None,
        sort_text=f"{item.rank:02}{item.label}",
        filter_text=item.label if item.sort is not Sort.ELEMENT else text,
        insert_text_format=types.InsertTextFormat.Snippet
        if has_snippets and item.snippet
        else types.InsertTextFormat.PlainText,
        tags=[types.CompletionItemTag.Deprecated] if item.is_deprecated else None,
        text_edit=types.TextEdit(place, text),
        documentation=item.note or None,
    )

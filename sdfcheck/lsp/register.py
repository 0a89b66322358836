"""Ties the requests of the protocol to their answers."""

from __future__ import annotations

import re
from typing import Any

from lsprotocol import types
from pygls.exceptions import JsonRpcInvalidParams

from sdfcheck.lsp.answers import FIX_ALL, Answers
from sdfcheck.lsp.hints import KINDS
from sdfcheck.lsp.names.rename import Refused
from sdfcheck.lsp.server import Server
from sdfcheck.lsp.speech import path_of
from sdfcheck.lsp.watch import Watch
from sdfcheck.lsp.worker import OVERVIEW

_COLORS = dict(
    zip(
        KINDS,
        "class interface type namespace namespace enumMember macro property parameter parameter".split(),
        strict=True,
    )
)
"""Kind of name → the type of token that the protocol has for it."""


def make_server() -> Server:
    """A server that answers everything that it can."""
    server = Server()
    answers = Answers(server.robots, server.findings, server.speech)
    watch = Watch(server)
    _texts(server, watch)
    _diagnostics(server, answers)
    _knowledge(server, answers)
    _names(server, answers)
    _decorations(server, answers)
    return server


def _texts(server: Server, watch: Watch) -> None:
    server.feature(types.TEXT_DOCUMENT_DID_OPEN)(_two(server.opened))
    server.feature(types.TEXT_DOCUMENT_DID_CHANGE)(_two(server.changed))
    server.feature(types.TEXT_DOCUMENT_DID_CLOSE)(_two(server.closed))

    @server.feature(types.INITIALIZE)
    def initialize(params: types.InitializeParams) -> None:
        server.began(params)
        watch.began(params)

    @server.feature(types.INITIALIZED)
    async def initialized(params: types.InitializedParams) -> None:
        await watch.start()

    @server.feature(types.TEXT_DOCUMENT_DID_SAVE)
    async def saved(params: types.DidSaveTextDocumentParams) -> None:
        await watch.saved(path_of(params.text_document.uri))

    @server.feature(types.WORKSPACE_DID_CHANGE_WATCHED_FILES)
    async def watched(params: types.DidChangeWatchedFilesParams) -> None:
        await watch.noticed(params.changes)

    @server.feature(types.WORKSPACE_DID_CHANGE_CONFIGURATION)
    async def configured(params: types.DidChangeConfigurationParams) -> None:
        await watch.configured(params.settings)

    @server.feature(types.SHUTDOWN)
    def shut_down(*_: Any) -> None:
        watch.stop()
        server.ended()


def _two(handler: Any) -> Any:
    """A handler without ``self``, as the protocol library counts arguments."""

    async def handle(params: Any) -> None:
        await handler(params)

    return handle


def _diagnostics(server: Server, answers: Answers) -> None:
    options = types.DiagnosticOptions(
        inter_file_dependencies=True, workspace_diagnostics=False, identifier="sdfcheck"
    )

    @server.feature(types.TEXT_DOCUMENT_DIAGNOSTIC, options)
    async def diagnostics(
        params: types.DocumentDiagnosticParams,
    ) -> types.RelatedFullDocumentDiagnosticReport:
        found = await server.pulled(params.text_document.uri)
        return types.RelatedFullDocumentDiagnosticReport(items=found)

    kinds = [types.CodeActionKind.QuickFix, FIX_ALL]

    @server.feature(
        types.TEXT_DOCUMENT_CODE_ACTION,
        types.CodeActionOptions(code_action_kinds=kinds, resolve_provider=True),
    )
    async def actions(params: types.CodeActionParams) -> list[types.CodeAction]:
        return await server.ask(params.text_document.uri, lambda buffer: answers.actions(buffer, params), [])

    @server.feature(types.CODE_ACTION_RESOLVE)
    async def resolve(action: types.CodeAction) -> types.CodeAction:
        data = action.data
        uri = data.get("uri", "") if isinstance(data, dict) else getattr(data, "uri", "")
        return await server.ask(str(uri), lambda buffer: answers.resolved(buffer, action), action)


def _knowledge(server: Server, answers: Answers) -> None:
    @server.feature(types.TEXT_DOCUMENT_HOVER)
    async def hover(params: types.HoverParams) -> types.Hover | None:
        return await server.ask(
            params.text_document.uri, lambda buffer: answers.hover(buffer, params.position), None
        )

    triggers = ["<", '"', "'", ":", "/", " ", "$", "{", ">"]

    @server.feature(types.TEXT_DOCUMENT_COMPLETION, types.CompletionOptions(trigger_characters=triggers))
    async def completion(params: types.CompletionParams) -> types.CompletionList | None:
        uri = params.text_document.uri
        return await server.ask(uri, lambda buffer: answers.completion(buffer, params.position), None)

    @server.feature(types.TEXT_DOCUMENT_DOCUMENT_SYMBOL)
    async def symbols(params: types.DocumentSymbolParams) -> Any:
        return await server.ask(params.text_document.uri, answers.symbols, [], OVERVIEW)

    @server.feature(types.TEXT_DOCUMENT_FOLDING_RANGE)
    async def folds(params: types.FoldingRangeParams) -> list[types.FoldingRange]:
        return await server.ask(params.text_document.uri, answers.folds, [], OVERVIEW)

    @server.feature(types.TEXT_DOCUMENT_DOCUMENT_LINK)
    async def links(params: types.DocumentLinkParams) -> list[types.DocumentLink]:
        return await server.ask(params.text_document.uri, answers.links, [], OVERVIEW)


def _decorations(server: Server, answers: Answers) -> None:
    @server.feature(types.TEXT_DOCUMENT_INLAY_HINT)
    async def hints(params: types.InlayHintParams) -> list[types.InlayHint]:
        uri = params.text_document.uri
        return await server.ask(uri, lambda buffer: answers.hints(buffer, params.range), [], OVERVIEW)

    legend = types.SemanticTokensLegend(token_types=list(_COLORS.values()), token_modifiers=["declaration"])

    @server.feature(types.TEXT_DOCUMENT_SEMANTIC_TOKENS_FULL, legend)
    async def tokens(params: types.SemanticTokensParams) -> types.SemanticTokens | None:
        return await server.ask(params.text_document.uri, answers.tokens, None, OVERVIEW)

    @server.feature(types.TEXT_DOCUMENT_SEMANTIC_TOKENS_RANGE, legend)
    async def tokens_in(params: types.SemanticTokensRangeParams) -> types.SemanticTokens | None:
        uri = params.text_document.uri
        return await server.ask(uri, lambda buffer: answers.tokens(buffer, params.range), None, OVERVIEW)

    @server.feature(types.WORKSPACE_SYMBOL)
    async def survey(params: types.WorkspaceSymbolParams) -> list[types.WorkspaceSymbol]:
        return await server.work(lambda: answers.survey(params.query), [], OVERVIEW)


def _names(server: Server, answers: Answers) -> None:
    @server.feature(types.TEXT_DOCUMENT_DEFINITION)
    async def definition(params: types.DefinitionParams) -> types.Location | None:
        uri = params.text_document.uri
        return await server.ask(uri, lambda buffer: answers.definition(buffer, params.position), None)

    @server.feature(types.TEXT_DOCUMENT_REFERENCES)
    async def references(params: types.ReferenceParams) -> list[types.Location] | None:
        return await server.ask(
            params.text_document.uri, lambda buffer: answers.references(buffer, params), None
        )

    @server.feature(types.TEXT_DOCUMENT_DOCUMENT_HIGHLIGHT)
    async def highlights(params: types.DocumentHighlightParams) -> list[types.DocumentHighlight] | None:
        uri = params.text_document.uri
        return await server.ask(uri, lambda buffer: answers.highlights(buffer, params.position), None)

    @server.feature(types.TEXT_DOCUMENT_PREPARE_RENAME)
    async def prepare(params: types.PrepareRenameParams) -> types.PrepareRenamePlaceholder | None:
        uri = params.text_document.uri
        return await server.ask(uri, lambda buffer: answers.prepared(buffer, params.position), None)

    @server.feature(types.TEXT_DOCUMENT_RENAME, types.RenameOptions(prepare_provider=True))
    async def rename(params: types.RenameParams) -> types.WorkspaceEdit | None:
        found = await server.ask(
            params.text_document.uri, lambda buffer: answers.rename(buffer, params), None
        )
        if isinstance(found, Refused):
            raise JsonRpcInvalidParams(re.sub(r"\s+", " ", str(found)))
        return found

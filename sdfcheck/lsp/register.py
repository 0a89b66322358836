"""Ties the requests of the protocol to their answers."""

from __future__ import annotations

import re
from collections.abc import Callable
from typing import Any

from lsprotocol import types
from pygls.exceptions import JsonRpcInvalidParams

from sdfcheck.lsp.answers import FIX_ALL, Answers
from sdfcheck.lsp.hints import KINDS
from sdfcheck.lsp.names.rename import Refused
from sdfcheck.lsp.server import Server
from sdfcheck.lsp.speech import path_of
from sdfcheck.lsp.watch import Watch
from sdfcheck.lsp.worker import ANSWER, OVERVIEW
from sdfcheck.lsp.workspace import Buffer

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
    _answer(
        server,
        types.TEXT_DOCUMENT_CODE_ACTION,
        answers.actions,
        types.CodeActionOptions(code_action_kinds=kinds, resolve_provider=True),
        otherwise=[],
    )

    @server.feature(types.CODE_ACTION_RESOLVE)
    async def resolve(action: types.CodeAction) -> types.CodeAction:
        data = action.data
        uri = data.get("uri", "") if isinstance(data, dict) else getattr(data, "uri", "")
        return await server.ask(str(uri), lambda buffer: answers.resolved(buffer, action), action)


def _answer(
    server: Server,
    feature: str,
    answer: Callable[[Buffer, Any], Any],
    options: Any = None,
    *,
    otherwise: Any = None,
    urgency: int = ANSWER,
) -> None:
    """Answer requests about a text; ``otherwise``: where it is not open, or that fails."""

    @server.feature(feature, options)
    async def handle(params: Any) -> Any:
        uri = params.text_document.uri
        return await server.ask(uri, lambda buffer: answer(buffer, params), otherwise, urgency)


def _knowledge(server: Server, answers: Answers) -> None:
    triggers = types.CompletionOptions(trigger_characters=["<", '"', "'", ":", "/", " ", "$", "{", ">"])
    _answer(server, types.TEXT_DOCUMENT_HOVER, answers.hover)
    _answer(server, types.TEXT_DOCUMENT_COMPLETION, answers.completion, triggers)
    for feature, answer in (
        (types.TEXT_DOCUMENT_DOCUMENT_SYMBOL, answers.symbols),
        (types.TEXT_DOCUMENT_FOLDING_RANGE, answers.folds),
        (types.TEXT_DOCUMENT_DOCUMENT_LINK, answers.links),
    ):
        _answer(server, feature, answer, otherwise=[], urgency=OVERVIEW)


def _decorations(server: Server, answers: Answers) -> None:
    _answer(server, types.TEXT_DOCUMENT_INLAY_HINT, answers.hints, otherwise=[], urgency=OVERVIEW)
    legend = types.SemanticTokensLegend(token_types=list(_COLORS.values()), token_modifiers=["declaration"])
    for feature in (types.TEXT_DOCUMENT_SEMANTIC_TOKENS_FULL, types.TEXT_DOCUMENT_SEMANTIC_TOKENS_RANGE):
        _answer(server, feature, answers.tokens, legend, urgency=OVERVIEW)

    @server.feature(types.WORKSPACE_SYMBOL)
    async def survey(params: types.WorkspaceSymbolParams) -> list[types.WorkspaceSymbol]:
        return await server.work(lambda: answers.survey(params.query), [], OVERVIEW)


def _names(server: Server, answers: Answers) -> None:
    _answer(server, types.TEXT_DOCUMENT_DEFINITION, answers.definition)
    _answer(server, types.TEXT_DOCUMENT_REFERENCES, answers.references)
    _answer(server, types.TEXT_DOCUMENT_DOCUMENT_HIGHLIGHT, answers.highlights)
    _answer(server, types.TEXT_DOCUMENT_PREPARE_RENAME, answers.prepared)

    @server.feature(types.TEXT_DOCUMENT_RENAME, types.RenameOptions(prepare_provider=True))
    async def rename(params: types.RenameParams) -> types.WorkspaceEdit | None:
        uri = params.text_document.uri
        found = await server.ask(uri, lambda buffer: answers.rename(buffer, params), None)
        if isinstance(found, Refused):
            raise JsonRpcInvalidParams(re.sub(r"\s+", " ", str(found)))
        return found

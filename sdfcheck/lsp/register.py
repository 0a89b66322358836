"""Ties the requests of the protocol to their answers."""

from __future__ import annotations

import re
from collections.abc import Callable
from functools import cache
from typing import TYPE_CHECKING, Any, TypeVar

from lsprotocol import types
from pygls.exceptions import JsonRpcInvalidParams

from sdfcheck.lsp.answers import FIX_ALL, Answers
from sdfcheck.lsp.edits import EXTRACT, MOVABLE, Edits, Impossible
from sdfcheck.lsp.hints import KINDS
from sdfcheck.lsp.rename import Refused
from sdfcheck.lsp.server import Server
from sdfcheck.lsp.speech import path_of, plain
from sdfcheck.lsp.watch import FileWatch
from sdfcheck.lsp.worker import ANSWER, LINT, OUTLINE, OVERVIEW
from sdfcheck.lsp.workspace import Buffer
from sdfcheck.source.record import NamedTuple

if TYPE_CHECKING:
    from sdfcheck.lsp.beside import Beside

T = TypeVar("T")

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
    watch = FileWatch(server)
    _texts(server, watch)
    _diagnostics(server, answers)
    _knowledge(server, answers)
    _names(server, answers)
    _decorations(server, answers)
    _edits(server, answers.edits)
    _commands(server, answers.edits)
    _beside(server)
    return server


def _texts(server: Server, watch: FileWatch) -> None:
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

    @server.feature(types.WORKSPACE_DID_CHANGE_WORKSPACE_FOLDERS)
    async def turned(params: types.DidChangeWorkspaceFoldersParams) -> None:
        folders = params.event
        added, removed = ([path_of(each.uri) for each in some] for some in (folders.added, folders.removed))
        await watch.turned_to(added, removed)

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
        inter_file_dependencies=True, workspace_diagnostics=True, identifier="sdfcheck"
    )

    @server.feature(types.TEXT_DOCUMENT_DIAGNOSTIC, options)
    async def diagnostics(
        params: types.DocumentDiagnosticParams,
    ) -> types.RelatedFullDocumentDiagnosticReport:
        found = await server.pulled(params.text_document.uri)
        return types.RelatedFullDocumentDiagnosticReport(items=found)

    @server.feature(types.WORKSPACE_DIAGNOSTIC)
    async def swept(params: types.WorkspaceDiagnosticParams) -> types.WorkspaceDiagnosticReport:
        return await server.swept(params)

    kinds = [types.CodeActionKind.QuickFix, FIX_ALL, EXTRACT]
    _answer(
        server,
        types.TEXT_DOCUMENT_CODE_ACTION,
        answers.actions,
        types.CodeActionOptions(code_action_kinds=kinds, resolve_provider=True),
        otherwise=[],
        urgency=LINT,
    )

    @server.feature(types.CODE_ACTION_RESOLVE)
    async def resolve(action: types.CodeAction) -> types.CodeAction:
        uri = str(plain(action.data)["uri"])
        return await _possible(server, uri, lambda buffer: answers.resolved(buffer, action), action)


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
    _answer(server, types.TEXT_DOCUMENT_DOCUMENT_SYMBOL, answers.symbols, otherwise=[], urgency=OUTLINE)
    for feature, answer in (
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

    async def asked(params: Any, answer: Callable[[Buffer, Any], Any]) -> Any:
        found = await server.ask(params.text_document.uri, lambda buffer: answer(buffer, params), None)
        if isinstance(found, Refused):
            raise JsonRpcInvalidParams(re.sub(r"\s+", " ", str(found)))
        return found

    @server.feature(types.TEXT_DOCUMENT_PREPARE_RENAME)
    async def prepare(params: types.PrepareRenameParams) -> Any:
        return await asked(params, answers.prepared)

    @server.feature(types.TEXT_DOCUMENT_RENAME, types.RenameOptions(prepare_provider=True))
    async def rename(params: types.RenameParams) -> Any:
        return await asked(params, answers.rename)


async def _possible(server: Server, uri: str, answer: Callable[[Buffer], T], otherwise: T) -> T:
    """The answer about a text, or a refusal with its reason."""

    refused: list[str] = []

    def job(buffer: Buffer) -> T:
        try:
            return answer(buffer)
        except Impossible as reason:
            refused.append(str(reason))
            return otherwise

    found = await server.ask(uri, job, otherwise)
    if refused:
        raise JsonRpcInvalidParams(re.sub(r"\s+", " ", refused[0]))
    return found


def _edits(server: Server, edits: Edits) -> None:
    _answer(server, types.TEXT_DOCUMENT_LINKED_EDITING_RANGE, edits.linked)
    _answer(server, types.TEXT_DOCUMENT_SELECTION_RANGE, edits.selections)
    triggers = types.SignatureHelpOptions(trigger_characters=[" "], retrigger_characters=['"', "'"])
    _answer(server, types.TEXT_DOCUMENT_SIGNATURE_HELP, edits.signature, triggers)
    _answer(server, types.TEXT_DOCUMENT_DOCUMENT_COLOR, edits.colors, otherwise=[], urgency=OVERVIEW)
    _answer(server, types.TEXT_DOCUMENT_COLOR_PRESENTATION, edits.presentations, otherwise=[])
    lens_options = types.CodeLensOptions(resolve_provider=True)
    _answer(server, types.TEXT_DOCUMENT_CODE_LENS, edits.lenses, lens_options, otherwise=[], urgency=OVERVIEW)

    @server.feature(types.CODE_LENS_RESOLVE)
    async def resolve(lens: types.CodeLens) -> types.CodeLens:
        uri = str(plain(lens.data)["uri"])
        return await server.ask(uri, lambda buffer: edits.counted(buffer, lens), lens, OVERVIEW)

    @server.feature(types.TEXT_DOCUMENT_FORMATTING)
    async def formatted(params: types.DocumentFormattingParams) -> list[types.TextEdit]:
        uri = params.text_document.uri
        try:
            return await _possible(server, uri, lambda buffer: edits.formatted(buffer, params), [])
        except JsonRpcInvalidParams as refusal:
            server.show(f"sdfcheck: not formatted: {refusal.message}", types.MessageType.Info)
            return []

    files = types.FileOperationPattern(MOVABLE, matches=types.FileOperationPatternKind.File)
    folders = types.FileOperationPattern("**", matches=types.FileOperationPatternKind.Folder)
    moves = types.FileOperationRegistrationOptions(
        [types.FileOperationFilter(pattern, scheme="file") for pattern in (files, folders)]
    )

    @server.feature(types.WORKSPACE_WILL_RENAME_FILES, moves)
    async def moved(params: types.RenameFilesParams) -> types.WorkspaceEdit | None:
        return await server.work(lambda: edits.moved(params.files), None)


def _commands(server: Server, edits: Edits) -> None:
    """Commands take one object: the ``uri`` of an open text, ``arguments`` for xacro, and what is their own."""

    @server.command("sdfcheck.expand")
    async def expand(*given: Any) -> Any:
        wanted = _wanted(given)
        return await _possible(server, wanted.uri, lambda text: edits.expanded(text, wanted.arguments), None)

    @server.command("sdfcheck.convert")
    async def convert(*given: Any) -> Any:
        wanted = _wanted(given)
        return await _possible(
            server, wanted.uri, lambda text: edits.converted(text, wanted.to, wanted.arguments), None
        )


def _beside(server: Server) -> None:
    """Commands about the robot beside its text; they take one object with the ``uri`` of the text."""

    @cache
    def beside() -> Beside:
        """The robots that are shown; the modules that draw them are loaded with the first."""
        from sdfcheck.lsp.beside import Beside

        return Beside(server)

    @server.command("sdfcheck.showRobot")
    async def show(*given: Any) -> str:
        """The address of a page that shows the robot, which the client opens unless ``open`` is false."""
        address = await beside().show(_wanted(given).uri)
        is_wanted = not isinstance(plain(given[0]), dict) or plain(given[0]).get("open") is not False
        if is_wanted and server.speech.is_able("window", "show_document", "support"):
            await server.window_show_document_async(types.ShowDocumentParams(address, external=True))
        return address

    @server.command("sdfcheck.robotPage")
    async def page(*given: Any) -> Any:
        """The page itself, for a client that shows it and passes on the messages of :data:`beside.NEWS`."""
        return await beside().page(_wanted(given).uri)

    @server.command("sdfcheck.robotSay")
    async def say(*given: Any) -> Any:
        """A ``message`` of a page that the client shows; the place to which it wants to lead."""
        return await beside().said(_wanted(given).uri, plain(given[0]).get("message"))

    @server.command("sdfcheck.cursor")
    async def cursor(*given: Any) -> None:
        """The ``position`` of the cursor."""
        place = plain(given[0]).get("position") or {}
        position = types.Position(int(place.get("line", 0)), int(place.get("character", 0)))
        await beside().cursor(_wanted(given).uri, position)


class _Wanted(NamedTuple):
    """The text that a command is about, and how it is wanted."""

    uri: str
    arguments: dict[str, str]
    to: str


def _wanted(given: tuple[Any, ...]) -> _Wanted:
    first = plain(given[0]) if given else {}
    if not isinstance(first, dict):
        first = {"uri": first}
    arguments = first.get("arguments")
    own = {str(name): str(value) for name, value in arguments.items()} if isinstance(arguments, dict) else {}
    return _Wanted(str(first.get("uri", "")), own, str(first.get("to") or ""))

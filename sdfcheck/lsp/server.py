"""The language server: what the client sends, in order, and what it is sent without asking."""

from __future__ import annotations

import asyncio
import inspect
import json
import os
import time
import traceback
from collections.abc import Callable, Iterator
from contextlib import suppress
from functools import partial
from pathlib import Path
from typing import Any, TypeVar

from lsprotocol import types
from pygls.exceptions import (
    FeatureRequestError,
    JsonRpcException,
    JsonRpcInvalidParams,
    JsonRpcMethodNotFound,
)
from pygls.lsp.server import LanguageServer
from pygls.protocol import LanguageServerProtocol, lsp_method
from pygls.uris import from_fs_path

from sdfcheck.files.discover import discover
from sdfcheck.files.regular import MEGABYTE, read_regular
from sdfcheck.lint.diagnostic import Diagnostic
from sdfcheck.lint.one_file import Selected, lint_file
from sdfcheck.lsp.completion import complete
from sdfcheck.lsp.cursor import at
from sdfcheck.lsp.findings import Findings
from sdfcheck.lsp.hover import hover
from sdfcheck.lsp.names import occurrences
from sdfcheck.lsp.speech import NAME, ProtocolTypes, Units, Written, changed, path_of
from sdfcheck.lsp.worker import ANSWER, LINT, SURVEY, Schedule, Worker
from sdfcheck.lsp.workspace import Buffer, Choices, LiveCaches, Outdated, Workspace
from sdfcheck.release import __version__
from sdfcheck.source.errors import REPORT_IT, WrongUsage
from sdfcheck.source.record import NamedTuple
from sdfcheck.source.sniff import HEAD, Treatment, sniff, treatment

# The diagnostics of the files of a workspace that nobody has opened.


MOST_FILES = 1_000
"""So many files of a workspace are linted, no more."""
LARGEST = MEGABYTE
"""Answers wait while a file is linted: larger ones are linted when they are opened."""


class Swept(NamedTuple):
    """The diagnostics of a file, and the state of the disk and of the workspace in which they were found."""

    state: tuple[int, int, int]
    found: tuple[Diagnostic, ...]

    @property
    def id(self) -> str:
        """Another one says that there may be other diagnostics."""
        return "-".join(map(str, self.state))


class Sweep:
    """The files of the workspace with their diagnostics, each linted once for each of its states."""

    def __init__(self, workspace: Workspace) -> None:
        self.workspace = workspace
        self._known: dict[str, Swept] = {}
        self._caches: LiveCaches | None = None
        """Of its own: the files that it comes upon are not those that open texts include."""
        self._generation = -1

    def paths(self) -> list[Path]:
        """The descriptions in the folders of the workspace that are not open."""
        return list(self._paths())

    def _paths(self) -> Iterator[Path]:
        workspace, seen = self.workspace, set(self.workspace.buffers)
        for folder in workspace.folders:
            if not os.path.isdir(folder):
                continue
            files = discover([folder], exclude=lambda each: workspace.settings_for(each).excludes(each)).files
            for file in files:
                key = workspace.key(file.path)
                if key not in seen and len(seen) < MOST_FILES:
                    seen.add(key)
                    yield file.path

    def rest(self) -> None:
        """Give up what is only needed while files are linted."""
        if self._caches is not None:
            self._caches.close()
        self._caches = None

    def lint(self, path: Path) -> Swept:
        """The diagnostics in a file, as it is on disk; those about files that it includes are theirs."""
        key = self.workspace.key(path)
        state = self._state(path)
        known = self._known.get(key)
        if known is None or known.state != state:
            known = self._known[key] = Swept(state, tuple(self._found(path, key)))
        return known

    def _state(self, path: Path) -> tuple[int, int, int]:
        try:
            status = os.stat(path)
        except OSError:
            return 0, 0, self.workspace.generation
        return status.st_mtime_ns, status.st_size, self.workspace.generation

    def _found(self, path: Path, key: str) -> Iterator[Diagnostic]:
        workspace = self.workspace
        try:
            data = read_regular(path, LARGEST)
        except OSError:
            return
        kind = sniff(data[:HEAD], path)
        if treatment(kind, path, named=False) is not Treatment.LINT:
            return
        try:
            settings = workspace.settings_for(path)
            found, _ = lint_file(Selected(path, data, kind), workspace.book, settings, self._current())
        except WrongUsage as error:
            workspace.fault = str(error)
            return
        yield from (each for each in found if workspace.key(each.span.source.path) == key)

    def _current(self) -> LiveCaches:
        if self._caches is None or self._generation != self.workspace.generation:
            self.rest()
            workspace = self.workspace
            self._caches = LiveCaches(
                workspace.buffers, workspace.aside, expand=workspace.choices.expand, named=workspace.folders
            )
            self._generation = self.workspace.generation
        return self._caches


T = TypeVar("T")
_LONGEST = 300
"""So many characters of a problem with a message are logged."""

Report = types.WorkspaceFullDocumentDiagnosticReport | types.WorkspaceUnchangedDocumentDiagnosticReport

_PAUSE, _PATIENCE = 2.0, 30
"""A request for the diagnostics of files that are not open waits so many pauses, in s, for news."""

_STEP, _REST = 0.01, 0.2
"""A text rests when it has been still for so long, in s, as is seen step by step: then all of it is looked at, or the
robot with all arguments. Before a look at a change that takes long a part of that is waited for: answers would wait.
"""


class Protocol(LanguageServerProtocol):
    """Leaves the texts to the server, which counts lines and columns as the protocol does."""

    def structure_message(self, data: dict[str, Any]) -> Any:
        """The messages of the client; a request that cannot be read is answered, too."""
        if data.get("method") == types.TEXT_DOCUMENT_CODE_ACTION and "jsonrpc" in data:
            data = {**data, "params": _without_diagnostics(data.get("params"))}
        is_request = "jsonrpc" in data and "id" in data and "method" in data
        try:
            message = super().structure_message(data)
            if is_request and not hasattr(message, "id"):  # of a method that is only noticed
                raise JsonRpcMethodNotFound.of(data["method"])
        except JsonRpcException as error:
            answer = error if isinstance(error, JsonRpcMethodNotFound) else JsonRpcInvalidParams()
            if is_request:
                self._send_response(data["id"], None, answer.to_response_error())
            raise
        return message

    def _execute_handler(self, msg_id: Any, *rest: Any, **named: Any) -> None:
        """Begin to handle a message; the library keeps what handles a notification for good."""
        super()._execute_handler(msg_id, *rest, **named)
        if (future := self._request_futures.get(msg_id)) is not None:
            future.add_done_callback(lambda _: self._forget(msg_id))

    def _forget(self, msg_id: Any) -> None:
        """Forget a message, but not at once: the library goes through all of them when it ends, and cancels each."""
        with suppress(RuntimeError):  # the loop has ended
            asyncio.get_running_loop().call_soon(self._request_futures.pop, msg_id, None)

    def _send_response(self, msg_id: Any, result: Any = None, error: Any = None) -> None:
        """Answer a request; what is written already is sent as it is."""
        if error is not None or not isinstance(result, Written):
            super()._send_response(msg_id, result, error)
            return
        self._result_types.pop(msg_id, None)
        body = f'{{"jsonrpc":"2.0","id":{json.dumps(msg_id)},"result":{result.text}}}'.encode(self.CHARSET)
        head = f"Content-Length: {len(body)}\r\nContent-Type: {self.CONTENT_TYPE}; charset={self.CHARSET}\r\n\r\n"
        sent = self.writer.write(head.encode() + body) if self.writer is not None else None
        if inspect.isawaitable(sent):
            self._sent = asyncio.ensure_future(sent)

    @lsp_method(types.TEXT_DOCUMENT_DID_OPEN)
    def lsp_text_document__did_open(self, params: types.DidOpenTextDocumentParams) -> Iterator[Any]:
        yield self.fm.features[types.TEXT_DOCUMENT_DID_OPEN], (params,), None

    @lsp_method(types.TEXT_DOCUMENT_DID_CHANGE)
    def lsp_text_document__did_change(self, params: types.DidChangeTextDocumentParams) -> Iterator[Any]:
        yield self.fm.features[types.TEXT_DOCUMENT_DID_CHANGE], (params,), None

    @lsp_method(types.TEXT_DOCUMENT_DID_CLOSE)
    def lsp_text_document__did_close(self, params: types.DidCloseTextDocumentParams) -> Iterator[Any]:
        yield self.fm.features[types.TEXT_DOCUMENT_DID_CLOSE], (params,), None


def _without_diagnostics(params: Any) -> Any:
    """The parameters of a request for actions without diagnostics, which some clients send in another form."""
    if not isinstance(params, dict):
        return params
    context = params.get("context")
    kinds = context.get("only") if isinstance(context, dict) else None
    return {**params, "context": {"diagnostics": [], **({"only": kinds} if isinstance(kinds, list) else {})}}


class Server(LanguageServer):
    """One session with one client.

    Everything about documents is done in the worker's thread, everything that is sent in
    the thread of the event loop.
    """

    def __init__(self) -> None:
        super().__init__(NAME, __version__, protocol_cls=Protocol)
        self.worker = Worker()
        self.robots = Workspace(self.worker)
        self.findings = Findings(self.robots)
        self.speech = ProtocolTypes(self.robots)
        self.sweep = Sweep(self.robots)
        self.followers: list[Callable[[str], None]] = []
        """Called with the key of a text that has changed and was linted, or was closed."""
        self.endings: list[Callable[[], None]] = []
        self.lints = Schedule(self._lint)
        self.open: dict[str, str] = {}
        """Open URI → key of the text."""
        self._edits: dict[str, int] = {}
        self._took: dict[str, float] = {}
        """Key of a text → how long the last look at a change took, in s."""
        self._published: dict[str, list[types.Diagnostic]] = {}
        self._pulled: dict[str, tuple[int | None, list[types.Diagnostic]]] = {}
        """Open URI → how often its text had changed when the client asked last, and the answer."""
        self._seen = 0
        """The generation of documents that hints and colors at the client are of."""
        self._reported: set[str] = set()
        self._fault = ""
        self._is_primed = False
        self.is_finished = False
        """Did the client end the session as it should?"""

    # Work

    async def work(self, job: Callable[[], T], otherwise: T, urgency: int = ANSWER) -> T:
        """The result of a job on documents; where it fails, that is reported, and the session goes on."""

        def current() -> T:
            try:
                return job()
            except Outdated:  # and all that it holds, which is much
                return otherwise

        try:
            return await self.worker.run(current, urgency)
        except Exception as error:
            self.report(error)
            return otherwise

    async def ask(self, uri: str, answer: Callable[[Buffer], T], otherwise: T, urgency: int = ANSWER) -> T:
        """The answers about an open text."""

        def job() -> T:
            buffer = self.robots.buffers.get(self.robots.key(path_of(uri)))
            if buffer is None:
                return otherwise
            with self.robots.looking_at(buffer.path):
                return answer(buffer)

        return await self.work(job, otherwise, urgency)

    def report(self, error: BaseException) -> None:
        """Write a failure to the log; show it to the person once."""
        story = "".join(traceback.format_exception(error))
        self.window_log_message(types.LogMessageParams(types.MessageType.Error, story))
        words = f"{type(error).__name__}: {error}"
        if words not in self._reported:
            self._reported.add(words)
            self.show(f"sdfcheck: internal error: {' '.join(words.split())} ({REPORT_IT})")

    def report_server_error(self, error: Exception, source: Any) -> None:
        """Errors outside of the work on documents; refusals are answers, and what cannot be read is the client's."""
        if source is JsonRpcException:
            words = " ".join(f"a message of the client cannot be read: {error.__cause__ or error}".split())
            self.window_log_message(types.LogMessageParams(types.MessageType.Warning, words[:_LONGEST]))
        elif source is not FeatureRequestError or not isinstance(error, JsonRpcException):
            self.report(error.__cause__ or error)

    def show(self, text: str, kind: types.MessageType = types.MessageType.Error) -> None:
        """Show a message to the person."""
        self.window_show_message(types.ShowMessageParams(kind, text))

    # Texts

    async def opened(self, params: types.DidOpenTextDocumentParams) -> None:
        given = params.text_document
        path = path_of(given.uri)
        self.open[given.uri] = key = self.robots.key(path)
        self._edits[key] = self._edits.get(key, 0) + 1
        await self.work(lambda: self.robots.open(given.uri, path, given.text, given.version), None)
        self._relint(key)

    async def changed(self, params: types.DidChangeTextDocumentParams) -> None:
        uri, version = params.text_document.uri, params.text_document.version
        key = self.open.get(uri)
        if key is None:
            return
        self._edits[key] += 1
        changes = self.speech.changes(params.content_changes)

        def job() -> bool:
            buffer = self.robots.buffers[key]
            is_shared = self.robots.is_referred_to(buffer.path)
            source, kept = changed(buffer.source, changes, self.speech.units)
            self.robots.write(buffer, source, version, kept)
            return is_shared

        is_shared = await self.work(job, False)
        self.lints.note(key)
        if is_shared:
            self._relint(key)

    async def closed(self, params: types.DidCloseTextDocumentParams) -> None:
        uri = params.text_document.uri
        key = self.open.pop(uri, None)
        if key is None or key in self.open.values():
            return  # never opened, or open by another address
        self._edits.pop(key, None)
        self._took.pop(key, None)
        self._pulled.pop(uri, None)
        self.lints.drop(key)
        path = path_of(uri)

        def job() -> None:
            self.robots.drop(path)
            self.findings.forget(path)

        await self.work(job, None)
        await self._update_client()
        self._follow(key)

    async def refreshed(self, job: Callable[[], None]) -> None:
        """Files, configuration or settings have changed: do what that takes, and lint all again."""
        await self.work(job, None)
        self._relint()

    def _relint(self, first: str = "") -> None:
        """Lint all open texts, one before the others."""
        for key in sorted(set(self.open.values()), key=lambda each: each != first):
            self.lints.note(key)

    def _follow(self, key: str) -> None:
        for follow in self.followers:
            follow(key)

    # Diagnostics

    @property
    def is_pulled(self) -> bool:
        """Does the client ask for the diagnostics of what is open?"""
        return self.speech.is_able("text_document", "diagnostic")

    @property
    def _may_refresh(self) -> bool:
        """May the client be asked to ask again?"""
        return self.speech.is_able("workspace", "diagnostics", "refresh_support")

    async def _lint(self, key: str) -> None:
        number = self._edits.get(key)

        def job(look: Callable[[Buffer], T]) -> T | None:
            buffer = self.robots.buffers.get(key)
            return None if buffer is None else look(buffer)

        if not await self._is_still(key, min(self._took.get(key, 0.0) / 2, _REST)):
            return
        begun = time.monotonic()
        is_glance = await self.work(lambda: job(self.findings.glance), None, LINT)
        if not is_glance:
            await self.work(lambda: job(self.findings.lint), None, LINT)
        self._took[key] = time.monotonic() - begun
        if is_glance:
            await self._update_client()
            if not await self._is_still(key, _REST):
                return
            await self.work(lambda: job(self.findings.lint), None, LINT)
        if self._edits.get(key) == number:  # else another run follows, and this one is stale
            await self._update_client()
            self._follow(key)
            await self._survey(key)
            await self.work(lambda: self._prime(key, number), None, SURVEY)

    async def _is_still(self, key: str, seconds: float) -> bool:
        """Wait a while; does a text stay as it is?"""
        number = self._edits.get(key)
        for _ in range(int(seconds / _STEP)):
            await asyncio.sleep(_STEP)
            if self._edits.get(key) != number:
                return False
        return True

    def _prime(self, key: str, number: int | None) -> None:
        """Compute, while no request waits, the views that requests about a text need, and drop the others."""
        buffer = self.robots.buffers.get(key)
        if buffer is None or self._edits.get(key) != number:
            return
        buffer.tidy()
        document, text = self.robots.document(buffer.path), buffer.source.text
        if document is None:
            return
        with self.robots.looking_at(buffer.path):
            at(document, len(text))
            self.robots.pause()
            names = occurrences(document).all
            self.robots.pause()
        buffer.checkpoints.around(text, len(text))
        if names and not self._is_primed:
            hover(document, names[0].span.start)
            complete(self.robots, buffer, names[-1].span.start)
        self._is_primed = True

    async def _survey(self, key: str) -> None:
        """Look at files that are not open and use this one, one at a time: what they bring out is shown here, too."""
        number = self._edits.get(key)

        def job() -> list[Path]:
            buffer = self.robots.buffers.get(key)
            return [] if buffer is None else self.findings.includers(buffer)

        nothing: list[Path] = []
        roots = await self.work(job, nothing, LINT)
        for root in roots:
            if self._edits.get(key) == number:
                await self.work(partial(self.findings.lint_from_disk, root), None, SURVEY)
        if roots:
            await self._update_client()

    async def _update_client(self) -> None:
        """Bring the client up to date after a change of state: send the diagnostics that it does not ask for, and
        let it ask again for what has changed without an edit of its own.
        """

        def job() -> dict[str, tuple[list[types.Diagnostic], int | None]]:
            shown: dict[str, tuple[list[types.Diagnostic], int | None]] = {}
            for buffer in self.robots.buffers.values():
                shown[buffer.uri] = [], buffer.version
            for key, found in self.findings.all().items():
                known = self.robots.buffers.get(key)
                sent = list(map(self.speech.diagnostic, found))
                shown[self.speech.uri(Path(key))] = sent, None if known is None else known.version
            return shown

        shown = await self.work(job, None)
        if shown is None:
            return
        for uri in self._published.keys() - shown.keys():
            shown[uri] = [], None
        stale = [
            uri
            for uri, (number, found) in self._pulled.items()
            if uri in shown and number == self._edits.get(self.open.get(uri, "")) and found != shown[uri][0]
        ]
        for uri, (found, version) in sorted(shown.items(), key=lambda item: item[0]):
            sent = [] if self.is_pulled and uri in self.open else found
            if self._published.get(uri) != sent and (sent or uri in self._published or uri in self.open):
                params = types.PublishDiagnosticsParams(uri, sent, version)
                self.text_document_publish_diagnostics(params)
            if sent or uri in self.open:
                self._published[uri] = sent
            else:
                self._published.pop(uri, None)
        for uri in stale:
            del self._pulled[uri]  # it is asked for again
        self._refresh(is_stale=bool(stale))
        self._report_fault()

    def _refresh(self, *, is_stale: bool) -> None:
        """Ask the client to ask again, as far as it takes that."""
        if is_stale and self._may_refresh:
            self.workspace_diagnostic_refresh(None)
        if self._seen == self.robots.generation:
            return
        self._seen = self.robots.generation
        if self.speech.is_able("workspace", "inlay_hint", "refresh_support"):
            self.workspace_inlay_hint_refresh(None)
        if self.speech.is_able("workspace", "semantic_tokens", "refresh_support"):
            self.workspace_semantic_tokens_refresh(None)

    def _report_fault(self) -> None:
        """Show what is wrong with the configuration, once for each fault."""
        fault = self.robots.fault
        if fault and fault != self._fault:
            self.show(f"sdfcheck: {fault}", types.MessageType.Warning)
        self._fault = fault

    async def pulled(self, uri: str) -> list[types.Diagnostic]:
        """The diagnostics of an open text, as it is now."""

        def answer(buffer: Buffer) -> list[types.Diagnostic]:
            with suppress(Outdated):  # what is left is asked for again
                if not (self._may_refresh and self.findings.glance(buffer)):
                    self.findings.lint(buffer)
            return list(map(self.speech.diagnostic, self.findings.at(buffer.path)))

        number = self._edits.get(self.open.get(uri, ""))
        nothing: list[types.Diagnostic] = []
        found = await self.ask(uri, answer, nothing, LINT)
        self._pulled[uri] = number, found
        return found

    async def swept(self, params: types.WorkspaceDiagnosticParams) -> types.WorkspaceDiagnosticReport:
        """The diagnostics of files that are not open; waits a while where none of them has changed."""
        before = {each.uri: each.value for each in params.previous_result_ids}
        generation = self.robots.generation
        reports = await self._sweep(before)
        if not reports:
            await self._quiet_after(generation)
            reports = await self._sweep(before)
        return types.WorkspaceDiagnosticReport(reports)

    async def _quiet_after(self, generation: int) -> None:
        """Wait until a document has changed and then none has for a while, or for long enough."""
        for _ in range(_PATIENCE):
            last = self.robots.generation
            await asyncio.sleep(_PAUSE)
            if generation != last == self.robots.generation:
                return

    async def _sweep(self, before: dict[str, str]) -> list[Report]:
        """The reports that differ from those that a client has."""
        nothing: list[Path] = []
        paths = await self.work(self.sweep.paths, nothing, SURVEY) if self.robots.choices.sweep else nothing
        reports: list[Report] = []
        gone = dict(before)
        for path in paths:
            uri = from_fs_path(str(path.absolute())) or ""
            gone.pop(uri, None)
            report = await self.work(partial(self._swept, path, uri, before.get(uri)), None, SURVEY)
            if report is not None:
                reports.append(report)
        await self.work(self.sweep.rest, None, SURVEY)
        return [*reports, *(types.WorkspaceFullDocumentDiagnosticReport(uri, []) for uri in sorted(gone))]

    def _swept(self, path: Path, uri: str, before: str | None) -> Report | None:
        """The report about a file; None where the client has it."""
        swept = self.sweep.lint(path)
        own = {(each.code, str(each.range)) for each in self._published.get(uri, ())}
        found = [self.speech.diagnostic(each) for each in swept.found]
        items = [each for each in found if (each.code, str(each.range)) not in own]
        state = f"{swept.id}-{len(items)}"
        if state == before or (before is None and not items):
            return None
        return types.WorkspaceFullDocumentDiagnosticReport(uri, items, result_id=state)

    # The session

    def began(self, params: types.InitializeParams) -> None:
        """Note the abilities and settings of the client."""
        self.speech.client = params.capabilities
        encodings = self.speech.client.general.position_encodings if self.speech.client.general else None
        known = {units.value: units for units in Units}
        for name in encodings or ():
            if str(getattr(name, "value", name)) in known:
                self.speech.units = known[str(getattr(name, "value", name))]
                break
        folders = [path_of(folder.uri) for folder in params.workspace_folders or ()]
        if not folders and params.root_uri:
            folders = [path_of(params.root_uri)]
        self.robots.surround(tuple(folders))

    async def chosen(self, choices: Choices) -> None:
        """Take other settings."""

        def job() -> None:
            self.robots.caches.close()
            self.robots.choose(choices)

        await self.refreshed(job)

    def ended(self) -> None:
        """Stop the threads beside the server."""
        self.is_finished = True
        for end in self.endings:
            end()
        self.robots.close()
        self.worker.close()

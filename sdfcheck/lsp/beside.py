"""The robot beside its text: it follows while somebody types, and each leads to the other."""

from __future__ import annotations

import asyncio
import base64
import json
import queue
import secrets
import threading
from collections.abc import Callable, Mapping
from contextlib import suppress
from functools import partial
from hashlib import sha256
from http import HTTPStatus
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path
from typing import Any

from lsprotocol import types

from sdfcheck.lint.diagnostic import Diagnostic
from sdfcheck.lsp.actions import Robot, robot_of
from sdfcheck.lsp.cursor import elements
from sdfcheck.lsp.server import Server
from sdfcheck.lsp.speech import ProtocolTypes, path_of, plain
from sdfcheck.lsp.worker import SURVEY, Schedule
from sdfcheck.lsp.workspace import Buffer, Workspace
from sdfcheck.source.document import Document
from sdfcheck.source.errors import DescriptionError, WrongUsage
from sdfcheck.source.record import NamedTuple
from sdfcheck.source.sniff import Kind
from sdfcheck.source.text import Source, Span
from sdfcheck.view.meshes import Json, Meshes
from sdfcheck.view.notes import Parts, findings
from sdfcheck.view.page import live_page, live_policy
from sdfcheck.view.scene import MOST_SHAPES, scene

# Pages on a port of this computer, for those who know their address: a server for a browser beside the
# editor.
#
# Source of the checks: other pages in the same browser can send requests to any port (so the address holds a
# secret, and ``Origin`` is looked at), and names that lead here by DNS rebinding show in ``Host``.


HOST = "127.0.0.1"
MOST_BYTES = 64_000
"""So long is a message of a page at most."""
MOST_LISTENERS = 16
_WAITING = 200
"""So many messages wait for a page that does not take them; then it has to connect again."""
_HEARTBEAT = 10.0
"""s"""


class Page(NamedTuple):
    """A page: its text, its policy, its first messages for who connects, and what takes its messages."""

    html: str
    policy: str
    begin: Callable[[], list[str]]
    take: Callable[[Any], None]


class Loopback:
    """The server; it starts with its first page, and ends with :meth:`close`."""

    def __init__(self) -> None:
        self._pages: dict[str, Page] = {}
        self._secrets: dict[str, str] = {}
        self._listeners: dict[str, list[queue.Queue[str | None]]] = {}
        self._lock = threading.Lock()
        self._server: ThreadingHTTPServer | None = None

    @property
    def port(self) -> int:
        """The port; 0 before the first page."""
        return 0 if self._server is None else int(self._server.server_address[1])

    def show(self, name: str, page: Page) -> str:
        """The address of a page, which is its own as long as the server lives."""
        if self._server is None:
            self._server = ThreadingHTTPServer((HOST, 0), _handler(self))
            self._server.daemon_threads = True
            threading.Thread(target=self._server.serve_forever, name="pages", daemon=True).start()
        with self._lock:
            secret = self._secrets.setdefault(name, secrets.token_urlsafe(32))
            self._pages[secret] = page
        return f"http://{HOST}:{self.port}/{secret}/"

    def send(self, name: str, message: str) -> None:
        """Send a message, JSON in one line, to all who look at a page."""
        with self._lock:
            for listener in self._listeners.get(self._secrets.get(name, ""), ()):
                if listener.full():
                    _end(listener)
                else:
                    listener.put_nowait(message)

    def close(self) -> None:
        """End, and close all connections."""
        with self._lock:
            for listeners in self._listeners.values():
                for listener in listeners:
                    _end(listener)
            self._pages.clear()
        if self._server is not None:
            threading.Thread(target=self._server.shutdown, daemon=True).start()
            self._server.server_close()

    # For the handler

    def page(self, secret: str) -> Page | None:
        with self._lock:
            known = [page for own, page in self._pages.items() if secrets.compare_digest(own, secret)]
        return known[0] if known else None

    def listen(self, secret: str) -> queue.Queue[str | None] | None:
        """The messages for a page from now on; None ends them. None where there are too many listeners."""
        with self._lock:
            known = self._listeners.setdefault(secret, [])
            if len(known) >= MOST_LISTENERS:
                return None
            known.append(queue.Queue(_WAITING))
            return known[-1]

    def leave(self, secret: str, listener: queue.Queue[str | None]) -> None:
        with self._lock:
            self._listeners[secret].remove(listener)


def _end(listener: queue.Queue[str | None]) -> None:
    """Let a listener end, whatever waits for it."""
    while listener.full():
        with suppress(queue.Empty):
            listener.get_nowait()
    listener.put_nowait(None)


def _handler(server: Loopback) -> type[BaseHTTPRequestHandler]:
    class Handler(_Handler):
        loopback = server

    return Handler


class _Handler(BaseHTTPRequestHandler):
    loopback: Loopback
    protocol_version = "HTTP/1.1"
    timeout = 60

    def log_message(self, format: str, *args: object) -> None:
        """Addresses are secrets: nothing is logged."""

    def do_GET(self) -> None:
        secret, _, rest = self.path.lstrip("/").partition("/")
        page = self._page(secret)
        if page is None:
            return
        if rest == "":
            self._answer(HTTPStatus.OK, page.html.encode(), "text/html; charset=utf-8", page.policy)
        elif rest == "events":
            self._events(secret, page)
        else:
            self._refuse(HTTPStatus.NOT_FOUND)

    def do_POST(self) -> None:
        secret, _, rest = self.path.lstrip("/").partition("/")
        page = self._page(secret)
        if page is None:
            return
        length = self.headers.get("Content-Length", "")
        if rest != "say" or self.headers.get_content_type() != "application/json":
            self._refuse(HTTPStatus.NOT_FOUND)
        elif not length.isdecimal() or int(length) > MOST_BYTES:
            self._refuse(HTTPStatus.REQUEST_ENTITY_TOO_LARGE)
        else:
            try:
                message = json.loads(self.rfile.read(int(length)))
            except (ValueError, RecursionError):
                self._refuse(HTTPStatus.BAD_REQUEST)
                return
            page.take(message)
            self._answer(HTTPStatus.NO_CONTENT)

    def _page(self, secret: str) -> Page | None:
        """The page of a request; None, and an answer, where it is not one of ours."""
        hosts = {f"{HOST}:{self.loopback.port}", f"localhost:{self.loopback.port}"}
        host, origin = self.headers.get("Host", ""), self.headers.get("Origin")
        is_own = host in hosts and origin in {None, f"http://{host}"}
        is_own = is_own and self.headers.get("Sec-Fetch-Site", "none") in {"none", "same-origin"}
        page = self.loopback.page(secret) if is_own and secret.isascii() else None
        if page is None:
            self._refuse(HTTPStatus.FORBIDDEN)
        return page

    def _refuse(self, status: HTTPStatus) -> None:
        self.close_connection = True
        self._answer(status, status.phrase.encode(), "text/plain")

    def _answer(self, status: HTTPStatus, body: bytes = b"", kind: str = "", policy: str = "") -> None:
        self._head(status, kind, policy)
        if status is not HTTPStatus.NO_CONTENT:
            self.send_header("Content-Length", str(len(body)))
        self.end_headers()
        self.wfile.write(body)

    def _head(self, status: HTTPStatus, kind: str, policy: str = "") -> None:
        self.send_response(status)
        if kind:
            self.send_header("Content-Type", kind)
        self.send_header("Content-Security-Policy", f"{policy or _NOTHING}; frame-ancestors 'none'")
        for name, value in _HEADERS.items():
            self.send_header(name, value)

    def version_string(self) -> str:
        return "sdfcheck"

    def _events(self, secret: str, page: Page) -> None:
        """Messages, one after another, until the page or the server goes."""
        listener = self.loopback.listen(secret)
        if listener is None:
            self._refuse(HTTPStatus.SERVICE_UNAVAILABLE)
            return
        self.close_connection = True
        try:
            self._head(HTTPStatus.OK, "text/event-stream")
            self.end_headers()
            waiting: list[str | None] = [*page.begin()]
            while True:
                for message in waiting:
                    if message is None:
                        return
                    self.wfile.write(b"data: %s\n\n" % message.encode() if message else b": still here\n\n")
                    self.wfile.flush()
                try:
                    waiting = [listener.get(timeout=_HEARTBEAT)]
                except queue.Empty:
                    waiting = [""]
        except OSError:
            return  # the page is gone
        finally:
            self.loopback.leave(secret, listener)


_NOTHING = "default-src 'none'"
_HEADERS = {
    "Cache-Control": "no-store",
    "Cross-Origin-Resource-Policy": "same-origin",
    "Referrer-Policy": "no-referrer",
    "X-Content-Type-Options": "nosniff",
    "X-Frame-Options": "DENY",
}


NEWS = "sdfcheck/robot"
"""The notification with which a client that shows the page itself gets what is for the page."""
LONGEST = 1.0
"""s: a robot that takes long to build waits for such a rest while somebody types."""
_TRUTH = ("true", "false")


class _Files(NamedTuple):
    """The meshes that were read, by path, time and size, so that they are read once."""

    entries: dict[tuple[str, int, int], dict[str, Any]]
    data: dict[str, Json]
    """Key of a mesh → its bytes in base64, and the files that give its colors."""

    def keep(self, keys: set[Any]) -> None:
        """Forget the others."""
        for key in self.data.keys() - keys:
            del self.data[key]
        for state in [state for state, entry in self.entries.items() if entry["key"] not in keys]:
            del self.entries[state]


class _LiveMeshes(Meshes):
    """The meshes of a scene, without their bytes: a page asks for those that it does not have."""

    def __init__(self, known: _Files) -> None:
        super().__init__()
        self._known = known

    def _entry(self, document: Document, uri: str, path: Path | None) -> dict[str, Any]:
        state = None
        if path is not None:
            try:
                status = path.stat()
                state = str(path), status.st_mtime_ns, status.st_size
            except OSError:
                pass
        if state is not None and state in self._known.entries:
            return self._known.entries[state]
        entry = super()._entry(document, uri, path)
        if "data" in entry:
            data = {"data": entry.pop("data"), "files": entry.pop("files", {})}
            entry["key"] = sha256(base64.b64decode(data["data"])).hexdigest()
            self._known.data[entry["key"]] = data
            if state is not None:
                self._known.entries[state] = entry
        return entry


class Shown:
    """A text whose robot is shown, with the last robot that could be built of it."""

    def __init__(self, uri: str) -> None:
        self.uri = uri
        self.arguments: dict[str, str] = {}
        self.is_in_editor = False
        self.robot: Robot | None = None
        self.parts: Parts | None = None
        self.found: tuple[Diagnostic, ...] = ()
        self.page = ""
        """The last robot, as JSON for the page."""
        self.note = ""
        self.files = _Files({}, {})

    @property
    def news(self) -> str:
        """The message with the robot; with nothing but the note where there is not even a text."""
        note = json.dumps(self.note)
        if not self.page:
            return f'{{"kind":"note","note":{note}}}'
        return f'{{"kind":"robot","note":{note},"page":{self.page}}}'


class Beside:
    """The robots that are shown beside their texts; what is about documents runs in the worker's thread."""

    def __init__(self, server: Server) -> None:
        self.server = server
        self.workspace: Workspace = server.robots
        self.speech: ProtocolTypes = server.speech
        self.pages = Loopback()
        self._shown: dict[str, Shown] = {}
        self._builds = Schedule(self._build_anew, LONGEST)
        server.followers.append(self.follow)
        server.endings.append(self.pages.close)

    # The session

    async def show(self, uri: str) -> str:
        """The address of the page that shows the robot of an open text."""
        loop = asyncio.get_running_loop()
        shown = await self._begin(uri)
        key = self.workspace.key(path_of(uri))

        def take(message: Any) -> None:
            asyncio.run_coroutine_threadsafe(self._said_by_page(uri, message), loop)

        html, policy = live_page(path_of(uri).name, "http"), live_policy("http")
        return self.pages.show(key, Page(html, policy, lambda: [shown.news], take))

    async def page(self, uri: str) -> dict[str, str]:
        """The page for a client that shows it itself, and passes the messages on."""
        shown = await self._begin(uri)
        shown.is_in_editor = True
        return {"html": live_page(path_of(uri).name, "editor")}

    async def _begin(self, uri: str) -> Shown:
        key = self.workspace.key(path_of(uri))
        if key not in self._shown:
            self._shown[key] = Shown(uri)
            await self._build_anew(key)
        return self._shown[key]

    def follow(self, key: str) -> None:
        """The text, or one that it includes, has changed and was linted: show its robot as it is now, soon."""
        if key in self._shown:
            self._builds.note(key)

    async def _build_anew(self, key: str) -> None:
        shown = self._shown[key]
        before = shown.news
        await self.server.work(lambda: self._build(shown, key), None, SURVEY)
        if shown.news != before:
            is_same = shown.page and shown.page in before
            note = json.dumps(shown.note)
            self._send(shown, f'{{"kind":"note","note":{note}}}' if is_same else shown.news)

    async def cursor(self, uri: str, position: types.Position) -> None:
        """The cursor of the editor is somewhere: mark the part there."""
        for shown in list(self._shown.values()):
            places = await self.server.ask(uri, partial(self._at, shown, position), None)
            if places is not None:
                self._send(shown, json.dumps({"kind": "cursor", "places": places}))

    async def said(self, uri: str, message: Any) -> types.Location | None:
        """Do what a page asks for; the place that a person wants to see."""
        key = self.workspace.key(path_of(uri))
        shown, word = self._shown.get(key), plain(message)
        if shown is None or not isinstance(word, dict):
            return None
        kind = word.get("kind")
        if kind == "ready":
            self._send(shown, shown.news)
        elif kind == "meshes":
            self._send_meshes(shown, word.get("keys"))
        elif kind == "arguments" and isinstance(values := word.get("values"), dict):
            shown.arguments |= {str(name): str(value) for name, value in values.items()}
            await self._build_anew(key)
        elif kind == "picked":
            span = await self.server.work(lambda: _place(shown, word), None)
            if span is not None:
                return self.speech.location(span)
        return None

    async def _said_by_page(self, uri: str, message: Any) -> None:
        """Do what a page in a browser asks for; the editor goes to the place that a person wants to see."""
        place = await self.said(uri, message)
        if place is not None and self.speech.is_able("window", "show_document", "support"):
            await self.server.window_show_document_async(
                types.ShowDocumentParams(place.uri, take_focus=True, selection=place.range)
            )

    def _send(self, shown: Shown, message: str) -> None:
        self.pages.send(self.workspace.key(path_of(shown.uri)), message)
        if shown.is_in_editor:
            self.server.protocol.notify(NEWS, {"uri": shown.uri, "message": json.loads(message)})

    def _send_meshes(self, shown: Shown, keys: Any) -> None:
        files = shown.files
        forms = {entry.get("key"): entry.get("format") for entry in files.entries.values()}
        for key in keys if isinstance(keys, list) else ():
            if isinstance(key, str) and key in files.data:
                mesh = {"kind": "mesh", "key": key, "format": forms.get(key), **files.data[key]}
                self._send(shown, json.dumps(mesh))

    # Documents

    def _build(self, shown: Shown, key: str) -> None:
        """Read the robot of a text; the last one stays where there is none."""
        buffer = self.workspace.buffers.get(key)
        if buffer is None:
            shown.note = "The text is closed; this is the last robot."
            return
        try:
            with self.workspace.looking_at(buffer.path):
                robot = robot_of(self.workspace, buffer, shown.arguments)
            fault = _fault(robot)
            if fault and shown.robot is not None:
                shown.note = f"{fault}; this is the robot from before."
                return
            page = self._page(shown, robot, buffer)
        except (WrongUsage, DescriptionError) as error:
            kept = "." if shown.robot is None else "; this is the robot from before."
            shown.note = f"{error}{kept}"
            if shown.robot is None:  # it may take other arguments to build one
                nothing = {"file": buffer.path.name, "models": [], "lights": [], "notes": []}
                shown.page = self._json(shown, buffer, nothing, [], [])
            return
        shown.robot, shown.page = robot, page
        shown.note = f"{fault}." if fault else ""

    def _page(self, shown: Shown, robot: Robot, buffer: Buffer) -> str:
        paths = {source.path for source in robot.files}
        every = (each for found in self.server.findings.all().values() for each in found)
        found = tuple(each for each in every if each.span.source.path in paths)
        meshes = _LiveMeshes(shown.files)
        drawn = scene(robot.document, meshes)
        shown.files.keep({entry.get("key") for entry in meshes.entries})
        shown.found, shown.parts = found, robot.document.view(Parts)
        return self._json(shown, buffer, drawn, meshes.entries, findings(found, robot.document))

    def _json(self, shown: Shown, buffer: Buffer, drawn: Json, meshes: list[Json], listed: list[Json]) -> str:
        return json.dumps(
            {
                "scenes": [drawn],
                "meshes": meshes,
                "findings": listed,
                "heading": "Findings",
                "differences": [],
                "mostShapes": MOST_SHAPES,
                "arguments": self._arguments(shown, buffer),
            }
        )

    def _arguments(self, shown: Shown, buffer: Buffer) -> list[dict[str, Any]]:
        """The arguments that a xacro file takes, itself and in what it includes, with their values."""
        document = self.workspace.document(buffer.path)
        if document is None or document.kind is not Kind.XACRO:
            return []
        from sdfcheck.xacro.static.definitions import taken_arguments, visible_definitions

        sets = self.workspace.settings_for(buffer.path).arguments_for(buffer.path)
        chosen = {**(dict(sets[0]) if sets else {}), **shown.arguments}
        defaults: dict[str, str] = {}
        for read in visible_definitions(document).readings:
            for name, default in read.arguments.items():
                defaults.setdefault(name, default)
        for name in sorted(taken_arguments(document).names):
            defaults.setdefault(name, "")
        return [
            {"name": name, "value": chosen.get(name, default), "choices": _choices(default)}
            for name, default in defaults.items()
        ]

    def _at(self, shown: Shown, position: types.Position, buffer: Buffer) -> list[dict[str, Any]] | None:
        """The parts at a place in a text; None where the text is not of the robot."""
        document = self.workspace.document(buffer.path)
        if shown.robot is None or shown.parts is None or document is None or document.root is None:
            return None
        if not any(_is_of(source, buffer) for source in shown.robot.files):
            return None
        element = elements(document).around(self.speech.offset(document.source, position))
        return [] if element is None else shown.parts.at(element)


def _is_of(source: Source, buffer: Buffer) -> bool:
    """Is a source the text of a buffer, as it is now?"""
    return source.text == buffer.source.text and source.real_path == buffer.source.real_path


def _fault(robot: Robot) -> str:
    """Where the text is broken; empty for one that is not."""
    from sdfcheck.convert.new_errors import break_of

    span = break_of(robot.document)
    return "" if span is None else f"The text is broken in line {span.begin.line}"


def _choices(default: str) -> list[str]:
    if default.lower() in _TRUTH:
        return [value if default.islower() else value.capitalize() for value in _TRUTH]
    return ["0", "1"] if default in {"0", "1"} else []


def _place(shown: Shown, word: Mapping[str, Any]) -> Span | None:
    """The place of the finding or part that a person has chosen."""
    number = word.get("finding")
    if isinstance(number, int) and 0 <= number < len(shown.found):
        return shown.found[number].span
    return None if shown.parts is None else shown.parts.place(word.get("model"), word.get("part"))

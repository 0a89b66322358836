"""Pages on a port of this computer, for those who know their address: a server for a browser beside the editor.

Source of the checks: other pages in the same browser can send requests to any port (so the address holds a
secret, and ``Origin`` is looked at), and names that lead here by DNS rebinding show in ``Host``.
"""

from __future__ import annotations

import json
import queue
import secrets
import threading
from collections.abc import Callable
from contextlib import suppress
from http import HTTPStatus
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer
from typing import Any

from sdfcheck.source.record import NamedTuple

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

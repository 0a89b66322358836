"""The server of pages: it answers those who know the address, and nobody else."""

from __future__ import annotations

import http.client
import json
from collections.abc import Iterator
from typing import Any
from urllib.parse import urlsplit

import pytest

from sdfcheck.lsp.beside import MOST_BYTES, MOST_LISTENERS, Loopback, Page


class Asked(Loopback):
    """A server, with the connections to it that are open."""

    def __init__(self) -> None:
        super().__init__()
        self.open: list[Any] = []


@pytest.fixture
def said() -> list[Any]:
    return []


@pytest.fixture
def server(said: list[Any]) -> Iterator[Asked]:
    made = Asked()
    made.show("robot", Page("<p>hello</p>", "default-src 'self'", lambda: ['{"first":1}'], said.append))
    yield made
    made.close()
    for each in made.open:
        each.close()


def asked(
    server: Asked, path: str, method: str = "GET", body: bytes | None = None, **headers: str
) -> http.client.HTTPResponse:
    connection = http.client.HTTPConnection("127.0.0.1", server.port, timeout=20)
    given = {name.replace("_", "-"): value for name, value in headers.items()}
    connection.request(method, path, body, given)
    answer = connection.getresponse()
    server.open += [connection, answer]
    return answer


def address(server: Asked) -> str:
    """The path of the page."""
    page = Page("<p>hello</p>", "default-src 'self'", lambda: ['{"first":1}'], lambda _: None)
    return urlsplit(server.show("other", page)).path


def path_of(server: Asked, said: list[Any]) -> str:
    page = Page("<p>hello</p>", "default-src 'self'", lambda: ['{"first":1}'], said.append)
    return urlsplit(server.show("robot", page)).path


def test_a_page_with_its_policy(server: Asked, said: list[Any]) -> None:
    answer = asked(server, path_of(server, said))
    assert answer.status == 200
    assert answer.read() == b"<p>hello</p>"
    assert answer.headers["Content-Security-Policy"] == "default-src 'self'; frame-ancestors 'none'"
    assert answer.headers["Cache-Control"] == "no-store"
    assert answer.headers["Referrer-Policy"] == "no-referrer"
    assert answer.headers["X-Content-Type-Options"] == "nosniff"
    assert "Python" not in (answer.headers["Server"] or "")


def test_an_address_stays_and_is_hard_to_guess(server: Asked, said: list[Any]) -> None:
    paths = {path_of(server, said) for _ in range(3)}
    assert len(paths) == 1
    assert address(server) not in paths
    assert all(len(path) > 40 for path in paths)


@pytest.mark.parametrize(
    "headers",
    [
        {"Host": "evil.example"},
        {"Host": "evil.example:80"},
        {"Origin": "http://evil.example"},
        {"Origin": "null"},
        {"Sec_Fetch_Site": "cross-site"},
        {"Sec_Fetch_Site": "same-site"},
    ],
)
@pytest.mark.parametrize(("method", "rest"), [("GET", ""), ("GET", "events"), ("POST", "say")])
def test_strangers_get_nothing(
    headers: dict[str, str], method: str, rest: str, server: Asked, said: list[Any]
) -> None:
    body = b"{}" if method == "POST" else None
    path = path_of(server, said)
    answer = asked(server, path + rest, method, body, Content_Type="application/json", **headers)
    assert answer.status == 403
    assert b"hello" not in answer.read()
    assert said == []


@pytest.mark.parametrize("path", ["/", "/x/", "//", "/..//", "/%00/", "/%C3%A9/"])
def test_without_the_secret_nothing(path: str, server: Asked) -> None:
    assert asked(server, path).status == 403


def test_messages_of_a_page(server: Asked, said: list[Any]) -> None:
    path = f"{path_of(server, said)}say"
    answer = asked(
        server,
        path,
        "POST",
        b'{"a":[1]}',
        Content_Type="application/json",
        Origin=f"http://127.0.0.1:{server.port}",
    )
    assert answer.status == 204
    assert said == [{"a": [1]}]
    for body, kind, status in [
        (b"{", "application/json", 400),
        (b"[" * 50_000, "application/json", 400),
        (b"{}", "text/plain", 404),
        (b" " * (MOST_BYTES + 1), "application/json", 413),
    ]:
        assert asked(server, path, "POST", body, Content_Type=kind).status == status
    assert asked(server, f"{path}x", "POST", b"{}", Content_Type="application/json").status == 404
    assert asked(server, f"{path_of(server, said)}viewer.js").status == 404
    assert asked(server, path, "DELETE").status == 501
    assert said == [{"a": [1]}]


def test_events_come_in_order(server: Asked, said: list[Any]) -> None:
    answer = asked(server, f"{path_of(server, said)}events")
    assert answer.headers["Content-Type"] == "text/event-stream"
    assert answer.readline() == b'data: {"first":1}\n'
    for number in range(5):
        server.send("robot", json.dumps(number))
        server.send("nobody", "x")
    lines = [answer.readline() for _ in range(11)]
    assert [line for line in lines if line.strip()] == [b"data: %d\n" % number for number in range(5)]
    server.close()
    assert answer.read() == b""


def test_there_are_not_too_many_listeners(server: Asked, said: list[Any]) -> None:
    path = f"{path_of(server, said)}events"
    answers = [asked(server, path) for _ in range(MOST_LISTENERS)]
    for answer in answers:
        assert answer.status == 200
        answer.readline()
    assert asked(server, path).status == 503

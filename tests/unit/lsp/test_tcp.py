"""The server on a port, to debug a client."""

from __future__ import annotations

import json
import socket
import subprocess
import sys
import time
from typing import Any


def test_a_session_over_tcp() -> None:
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        port = probe.getsockname()[1]
    command = [sys.executable, "-m", "sdfcheck", "server", "--tcp", "--port", str(port)]
    with subprocess.Popen(command, stderr=subprocess.DEVNULL) as server:
        try:
            with connected(port) as client, client.makefile("rwb") as stream:
                parameters: dict[str, object] = {"processId": None, "rootUri": None, "capabilities": {}}
                send(stream, id=1, method="initialize", params=parameters)
                answer = received(stream)
                assert answer["id"] == 1
                assert answer["result"]["serverInfo"]["name"] == "sdfcheck"
        finally:
            server.kill()


def connected(port: int) -> socket.socket:
    """A connection, as soon as somebody listens."""
    end = time.monotonic() + 60
    while True:
        client = socket.socket()
        client.settimeout(60)
        if client.connect_ex(("127.0.0.1", port)) == 0:
            return client
        client.close()
        assert time.monotonic() < end, "nobody listens"
        time.sleep(0.05)


def send(stream: Any, **message: object) -> None:
    body = json.dumps({"jsonrpc": "2.0", **message}).encode()
    stream.write(b"Content-Length: %d\r\n\r\n" % len(body) + body)
    stream.flush()


def received(stream: Any) -> dict[str, Any]:
    size = 0
    while (line := stream.readline().strip()) != b"":
        name, _, value = line.partition(b":")
        size = int(value) if name.lower() == b"content-length" else size
    found: dict[str, Any] = json.loads(stream.read(size))
    return found

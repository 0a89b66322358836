"""``sdfcheck server``."""

from __future__ import annotations

import gc
import logging
import os
from typing import BinaryIO

import click

from sdfcheck.cli.parts.command import Command
from sdfcheck.source.errors import WrongUsage

_HOST = "127.0.0.1"


@click.command(cls=Command, name="server")
@click.option(
    "--tcp", is_flag=True, help="Listen on a port instead of using stdin and stdout, to debug a client."
)
@click.option("--host", default=_HOST, show_default=True, help="Where to listen with --tcp.")
@click.option("--port", default=2087, show_default=True, help="On which port.")
@click.option("--stdio", is_flag=True, hidden=True, help="What happens anyway; some clients ask for it.")
def server_command(tcp: bool, host: str, port: int, stdio: bool) -> int:
    """Run the language server, which editors start.

    It speaks the Language Server Protocol on stdin and stdout: diagnostics while typing,
    quick fixes, hover, completion, definitions, references, renaming.
    """
    try:
        from sdfcheck.lsp.register import make_server
        from sdfcheck.lsp.worker import keep_memory_small
    except ModuleNotFoundError as error:
        if (error.name or "").partition(".")[0] not in {"pygls", "lsprotocol"}:
            raise
        raise WrongUsage("the language server needs pygls: pip install 'sdfcheck[lsp]'") from None
    gc.set_threshold(200_000, 3, 2)  # the worker collects garbage in pauses; this is for sessions without any
    gc.freeze()
    keep_memory_small()
    logging.getLogger("pygls").setLevel(logging.CRITICAL)  # what matters is sent to the client
    server = make_server()
    if tcp:
        server.start_tcp(host, port)
    else:
        server.start_io(*_pipes())
    return 0 if server.is_finished else 1


def _pipes() -> tuple[BinaryIO, BinaryIO]:
    """The way to the client and back, which nothing else may write to: what is printed goes to stderr.

    Raises:
        WrongUsage: there is no such way.
    """
    try:
        incoming, outgoing = os.fdopen(os.dup(0), "rb"), os.fdopen(os.dup(1), "wb")
        os.dup2(2, 1)
    except OSError:
        raise WrongUsage(
            "the language server needs stdin, stdout and stderr, and one of them is closed"
        ) from None
    return incoming, outgoing

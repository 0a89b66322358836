"""Sessions with the real server, with what some editors are able to do."""

from __future__ import annotations

import sys
from collections.abc import AsyncIterator, Callable, Iterator
from pathlib import Path

import pytest
import pytest_lsp
from lsprotocol import types
from pytest_lsp import ClientServerConfig, LanguageClient, client_capabilities

from tests.unit.lsp.wire import Session

REFRESHES = (
    types.WORKSPACE_DIAGNOSTIC_REFRESH,
    types.WORKSPACE_INLAY_HINT_REFRESH,
    types.WORKSPACE_SEMANTIC_TOKENS_REFRESH,
)
EDITORS = ("visual-studio-code", "neovim@v0.7", "neovim@v0.11")


def _noted(session: Session, method: str) -> Callable[[None], None]:
    def asked(params: None) -> None:
        session.refreshed.append(method)

    return asked


async def begin(client: LanguageClient, folder: Path, editor: str) -> Session:
    """A session in a folder, with a client that can do what an editor can."""
    session = Session(client, folder)
    client.protocol.fm.features[types.TEXT_DOCUMENT_PUBLISH_DIAGNOSTICS] = session.published.append

    @client.feature(types.CLIENT_REGISTER_CAPABILITY)  # type: ignore[untyped-decorator]
    def register(params: types.RegistrationParams) -> None:
        session.registered += params.registrations

    for method in REFRESHES:
        client.protocol.fm.features[method] = _noted(session, method)

    session.answer = await client.initialize_session(
        types.InitializeParams(
            capabilities=client_capabilities(editor),
            workspace_folders=[types.WorkspaceFolder(folder.as_uri(), "here")],
        )
    )
    vars(client)["session"] = session
    return session


@pytest_lsp.fixture(  # type: ignore[untyped-decorator]
    config=ClientServerConfig(server_command=[sys.executable, "-m", "sdfcheck", "server"]),
    params=EDITORS,
    scope="module",
)
async def client(
    request: pytest.FixtureRequest, lsp_client: LanguageClient, tmp_path_factory: pytest.TempPathFactory
) -> AsyncIterator[None]:
    await begin(lsp_client, tmp_path_factory.mktemp("workspace"), request.param)
    yield
    await lsp_client.shutdown_session()


@pytest.fixture
def session(client: LanguageClient) -> Iterator[Session]:
    """The session of the client, without the texts of other tests."""
    found: Session = vars(client)["session"]
    yield found
    for text in list(found.texts.values()):
        found.close(text)
    assert not client.error
    assert not [message for message in client.messages if "internal error" in message.message]


@pytest.fixture
def folder(session: Session, tmp_path: Path) -> Path:
    """A folder of the workspace for one test."""
    own = session.folder / tmp_path.parent.name
    own.mkdir(exist_ok=True)
    return own

"""The real server over stdio, asked as editors ask it."""

from __future__ import annotations

import sys
from collections.abc import AsyncIterator
from pathlib import Path
from typing import Any

import pytest
import pytest_lsp
from lsprotocol import types
from pytest_lsp import ClientServerConfig, LanguageClient, client_capabilities

TEXT = """\
<sdf version="1.12">
  <model name="m">
    <link name="arm"/>
    <link name="hand"/>
    <joint name="j" type="fixed">
      <parent>arm</parent>
      <child>hnd</child>
    </joint>
    <frame name="f" attached_to="arm"/>
  </model>
</sdf>
"""
EDITORS = ["visual-studio-code", "neovim@v0.9", "neovim@v0.11"]


@pytest_lsp.fixture(  # type: ignore[untyped-decorator]
    config=ClientServerConfig(server_command=[sys.executable, "-m", "sdfcheck", "server"]), params=EDITORS
)
async def client(
    request: pytest.FixtureRequest, lsp_client: LanguageClient, tmp_path: Path
) -> AsyncIterator[None]:
    @lsp_client.feature(types.CLIENT_REGISTER_CAPABILITY)  # type: ignore[untyped-decorator]
    def register(params: types.RegistrationParams) -> None:
        """What the server wants to be told."""

    await lsp_client.initialize_session(
        types.InitializeParams(
            capabilities=client_capabilities(request.param),
            workspace_folders=[types.WorkspaceFolder(tmp_path.as_uri(), "here")],
        )
    )
    yield
    await lsp_client.shutdown_session()


async def show(client: LanguageClient, path: Path, text: str, version: int = 1) -> str:
    """Open a text, and wait for its diagnostics."""
    uri = path.as_uri()
    path.write_text(text, encoding="utf-8")
    client.text_document_did_open(
        types.DidOpenTextDocumentParams(types.TextDocumentItem(uri, "sdf", version, text))
    )
    await published(client, uri)
    return uri


def pulls(client: LanguageClient) -> bool:
    """Does the client ask for diagnostics?"""
    assert client.capabilities is not None
    able = client.capabilities.text_document
    return able is not None and able.diagnostic is not None


async def published(client: LanguageClient, uri: str) -> None:
    while True:
        params = await client.wait_for_notification(types.TEXT_DOCUMENT_PUBLISH_DIAGNOSTICS)
        if params.uri == uri:
            return


async def diagnostics(client: LanguageClient, uri: str) -> list[types.Diagnostic]:
    """What the client shows for a file: what it was sent, or asks for if it can."""
    if not pulls(client):
        return list(client.diagnostics.get(uri, ()))
    report = await client.text_document_diagnostic_async(
        types.DocumentDiagnosticParams(types.TextDocumentIdentifier(uri))
    )
    assert isinstance(report, types.RelatedFullDocumentDiagnosticReport)
    return list(report.items)


def at(uri: str, line: int, column: int) -> dict[str, Any]:
    return {"text_document": types.TextDocumentIdentifier(uri), "position": types.Position(line, column)}


async def change(client: LanguageClient, uri: str, version: int, where: types.Range, text: str) -> None:
    client.text_document_did_change(
        types.DidChangeTextDocumentParams(
            types.VersionedTextDocumentIdentifier(version, uri),
            [types.TextDocumentContentChangePartial(range=where, text=text)],
        )
    )


def span(line: int, first: int, last: int) -> types.Range:
    return types.Range(types.Position(line, first), types.Position(line, last))


@pytest.mark.asyncio(loop_scope="function")
async def test_a_session(client: LanguageClient, tmp_path: Path) -> None:
    uri = await show(client, tmp_path / "m.sdf", TEXT)
    found = await diagnostics(client, uri)
    assert [d.range for d in found] == [span(6, 13, 16)]
    assert found[0].code_description is not None
    hover = await client.text_document_hover_async(types.HoverParams(**at(uri, 5, 8)))
    assert hover is not None
    assert isinstance(hover.contents, types.MarkupContent)
    assert "parent" in hover.contents.value
    place = await client.text_document_definition_async(types.DefinitionParams(**at(uri, 5, 15)))
    assert isinstance(place, types.Location)
    assert place.range == span(2, 16, 19)
    context = types.ReferenceContext(include_declaration=True)
    places = await client.text_document_references_async(
        types.ReferenceParams(context=context, **at(uri, 2, 17))
    )
    assert places is not None
    assert [each.range for each in places] == [span(2, 16, 19), span(5, 14, 17), span(8, 33, 36)]
    lights = await client.text_document_document_highlight_async(
        types.DocumentHighlightParams(**at(uri, 2, 17))
    )
    assert lights is not None
    assert len(lights) == 3
    offered = await client.text_document_completion_async(types.CompletionParams(**at(uri, 6, 13)))
    assert isinstance(offered, types.CompletionList)
    assert {"arm", "hand", "f"} <= {item.label for item in offered.items}
    symbols = await client.text_document_document_symbol_async(
        types.DocumentSymbolParams(types.TextDocumentIdentifier(uri))
    )
    assert symbols


@pytest.mark.asyncio(loop_scope="function")
async def test_typing_brings_new_diagnostics(client: LanguageClient, tmp_path: Path) -> None:
    uri = await show(client, tmp_path / "m.sdf", TEXT)
    await change(client, uri, 2, span(6, 13, 16), "hand")
    if not pulls(client):
        await published(client, uri)
    assert await diagnostics(client, uri) == []
    await change(client, uri, 3, span(2, 4, 22), "<link name='arm'")
    if not pulls(client):
        await published(client, uri)
    found = await diagnostics(client, uri)
    assert found
    assert found[0].range.start.line in {2, 3}


@pytest.mark.asyncio(loop_scope="function")
async def test_a_quick_fix_and_an_ignore_are_offered(client: LanguageClient, tmp_path: Path) -> None:
    uri = await show(client, tmp_path / "m.sdf", TEXT)
    found = await diagnostics(client, uri)
    actions = await client.text_document_code_action_async(
        types.CodeActionParams(
            types.TextDocumentIdentifier(uri), found[0].range, types.CodeActionContext(found)
        )
    )
    assert actions is not None
    titles = [action.title for action in actions]
    assert any("hand" in title for title in titles)
    assert any(title.startswith("Ignore ") and title.endswith(" here") for title in titles)


@pytest.mark.asyncio(loop_scope="function")
async def test_renaming_in_two_files_and_back(client: LanguageClient, tmp_path: Path) -> None:
    good = TEXT.replace("hnd", "hand")
    world = (
        '<sdf version="1.12">\n<world name="w">\n<include>\n<uri>m.sdf</uri>\n<name>m</name>\n</include>\n'
        '<frame name="g" attached_to="m::arm"/>\n</world>\n</sdf>\n'
    )
    (tmp_path / "w.sdf").write_text(world)
    uri = await show(client, tmp_path / "m.sdf", good)
    edit = await client.text_document_rename_async(types.RenameParams(new_name="upper", **at(uri, 2, 17)))
    assert edit is not None
    counts = {}
    for change in edit.document_changes or ():
        assert isinstance(change, types.TextDocumentEdit)
        counts[Path(change.text_document.uri).name] = len(change.edits)
    for name, edits in (edit.changes or {}).items():
        counts[Path(name).name] = len(edits)
    assert counts == {"m.sdf": 3, "w.sdf": 1}
    with pytest.raises(Exception, match="already"):
        await client.text_document_rename_async(types.RenameParams(new_name="hand", **at(uri, 2, 17)))

"""Over stdio: settings, files on disk, and a session that goes on whatever happens."""

from __future__ import annotations

import os
import sys
from collections.abc import AsyncIterator
from pathlib import Path

import pytest
import pytest_lsp
from lsprotocol import types
from pygls.exceptions import JsonRpcException
from pytest_lsp import ClientServerConfig, LanguageClient

from tests.unit.lsp.conftest import begin
from tests.unit.lsp.wire import Session
from tests.unit.preview import preview_example

pytestmark = [pytest.mark.asyncio(loop_scope="module"), pytest.mark.xdist_group(__name__)]

MODEL = """\
<sdf version="1.12">
  <model name="m">
    <link name="arm"/>
    <link name="hand"/>
    <joint name="j" type="fixed"><parent>arm</parent><child>hnd</child></joint>
  </model>
</sdf>
"""
WORLD = """\
<sdf version="1.12">
  <world name="w"><include><uri>m.sdf</uri></include><frame name="f" attached_to="m::arm"/></world>
</sdf>
"""
FAILING = """
from sdfcheck.lsp import answers
from sdfcheck.cli.main import main
def hover(*given):
    raise RuntimeError("the hover fails")
answers.hover = hover
main(["server"])
"""


async def test_the_server_says_what_it_can(session: Session) -> None:
    assert session.answer is not None
    able = session.answer.capabilities
    for name in (
        "hover_provider",
        "definition_provider",
        "references_provider",
        "document_highlight_provider",
        "document_symbol_provider",
        "workspace_symbol_provider",
        "folding_range_provider",
        "document_link_provider",
        "inlay_hint_provider",
        "semantic_tokens_provider",
        "diagnostic_provider",
        "completion_provider",
        "code_action_provider",
        "rename_provider",
    ):
        assert getattr(able, name), name
    assert session.encoding in {"utf-8", "utf-16"}


async def test_settings_of_the_client(session: Session, folder: Path) -> None:
    text = session.open(folder / "m.sdf", MODEL)
    await text.diagnostics()
    session.choose(ignore=["unknown-joint-end"])
    await text.diagnostics(lambda found: not found)
    session.choose(ignore=[], expandXacro=True)
    await text.diagnostics()


async def test_settings_with_rules_in_preview(session: Session, folder: Path) -> None:
    rule, linted = preview_example()
    text = session.open(folder / "new.sdf", linted)
    await text.diagnostics(lambda found: rule not in {each.code for each in found})
    session.choose(preview=True)
    await text.diagnostics(lambda found: rule in {each.code for each in found})


async def test_settings_that_name_no_rule(session: Session, folder: Path) -> None:
    text = session.open(folder / "m.sdf", MODEL)
    await text.diagnostics()
    session.choose(ignore=["no-such-rule"])
    await session.waited(lambda: any("no-such-rule" in each.message for each in session.client.messages))
    session.choose(ignore=[])
    await text.diagnostics()


async def test_configuration_on_disk(session: Session, folder: Path) -> None:
    text = session.open(folder / "m.sdf", MODEL)
    await text.diagnostics()
    path = folder / "sdfcheck.toml"
    path.write_text('ignore = ["unknown-joint-end"]\n')
    session.notice(path, types.FileChangeType.Created)
    await text.diagnostics(lambda found: not found)
    path.unlink()
    session.notice(path, types.FileChangeType.Deleted)
    await text.diagnostics()


async def test_files_on_disk(session: Session, folder: Path) -> None:
    (folder / "m.sdf").write_text(MODEL.replace("hnd", "hand"))
    text = session.open(folder / "w.sdf", WORLD)
    await text.diagnostics(lambda found: not found)
    (folder / "m.sdf").write_text(MODEL.replace("hnd", "hand").replace("arm", "leg"))
    session.notice(folder / "m.sdf")
    (found,) = await text.diagnostics()
    assert "arm" in found.message
    (folder / "m.sdf").unlink()
    session.notice(folder / "m.sdf", types.FileChangeType.Deleted)
    await text.diagnostics(lambda found: any(text.cut(each.range) == "m.sdf" for each in found))


async def test_files_are_watched(session: Session, folder: Path) -> None:
    """By the client where it can, else by the server itself."""
    methods = [registration.method for registration in session.registered]
    if types.WORKSPACE_DID_CHANGE_WATCHED_FILES in methods:
        return
    (folder / "m.sdf").write_text(MODEL.replace("hnd", "hand"))
    text = session.open(folder / "w.sdf", WORLD)
    await text.diagnostics(lambda found: not found)
    (folder / "m.sdf").write_text(MODEL.replace("hnd", "hand").replace("arm", "leg"))
    await text.diagnostics()


async def test_requests_that_cannot_be_read_are_answered(session: Session, folder: Path) -> None:
    text = session.open(folder / "m.sdf", MODEL)
    with pytest.raises(JsonRpcException):
        await session.raw("textDocument/hover", {"position": 7})
    odd = {
        "textDocument": {"uri": text.uri},
        "range": {"start": {"line": 4, "character": 0}, "end": {"line": 5, "character": 0}},
        "context": {"diagnostics": [{"lnum": 4, "message": "in a form of the client's own"}]},
    }
    assert len(await session.raw("textDocument/codeAction", odd)) == 2
    session.client.messages.clear()


async def test_texts_that_are_no_robots(session: Session, folder: Path) -> None:
    for number, content in enumerate(
        ("", "\x00\ufffd\ud7ff", "<", "]]>", "<a>" * 3000, '{"a": 1}', "&a;" * 99)
    ):
        text = session.open(folder / f"{number}.sdf", content)
        await text.hover(content[:1])
        await text.completion(content[:1])
        await text.actions(types.Range(types.Position(0, 0), types.Position(9, 0)))
        session.close(text)


async def test_a_text_without_a_file(session: Session, folder: Path) -> None:
    uri = "untitled:Untitled-1"
    item = types.TextDocumentItem(uri, "sdformat", 1, MODEL)
    session.client.text_document_did_open(types.DidOpenTextDocumentParams(item))
    if session.pulls:
        report = await session.client.text_document_diagnostic_async(
            types.DocumentDiagnosticParams(types.TextDocumentIdentifier(uri))
        )
        assert isinstance(report, types.RelatedFullDocumentDiagnosticReport)
        assert report.items
    else:
        await session.waited(lambda: any(each.uri == uri and each.diagnostics for each in session.published))
    session.client.text_document_did_close(
        types.DidCloseTextDocumentParams(types.TextDocumentIdentifier(uri))
    )


@pytest_lsp.fixture(  # type: ignore[untyped-decorator]
    config=ClientServerConfig(server_command=[sys.executable, "-c", FAILING]), scope="module"
)
async def broken(lsp_client: LanguageClient, tmp_path_factory: pytest.TempPathFactory) -> AsyncIterator[None]:
    await begin(lsp_client, tmp_path_factory.mktemp("workspace"), "visual-studio-code")
    yield
    await lsp_client.shutdown_session()


async def test_a_failure_is_logged_and_shown_once(broken: LanguageClient, tmp_path: Path) -> None:
    session: Session = vars(broken)["session"]
    text = session.open(tmp_path / "m.sdf", MODEL)
    for _ in range(3):
        assert await text.hover('"arm"', 2) == ""
    assert len([log for log in broken.log_messages if "the hover fails" in log.message]) == 3
    (message,) = broken.messages
    assert "RuntimeError: the hover fails" in message.message
    assert await text.diagnostics()


@pytest.mark.parametrize(
    "uri",
    [
        "file:///a%00b/m.sdf",
        "file:///%00",
        "untitled:a%00b.sdf",
        "file://[/m.sdf",
        "%00",
        "file:///a/%FF%00.urdf",
    ],
)
async def test_addresses_that_no_file_has_are_answered(session: Session, uri: str) -> None:
    client = session.client
    item = types.TextDocumentItem(uri, "sdf", 1, MODEL.replace("hnd", "hand"))
    client.text_document_did_open(types.DidOpenTextDocumentParams(item))
    identifier = types.TextDocumentIdentifier(uri)
    answer = await session.raw("textDocument/documentSymbol", {"textDocument": {"uri": uri}})
    assert answer
    event = types.FileEvent(uri, types.FileChangeType.Changed)
    client.workspace_did_change_watched_files(types.DidChangeWatchedFilesParams([event]))
    client.text_document_did_close(types.DidCloseTextDocumentParams(identifier))


async def test_a_text_in_deep_folders_is_linted(session: Session, folder: Path) -> None:
    deep = folder.joinpath(*"d" * 1100)
    at = folder
    for name in deep.relative_to(folder).parts:
        at = at / name
        os.mkdir(at)
    shown = session.open(deep / "m.sdf", MODEL)
    assert [each.code for each in await shown.diagnostics()]
    session.close(shown)
    (deep / "m.sdf").unlink()
    for at in (deep, *deep.parents)[:1100]:  # what removes whole trees calls itself
        at.rmdir()

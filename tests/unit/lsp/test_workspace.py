"""The server reads the files of the folders that the editor shows, and what any command reads for them."""

from __future__ import annotations

import os
from pathlib import Path

import pytest

from sdfcheck.files.regular import OUTSIDE, Outside
from sdfcheck.lsp.findings import Findings
from sdfcheck.lsp.names import project_files
from sdfcheck.lsp.speech import path_of
from sdfcheck.lsp.workspace import Workspace

MODEL = '<sdf version="1.9"><model name="m"><link name="l"/></model></sdf>'
WORLD = (
    '<sdf version="1.9"><world name="w"><include><uri>../b/m.sdf</uri></include>'
    '<frame name="f" attached_to="m::nowhere"/></world></sdf>'
)


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    """Two repositories beside each other; a world in one includes a model of the other."""
    for name, file, text in (("a", "w.sdf", WORLD), ("b", "m.sdf", MODEL)):
        (tmp_path / name / ".git").mkdir(parents=True)
        (tmp_path / name / file).write_text(text)
    return tmp_path


def found(workspace: Workspace, path: Path) -> set[str]:
    buffer = workspace.open(path.as_uri(), path, path.read_text(), 1)
    findings = Findings(workspace)
    findings.lint(buffer)
    return {each.code for each in findings.at(path)}


def test_files_of_the_editors_folders_may_refer_to_one_another(folder: Path) -> None:
    workspace, world = Workspace(), folder / "a" / "w.sdf"
    outside = found(workspace, world)
    with pytest.raises(Outside, match=OUTSIDE):
        workspace.library(world).read(folder / "b" / "m.sdf", workspace.buffers[str(world)].document)
    workspace.surround((folder,))
    inside = found(workspace, world)
    assert workspace.library(world).read(folder / "b" / "m.sdf", workspace.buffers[str(world)].document)
    assert inside != outside
    workspace.close()


def test_links_out_of_the_folders_are_not_followed(folder: Path) -> None:
    (folder / "secret.sdf").write_text(MODEL.replace('"l"', '"secret"'))
    (folder / "a" / "link.sdf").symlink_to("../secret.sdf")
    (folder / "a" / "own.sdf").write_text(MODEL)
    workspace = Workspace()
    workspace.surround((folder / "a",))
    files = list(project_files(workspace, folder / "a" / "w.sdf"))
    assert [path.name for path in files] == ["own.sdf", "w.sdf"]
    findings = Findings(workspace)
    findings.lint_from_disk(folder / "a" / "link.sdf")
    assert not findings.all()
    workspace.close()


def test_a_file_by_two_addresses_is_one(folder: Path) -> None:
    (folder / "same").symlink_to("a")
    workspace = Workspace()
    keys = {workspace.key(folder / name / "w.sdf") for name in ("a", "same", "b/../a")}
    assert keys == {os.path.realpath(folder / "a" / "w.sdf")}


@pytest.mark.parametrize("uri", ["\ud83d.sdf", "file:///\ud83d/a.sdf", "file:///a%00b", "file:///%ED%A0%BD"])
def test_an_address_is_a_path_that_the_system_takes(uri: str) -> None:
    assert not os.path.exists(path_of(uri))


def test_files_of_a_project_are_looked_for_again(folder: Path) -> None:
    workspace, world = Workspace(), folder / "a" / "w.sdf"
    library = workspace.library(world)

    def names() -> list[str]:
        return library.of_project(
            world, lambda packages: [Path(each).name for each in packages.files(".sdf", 9)]
        )

    assert names() == ["w.sdf"]
    (folder / "a" / "new.sdf").write_text(MODEL)
    library.look_again()
    assert sorted(names()) == ["new.sdf", "w.sdf"]
    workspace.close()

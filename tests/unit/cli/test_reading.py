"""Files that descriptions, folders and configurations lead to are read within their bounds only."""

from __future__ import annotations

import os
import socket
import struct
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path

import pytest

from sdfcheck.cli.main import main

SECRET = "canary that nobody may read"
STL = b"solid s\nfacet normal 0 0 1\n" + SECRET.encode() + b"\nendsolid\n"
ROBOT = '<robot name="r"><link name="a"><visual><geometry><mesh filename="{}"/></geometry></visual></link></robot>'
INCLUDING = (
    '<sdf version="1.9"><model name="m"><link name="l"/><include><uri>{}</uri></include></model></sdf>'
)
AUTO = (
    '<sdf version="1.11"><model name="m"><link name="l"><inertial auto="true"/><collision name="c">'
    "<density>1000</density><geometry><mesh><uri>{}</uri></mesh></geometry></collision></link></model></sdf>"
)


@pytest.fixture
def project(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A repository, and a secret beside it."""
    folder = tmp_path / "project"
    (folder / ".git").mkdir(parents=True)
    (tmp_path / "secret.sdf").write_text(
        f'<sdf version="1.9"><model name="m"><nonsense a="{SECRET}"/></model></sdf>'
    )
    (tmp_path / "secret.txt").write_text(SECRET)
    (tmp_path / "secret.stl").write_bytes(STL)
    monkeypatch.chdir(folder)
    monkeypatch.setenv("CANARY", SECRET)
    return folder


def everything(capsys: pytest.CaptureFixture[str]) -> str:
    captured = capsys.readouterr()
    return captured.out + captured.err


@pytest.mark.parametrize(
    "uri", ["/proc/self/environ", "/proc/{pid}/environ", "/dev/stdin", "/sys/kernel/uevent_seqnum"]
)
@pytest.mark.parametrize("by_link", [False, True], ids=["itself", "by a link"])
def test_files_of_the_kernel_are_not_shown(
    project: Path, uri: str, *, by_link: bool, capsys: pytest.CaptureFixture[str]
) -> None:
    uri = uri.format(pid=os.getpid())
    if by_link:
        (project / "part.sdf").symlink_to(uri)
    (project / "a.sdf").write_text(INCLUDING.format("part.sdf" if by_link else f"file://{uri}"))
    for words in ("lint --min-severity info", "print --expand-includes", "view"):
        main([*words.split(), "a.sdf"])
        assert SECRET not in everything(capsys)


@pytest.mark.parametrize("name", ["secret.sdf", "secret.txt"])
@pytest.mark.parametrize("by_link", [False, True], ids=["by its path", "by a link"])
def test_files_outside_are_not_shown(
    project: Path, name: str, *, by_link: bool, capsys: pytest.CaptureFixture[str]
) -> None:
    if by_link:
        (project / "part.sdf").symlink_to(f"../{name}")
    (project / "a.sdf").write_text(INCLUDING.format("part.sdf" if by_link else f"../{name}"))
    assert main(["lint", "--min-severity", "info", "a.sdf"]) == 0
    shown = everything(capsys)
    assert SECRET not in shown
    assert "is not read: it lies outside of the project, its packages and model paths" in shown
    main(["print", "--expand-includes", "a.sdf"])
    assert SECRET not in everything(capsys)
    main(["lint", "."])
    assert SECRET not in everything(capsys)


def test_named_folders_are_read(project: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (project / "a.sdf").write_text(INCLUDING.format("../secret.sdf"))
    assert main(["lint", "a.sdf", ".."]) == 1
    assert "nonsense" in everything(capsys)
    assert main(["lint", "a.sdf", "--model-path", ".."]) == 1
    assert "nonsense" in everything(capsys)


def test_a_text_that_is_no_description_is_not_shown(
    project: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (project / "inside.txt").write_text(SECRET)
    (project / "a.sdf").write_text(INCLUDING.format("inside.txt"))
    assert main(["lint", "a.sdf"]) == 1
    shown = everything(capsys)
    assert SECRET not in shown
    assert "`inside.txt` is neither SDFormat nor URDF" in shown
    (project / "inside.sdf").write_text(SECRET)
    for form in ("full", "html", "json", "sarif"):
        assert main(["lint", "inside.sdf", "--output-format", form]) == 1
        shown = everything(capsys)
        assert "this looks like plain text" in shown
        assert SECRET not in shown
    (project / "b.sdf").symlink_to("../secret.txt")
    for kind in ("auto", "sdf", "urdf", "xacro", "srdf", "model-config"):
        assert main(["lint", "b.sdf", "--kind", kind]) == 2
        assert SECRET not in everything(capsys)


def test_packages_and_models_are_found_beside_the_project(
    project: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    wrong = '<sdf version="1.9"><model name="arm"><nonsense/></model></sdf>'
    arm = tmp_path / "arm"
    arm.mkdir()
    (arm / "model.sdf").write_text(wrong)
    (arm / "model.config").write_text('<model><name>arm</name><sdf version="1.9">model.sdf</sdf></model>')
    (project / "a.sdf").write_text(INCLUDING.format("model://arm"))
    assert main(["lint", "a.sdf"]) == 1
    assert "nonsense" in everything(capsys)
    for uri in ("model://arm/../secret.sdf", "model://../secret.sdf", "model://arm/../../secret.sdf"):
        (project / "a.sdf").write_text(INCLUDING.format(uri))
        main(["lint", "a.sdf"])
        assert SECRET not in everything(capsys)
    (project / "linked").symlink_to("..")
    (project / "a.sdf").write_text(INCLUDING.format("model://linked/secret.sdf"))
    main(["lint", "a.sdf"])
    assert SECRET not in everything(capsys)


def page_of(words: str, capsys: pytest.CaptureFixture[str]) -> str:
    main([*words.split(), "robot.urdf"])
    return everything(capsys)


@pytest.mark.parametrize(
    "words", ["view", "lint --output-format html", "convert urdf-to-sdf --report page.html"]
)
@pytest.mark.parametrize("target", ["../secret.stl", "/proc/self/environ", "../secret.txt", "inside.stl"])
def test_pages_hold_meshes_of_the_project_only(
    project: Path, words: str, target: str, capsys: pytest.CaptureFixture[str]
) -> None:
    from base64 import b64encode

    (project / "inside.stl").write_text(SECRET * 9)
    (project / "part.stl").symlink_to(target)
    (project / "robot.urdf").write_text(ROBOT.format("part.stl"))
    page = page_of(words, capsys) + "".join(path.read_text() for path in project.glob("*.html"))
    assert "part.stl" in page
    for skipped in range(3):
        assert b64encode(SECRET.encode()[skipped:])[:-4].decode() not in page
    (project / "part.stl").unlink()
    (project / "part.stl").write_bytes(b" " * 80 + struct.pack("<I", 1) + bytes(50))
    page = page_of(words, capsys) + "".join(path.read_text() for path in project.glob("*.html"))
    assert '"format":"stl"' in page.replace('": "', '":"')


def test_a_mesh_that_is_known_is_opened_again(
    project: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    """A run may have no right to read a mesh that an earlier one has measured, and never writes over it."""
    monkeypatch.setenv("SDFCHECK_CACHE_DIR", str(tmp_path / "cache"))
    (tmp_path / "out").mkdir()
    mesh = tmp_path / "out" / "part.obj"
    mesh.write_text("v 0 0 0\nv 5000 0 0\nv 0 5000 0\nf 1 2 3\n")
    (project / "a.urdf").write_text(ROBOT.format("../out/part.obj"))
    for named, is_read in (([], False), ([".."], True), ([], False)):
        main(["lint", "--select", "ALL", "--min-severity", "info", "a.urdf", *named])
        shown = everything(capsys)
        assert ("part.obj is not read: it lies outside of the project" in shown) is not is_read
        assert "cannot be read" not in shown  # others can
    assert list((tmp_path / "cache" / "meshes").glob("*.json"))
    for _ in range(2):
        assert main(["lint", "a.urdf", "..", "-o", str(mesh)]) == 2
        assert "part.obj is an input" in everything(capsys)


@pytest.fixture
def odd(project: Path) -> Iterator[None]:
    """A pipe, a socket and links to devices, under names that descriptions use."""
    os.mkfifo(project / "pipe")
    listening = socket.socket(socket.AF_UNIX)
    listening.bind("socket")
    (project / "zero").symlink_to("/dev/zero")
    yield
    listening.close()


@pytest.mark.parametrize("name", ["pipe", "socket", "zero"])
def test_nothing_waits_for_what_is_not_a_file(odd: None, project: Path, name: str) -> None:
    for link in (
        "part.sdf",
        "part.stl",
        "mesh.mtl",
        "package.xml",
        "sdfcheck.toml",
        "known.json",
        "model.config",
    ):
        (project / link).symlink_to(name)
    (project / "a.sdf").write_text(INCLUDING.format("part.sdf"))
    (project / "b.sdf").write_text(INCLUDING.format("model://project"))
    (project / "c.sdf").write_text(AUTO.format("part.stl"))
    (project / "mesh.obj").write_text("mtllib mesh.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")
    (project / "d.sdf").write_text(AUTO.format("mesh.obj"))
    (project / "robot.srdf").write_text('<robot name="r"><group name="g"><link name="a"/></group></robot>')
    (project / "robot.urdf").symlink_to(name)
    lines = (
        "lint .",
        "lint a.sdf b.sdf c.sdf d.sdf robot.srdf",
        "inertia c.sdf",
        "inertia d.sdf",
        "view c.sdf -o page.html",
        "print --expand-includes --expand-auto-inertials a.sdf",
        "lint a.sdf --baseline known.json",
        "lint a.sdf --config sdfcheck.toml",
    )
    script = (
        "import sys; from sdfcheck.cli.main import main; "
        "assert {main(line.split()) for line in sys.argv[1:]} <= {0, 1, 2}"
    )
    command = [sys.executable, "-c", script, *lines]
    done = subprocess.run(command, capture_output=True, text=True, timeout=120, check=False)
    assert done.returncode == 0, done.stderr
    assert "internal error" not in done.stderr


def test_a_baseline_holds_counts(project: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (project / "a.sdf").write_text(INCLUDING.format("part.sdf"))
    for number in ("1e400", "-1e400", "NaN", "1.5", "true", '"1"', "-1", "[]"):
        (project / "known.json").write_text(
            f'{{"version": 1, "findings": {{"a.sdf": {{"RES001": {number}}}}}}}'
        )
        assert main(["lint", "a.sdf", "--baseline", "known.json"]) == 2
        assert capsys.readouterr().err == "error: known.json is not a baseline\n"


@pytest.mark.parametrize("place", ["../shared.toml", "link.toml"])
def test_extending_leads_out_with_consent_only(
    project: Path, tmp_path: Path, place: str, capsys: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / "shared.toml").write_text(f"{SECRET} = 1\n")
    (project / "link.toml").symlink_to("../shared.toml")
    (project / "sdfcheck.toml").write_text(f'fail-on = "error"\nextend = "{place}"\n')
    (project / "a.sdf").write_text(INCLUDING.format("part.sdf"))
    assert main(["lint", "a.sdf"]) == 2
    shown = everything(capsys)
    assert shown.startswith("error: sdfcheck.toml:2: `extend` leads out of ")
    assert "pass --trust-config" in shown
    (tmp_path / "shared.toml").write_text('ignore = ["RES"]\n')
    assert main(["lint", "a.sdf", "--trust-config"]) == 0
    assert main(["lint", "a.sdf", "--config", "sdfcheck.toml"]) == 0


def test_a_configuration_is_no_link_out(
    project: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / "shared.toml").write_text('ignore = ["RES"]\n')
    (project / "sdfcheck.toml").symlink_to("../shared.toml")
    (project / "a.sdf").write_text(INCLUDING.format("part.sdf"))
    assert main(["lint", "a.sdf"]) == 2
    assert "sdfcheck.toml: a link that leads out of " in everything(capsys)
    assert main(["lint", "a.sdf", "--trust-config"]) == 0

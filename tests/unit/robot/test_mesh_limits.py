"""Meshes that would fill the memory, or keep a command waiting, are not measured."""

from __future__ import annotations

import json
import zipfile
from pathlib import Path

import pytest

from sdfcheck.cli.main import main

ROBOT = (
    '<sdf version="1.11"><model name="m"><link name="l"><inertial auto="true"/><collision name="c">'
    "<density>1000</density><geometry><mesh><uri>{}</uri></mesh></geometry></collision></link></model></sdf>"
)


def measured(file: Path, capsys: pytest.CaptureFixture[str]) -> str:
    """The warning about the mass of a mesh."""
    robot = file.parent / "robot.sdf"
    robot.write_text(ROBOT.format(file.name))
    assert main(["inertia", "--isolated", str(robot)]) == 0
    return capsys.readouterr().err


def test_scenes_that_repeat_themselves(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    pytest.importorskip("trimesh")
    nodes: list[dict[str, object]] = [{"children": [n + 1, n + 1]} for n in range(60)]
    file = tmp_path / "mesh.gltf"
    for last in ({"mesh": 0}, {"children": [0]}):
        tree = {
            "asset": {"version": "2.0"},
            "nodes": [*nodes, last],
            "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
            "accessors": [{"count": 3}],
        }
        file.write_text(json.dumps(tree))
        assert "mesh `mesh.gltf` has too many parts to be measured" in measured(file, capsys)
    library = "".join(
        f'<node id="n{n}"><instance_node url="#n{n + 1}"/><instance_node url="#n{n + 1}"/></node>'
        for n in range(60)
    )
    file = tmp_path / "mesh.dae"
    file.write_text(
        f'<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema"><library_nodes>{library}<node id="n60"/>'
        "</library_nodes><scene/></COLLADA>"
    )
    assert "mesh `mesh.dae` has too many parts to be measured" in measured(file, capsys)


def test_numbers_that_nothing_holds(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    pytest.importorskip("trimesh")
    file = tmp_path / "mesh.gltf"
    tree = {
        "asset": {"version": "2.0"},
        "nodes": [{"mesh": 0}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
        "accessors": [{"count": 10**10, "componentType": 5126, "type": "VEC3"}],
    }
    file.write_text(json.dumps(tree))
    assert "too many parts" in measured(file, capsys)


@pytest.mark.parametrize("name", ["mesh.3mf", "mesh.dae", "mesh.zip"])
def test_archives(tmp_path: Path, name: str, capsys: pytest.CaptureFixture[str]) -> None:
    pytest.importorskip("trimesh")
    file = tmp_path / name
    with zipfile.ZipFile(file, "w", zipfile.ZIP_DEFLATED) as archive:
        archive.writestr("3D/3dmodel.model", b"0" * 10_000_000)
    assert f"mesh `{name}`" in measured(file, capsys)


@pytest.mark.parametrize("name", ["mesh.obj", "mesh.stl", "mesh.dae", "mesh.glb", "mesh.gltf"])
def test_texts_are_not_quoted(tmp_path: Path, name: str, capsys: pytest.CaptureFixture[str]) -> None:
    pytest.importorskip("trimesh")
    file = tmp_path / name
    file.write_text("v canary canary canary\n<canary>\n")
    shown = measured(file, capsys)
    assert f"mesh `{name}` " in shown
    assert "canary" not in shown

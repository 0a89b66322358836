"""Meshes on the page of a robot: of each format, missing, broken and huge."""

from __future__ import annotations

import base64
import json
import struct
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

from tests.peers import chromium
from tests.peers.viewed import panel, show, with_meshes

pytestmark = [
    pytest.mark.peers,
    pytest.mark.skipif(chromium.missing() is not None, reason=chromium.missing() or ""),
]


@pytest.fixture(scope="module")
def tab() -> Iterator[chromium.Tab]:
    with chromium.tab() as opened:
        yield opened


def test_missing_and_broken_meshes_are_named(tab: chromium.Tab, tmp_path: Path) -> None:
    (tmp_path / "broken.stl").write_bytes(b"\0" * 80 + struct.pack("<I", 1 << 30))
    (tmp_path / "holes.stl").write_bytes(
        b"\0" * 80 + struct.pack("<I", 1) + struct.pack("<12f", *[float("nan")] * 12) + b"\0\0"
    )
    (tmp_path / "broken.dae").write_text("<COLLADA><asset>")
    (tmp_path / "broken.glb").write_bytes(b"glTF" + b"\xff" * 40)
    (tmp_path / "empty.obj").write_text("# nothing\n")
    names = ["broken.stl", "holes.stl", "broken.dae", "broken.glb", "empty.obj", "gone.stl", "odd.xyz"]
    show(tab, tmp_path, with_meshes(tmp_path, *names))
    assert tab.errors == []
    notes = tab.run("[...document.querySelectorAll('.note')].map(note => note.textContent)")
    assert sorted(note.partition(":")[0] for note in notes) == sorted(names)


def test_meshes_of_each_format_are_drawn(tab: chromium.Tab, tmp_path: Path) -> None:
    corners = [(0.0, 0.0, 0.0), (1.0, 0.0, 0.0), (0.0, 0.0, 1.0)]
    flat = [number for corner in corners for number in corner]
    (tmp_path / "a.stl").write_bytes(
        b"\0" * 80 + struct.pack("<I", 1) + struct.pack("<12f", 0, -1, 0, *flat) + b"\0\0"
    )
    (tmp_path / "a.obj").write_text("".join(f"v {x} {y} {z}\n" for x, y, z in corners) + "f 1 2 3\n")
    (tmp_path / "a.dae").write_text(
        '<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1"><asset>'
        '<unit meter="1"/><up_axis>Z_UP</up_axis></asset><library_geometries><geometry id="g"><mesh><source id="p">'
        f'<float_array id="f" count="9">{" ".join(map(str, flat))}</float_array><technique_common>'
        '<accessor source="#f" count="3" stride="3"><param name="X" type="float"/><param name="Y" type="float"/>'
        '<param name="Z" type="float"/></accessor></technique_common></source><vertices id="v">'
        '<input semantic="POSITION" source="#p"/></vertices><triangles count="1">'
        '<input semantic="VERTEX" source="#v" offset="0"/><p>0 1 2</p></triangles></mesh></geometry>'
        '</library_geometries><library_visual_scenes><visual_scene id="s"><node id="n"><instance_geometry url="#g"/>'
        '</node></visual_scene></library_visual_scenes><scene><instance_visual_scene url="#s"/></scene></COLLADA>'
    )
    upright = [number for x, y, z in corners for number in (x, z, -y)]  # glTF has y up
    data = base64.b64encode(struct.pack("<9f", *upright)).decode()
    (tmp_path / "a.gltf").write_text(json.dumps(gltf(f"data:application/octet-stream;base64,{data}")))
    names = ["a.stl", "a.obj", "a.dae", "a.gltf"]
    show(tab, tmp_path, with_meshes(tmp_path, *names))
    assert tab.errors == []
    assert tab.page.locator(".note").count() == 0
    for number in range(len(names)):
        tab.page.click(f"[data-part=l{number}]")
        assert tab.run("viewer.size()") == pytest.approx([1, 0, 1], abs=1e-6), names[number]


def gltf(uri: str) -> dict[str, Any]:
    """A triangle whose corners are in a buffer."""
    return {
        "asset": {"version": "2.0"},
        "scene": 0,
        "scenes": [{"nodes": [0]}],
        "nodes": [{"mesh": 0}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
        "buffers": [{"uri": uri, "byteLength": 36}],
        "bufferViews": [{"buffer": 0, "byteLength": 36}],
        "accessors": [
            {
                "bufferView": 0,
                "componentType": 5126,
                "count": 3,
                "type": "VEC3",
                "min": [0, 0, 0],
                "max": [1, 1, 0],
            }
        ],
    }


def test_a_huge_mesh_is_a_box_with_its_name(tab: chromium.Tab, tmp_path: Path) -> None:
    with (tmp_path / "huge.stl").open("wb") as file:
        file.truncate(200_000_000)
    show(tab, tmp_path, with_meshes(tmp_path, "huge.stl"))
    assert tab.errors == []
    assert "huge.stl: too large to embed (200 MB)" in panel(tab)
    assert (tmp_path / "out.html").stat().st_size < 2_000_000

"""Mesh files of every kind: bounds, triangles, surfaces, and what makes them unreadable."""

from __future__ import annotations

import json
import math
import os
import struct
import time
from pathlib import Path
from typing import TYPE_CHECKING
from unittest.mock import Mock

import numpy as np
import pytest

from sdfcheck.bodies import mesh
from sdfcheck.bodies.box import Box, around
from sdfcheck.bodies.mesh import Mesh, mesh_at, read_mesh, read_skin, skin_at
from sdfcheck.bodies.solid import of_shape, together
from sdfcheck.files.library import Shelves
from sdfcheck.robot.graph import Model
from sdfcheck.robot.motion.poses import about_axis
from sdfcheck.robot.root import root_of
from tests.unit.robot.files import opened

if TYPE_CHECKING:
    import numpy.typing as npt

CORNERS = ((0.0, 0.0, 0.0), (2.0, 0.0, 0.0), (0.0, 3.0, -1.0))
WEDGE = Box((0.0, 0.0, -1.0), (2.0, 3.0, 0.0))
"""The box around these corners."""


@pytest.fixture(autouse=True)
def cache(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.setenv("SDFCHECK_CACHE_DIR", str(tmp_path / "cache"))
    return tmp_path / "cache" / "meshes"


def binary_stl(header: bytes = b"", triangles: int = 1) -> bytes:
    corners = [number for corner in CORNERS for number in corner]
    facet = struct.pack("<12fH", 0, 0, 1, *corners, 0)
    return header.ljust(80, b"\0") + struct.pack("<I", triangles) + facet * triangles


def text_stl(between: str = "") -> bytes:
    vertices = "\n".join(f"vertex {x} {y} {z}" for x, y, z in CORNERS)
    facet = f"facet normal 0 0 1\nouter loop\n{vertices}\nendloop\nendfacet\n"
    return f"solid part of a robot\n{facet}{between}{facet}endsolid\n".encode()


def collada(*, unit: str = "", node: str = "", polygons: str = "triangles", scene: bool = True) -> bytes:
    positions = " ".join(str(number) for corner in CORNERS for number in corner)
    vcount = "<vcount>3</vcount>" if polygons == "polylist" else ""
    shown = (
        '<library_visual_scenes><visual_scene id="s"><node id="n">'
        f'{node}<instance_geometry url="#g"/></node></visual_scene></library_visual_scenes>'
        '<scene><instance_visual_scene url="#s"/></scene>'
    )
    return (
        '<?xml version="1.0"?><COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">'
        f"<asset>{unit}<up_axis>Y_UP</up_axis></asset><library_geometries>"
        f'<geometry id="g"><mesh><source id="p"><float_array id="f" count="9">{positions}</float_array>'
        '<technique_common><accessor source="#f" count="3" stride="3"/></technique_common></source>'
        '<vertices id="v"><input semantic="POSITION" source="#p"/></vertices>'
        f'<{polygons} count="1"><input semantic="VERTEX" source="#v" offset="0"/>{vcount}<p>0 1 2</p></{polygons}>'
        f"</mesh></geometry></library_geometries>{shown if scene else ''}</COLLADA>"
    ).encode()


def gltf(**node: object) -> bytes:
    position = {"count": 3, "min": WEDGE.low, "max": WEDGE.high, "type": "VEC3", "componentType": 5126}
    primitive = {"attributes": {"POSITION": 0}}
    return json.dumps(
        {
            "asset": {"version": "2.0"},
            "scene": 0,
            "scenes": [{"nodes": [0]}],
            "nodes": [{"mesh": 0, **node}],
            "meshes": [{"primitives": [primitive]}],
            "accessors": [position],
        }
    ).encode()


def glb(text: bytes) -> bytes:
    text += b" " * (-len(text) % 4)
    return struct.pack("<4sIII4s", b"glTF", 2, 20 + len(text), len(text), b"JSON") + text


def written(folder: Path, name: str, content: bytes) -> Path:
    path = folder / name
    path.write_bytes(content)
    return path


@pytest.mark.parametrize(
    ("name", "content", "form", "triangles"),
    [
        ("a.stl", binary_stl(triangles=3), "STL", 3),
        ("a.STL", binary_stl(b"solid but binary", 2), "STL", 2),
        ("a.stl", text_stl(), "STL", 2),
        ("a.stl", text_stl("endsolid\nsolid second\n"), "STL", 2),
        ("a.obj", b"# quad\nv 0 0 0\nv 2 0 0 1 0 0\nv 2 3 -1\nv 0 3 0\nf 1//1 2//1 3//1 4//1\n", "OBJ", 2),
        ("a.dae", collada(), "COLLADA", 1),
        ("a.dae", collada(polygons="polylist"), "COLLADA", 1),
        ("a.dae", collada(scene=False), "COLLADA", 1),
        ("a.gltf", gltf(), "glTF", 1),
        ("a.glb", glb(gltf()), "GLB", 1),
    ],
)
def test_bounds_and_triangles(tmp_path: Path, name: str, content: bytes, form: str, triangles: int) -> None:
    mesh = read_mesh(written(tmp_path, name, content))
    assert (mesh.format, mesh.bounds, mesh.triangles, mesh.fault) == (form, WEDGE, triangles, "")


@pytest.mark.parametrize(
    "spelling", ["1", "1.5", "-.25", "5.", "+7", "1e-3", "-1.5E+2", "2.5e0", "0." + "1" * 30]
)
def test_long_texts_have_numbers_of_every_spelling(tmp_path: Path, spelling: str) -> None:
    vertices = f"v 0 0 0\nv\t{spelling}  9.25 -1.5e-1 \r\n" * 200
    mesh = read_mesh(written(tmp_path, "a.obj", f"{vertices}f 1 2 3\nf 3 4 5 6\n".encode()))
    low, high = sorted((0.0, float(spelling)))
    assert mesh.bounds == Box((low, 0.0, -0.15), (high, 9.25, 0.0))
    assert mesh.triangles == 3


@pytest.mark.parametrize("spelling", ["1.2.3", "1e", "--1", ".", "1e5e6x", "v", "1_0"])
def test_long_texts_with_other_words_cannot_be_decoded(tmp_path: Path, spelling: str) -> None:
    text = f"v 0 0 0\nv {spelling} 1 2\n" + "v 0 0.5 0\n" * 200 + "f 1 2 3\n"
    assert read_mesh(written(tmp_path, "a.obj", text.encode())).fault == "cannot be decoded"


def test_normals_of_a_text_stl_need_not_be_numbers(tmp_path: Path) -> None:
    content = text_stl(text_stl().decode().partition("\n")[2] * 20).replace(
        b"normal 0 0 1", b"normal nan nan x"
    )
    assert read_mesh(written(tmp_path, "a.stl", content)).bounds == WEDGE


def test_the_unit_of_collada_is_applied_and_its_up_axis_is_not(tmp_path: Path) -> None:
    mesh = read_mesh(written(tmp_path, "a.dae", collada(unit='<unit name="millimeter" meter="0.001"/>')))
    assert mesh.unit == 0.001
    assert mesh.bounds is not None
    assert mesh.bounds.high == pytest.approx((0.002, 0.003, 0))


@pytest.mark.parametrize(
    ("node", "low", "high"),
    [
        ("<translate>1 0 0</translate><scale>1 2 1</scale>", (1, 0, -1), (3, 6, 0)),
        ("<rotate>0 0 1 90</rotate>", (-3, 0, -1), (0, 2, 0)),
        ("<matrix>1 0 0 5 0 1 0 0 0 0 1 0 0 0 0 1</matrix>", (5, 0, -1), (7, 3, 0)),
    ],
)
def test_the_nodes_of_collada_place_its_geometries(
    tmp_path: Path, node: str, low: tuple[float, ...], high: tuple[float, ...]
) -> None:
    bounds = read_mesh(written(tmp_path, "a.dae", collada(node=node))).bounds
    assert bounds is not None
    assert bounds.low == pytest.approx(low, abs=1e-9)
    assert bounds.high == pytest.approx(high, abs=1e-9)


def test_geometries_of_collada_with_the_same_names_inside_have_their_own_points(tmp_path: Path) -> None:
    text = collada(scene=False).decode()
    geometry = text[text.index("<geometry") : text.index("</library_geometries>")]
    (x, y, z), *_ = CORNERS
    other = geometry.replace('id="g"', 'id="h"').replace(f"{x} {y} {z}", "9.0 0.0 0.0", 1)
    path = written(tmp_path, "a.dae", text.replace(geometry, geometry + other).encode())
    found, alone = read_mesh(path).bounds, read_mesh(written(tmp_path, "b.dae", text.encode())).bounds
    assert found is not None
    assert alone is not None
    assert (found.low, found.high[0]) == (alone.low, 9.0)
    skin = read_skin(path)
    assert skin is not None
    assert skin.points[:, 0].max() > 3


def test_the_nodes_of_gltf_place_its_meshes(tmp_path: Path) -> None:
    half = 0.5**0.5
    content = gltf(translation=[0, 0, 10], rotation=[0, 0, half, half], scale=[2, 1, 1])
    mesh = read_mesh(written(tmp_path, "a.gltf", content))
    assert mesh.bounds is not None
    assert mesh.bounds.low == pytest.approx((-3, 0, 9), abs=1e-9)
    assert mesh.bounds.high == pytest.approx((0, 4, 10), abs=1e-9)
    assert not mesh.is_upright


@pytest.mark.parametrize(
    ("name", "content", "fault"),
    [
        ("a.stl", b"", "is empty"),
        ("a.stl", b"not a mesh", "is not an STL file"),
        ("a.stl", binary_stl(triangles=4)[:-30], "ends after 3 of the 4 triangles that its header announces"),
        ("a.stl", binary_stl(triangles=0), "has no triangle"),
        ("a.stl", b"version https://git-lfs.github.com/spec/v1\noid sha256:0\n", "is a pointer of Git LFS"),
        ("a.obj", b"v 0 0 0\nv 1 x 0\nf 1 2 2\n", "cannot be decoded"),
        ("a.obj", b"v 0 0 0\n", "has no face"),
        ("a.obj", b"v 0 0 nan\nf 1 1 1\n", "has coordinates that are not finite numbers"),
        ("a.dae", b"<COLLADA><asset>", "is not well-formed XML"),
        ("a.dae", b"<html/>", "is not a COLLADA file"),
        ("a.gltf", b'{"asset": ', "is not valid JSON"),
        ("a.glb", b"glTF\2\0\0\0", "ends before its JSON part does"),
    ],
)
def test_faults(tmp_path: Path, name: str, content: bytes, fault: str) -> None:
    mesh = read_mesh(written(tmp_path, name, content))
    assert mesh.bounds is None
    assert fault in mesh.fault


def test_ids_with_brackets_are_read_as_consumers_read_them(tmp_path: Path) -> None:
    content = collada().replace(b'id="n"', b'id="<n>"')
    assert read_mesh(written(tmp_path, "a.dae", content)).bounds == WEDGE


def test_the_content_says_what_a_file_is_not_its_ending(tmp_path: Path) -> None:
    assert read_mesh(written(tmp_path, "a.stl", collada())).format == "COLLADA"
    assert read_mesh(written(tmp_path, "a.dae", binary_stl())).format == "STL"


def test_a_format_that_is_not_known_has_no_fault(tmp_path: Path) -> None:
    assert read_mesh(written(tmp_path, "a.fbx", b"Kaydara FBX Binary")) == Mesh("")


def test_a_ring_of_nodes_ends(tmp_path: Path) -> None:
    content = collada(node='<instance_node url="#n"/>')
    assert read_mesh(written(tmp_path, "a.dae", content)).bounds == WEDGE


def test_an_entity_is_not_resolved(tmp_path: Path) -> None:
    (tmp_path / "secret").write_text("0 0 0 9 9 9")
    head = b'<!DOCTYPE COLLADA [<!ENTITY e SYSTEM "secret">]>'
    content = collada().replace(b"<COLLADA", head + b"<COLLADA").replace(b"0.0 0.0 0.0 ", b"&e; ")
    bounds = read_mesh(written(tmp_path, "a.dae", content)).bounds
    assert bounds is None or max(bounds.high) < 9


def test_measurements_are_kept_until_the_file_changes(tmp_path: Path, cache: Path) -> None:
    path = written(tmp_path, "a.stl", binary_stl())
    assert mesh_at(path).triangles == 1
    (kept,) = cache.iterdir()
    kept.write_text(kept.read_text().replace('"STL"', '"from the cache"'))
    assert mesh_at(path)._replace(stamp="") == Mesh("from the cache", WEDGE, 1)
    path.write_bytes(binary_stl(triangles=2))
    assert mesh_at(path)._replace(stamp="") == Mesh("STL", WEDGE, 2)
    assert len(list(cache.iterdir())) == 1


@pytest.mark.parametrize("rubbish", [b"", b"\xff", b"[1]", b'["x"]', b'{"edition": 5, "rows": {"a.stl": 1}}'])
def test_a_broken_cache_does_not_matter(tmp_path: Path, cache: Path, rubbish: bytes) -> None:
    path = written(tmp_path, "a.stl", binary_stl())
    mesh_at(path)
    (kept,) = cache.iterdir()
    kept.write_bytes(rubbish)
    assert mesh_at(path)._replace(stamp="") == Mesh("STL", WEDGE, 1)


def test_no_cache_where_none_can_be(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    path = written(tmp_path, "a.stl", binary_stl())
    for folder in ("", "relative", str(path)):
        monkeypatch.setenv("SDFCHECK_CACHE_DIR", folder)
        assert mesh_at(path).triangles == 1
    assert [each.name for each in tmp_path.iterdir()] == ["a.stl"]


def test_a_file_that_is_gone_or_odd_has_a_fault(tmp_path: Path) -> None:
    assert mesh_at(tmp_path / "a.stl").fault.startswith("cannot be read: ")
    if hasattr(os, "mkfifo"):
        os.mkfifo(tmp_path / "b.stl")
        assert mesh_at(tmp_path / "b.stl").fault == "cannot be read: a pipe, not a file"


def test_boxes() -> None:
    box = Box((0, 0, 0), (1, 2, 3))
    assert box.scaled((-1, 1, 0.5)) == Box((-1, 0, 0), (0, 2, 1.5))
    assert box.distance_to((1, 5, 7)) == 5
    assert box.distance_to(Box((0.5, 1, 1), (9, 9, 9))) == 0
    assert around([None, box, Box((-1, 1, 1), (0, 1, 9))]) == Box((-1, 0, 0), (1, 2, 9))
    assert around([None]) is None


COLLADA_WITH_PICTURES = """
<COLLADA><library_images>
<image><init_from>file://a%20b.png</init_from><extra><k>Map</k></extra></image>
<image><init_from><ref>c.png</ref></init_from></image></library_images>
<geometry id="g"><mesh><source id="p"><float_array>0 0 0 1 0 0 0 1 1</float_array></source>
<vertices id="v"><input semantic="POSITION" source="#p"/></vertices><triangles count="1"/></mesh></geometry></COLLADA>
"""
GLTF_WITH_BUFFERS = """
{"asset": {}, "buffers": [{"uri": "a%20b.bin"}, {"uri": "data:;base64,AA=="}], "images": [{"uri": "c.png"}],
"accessors": [{"count": 3, "min": [0, 0, 0], "max": [1, 1, 1]}], "nodes": [{"mesh": 0}],
"meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}]}
"""


@pytest.mark.parametrize(
    ("name", "text", "files"),
    [
        (
            "a.obj",
            "mtllib a b.mtl\r\nmtllib c.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 1\nf 1 2 3\n",
            ("a b.mtl", "c.mtl"),
        ),
        ("a.dae", COLLADA_WITH_PICTURES, ("a b.png", "c.png")),
        ("a.gltf", GLTF_WITH_BUFFERS, ("a b.bin", "c.png")),
    ],
)
def test_the_files_that_a_mesh_names(tmp_path: Path, name: str, text: str, files: tuple[str, ...]) -> None:
    (tmp_path / name).write_bytes(text.encode())
    assert read_mesh(tmp_path / name).files == files
    assert [mesh_at(tmp_path / name).files for _ in range(2)] == [files, files]


def filled_glb() -> bytes:
    """The corners in the binary part, with indices behind them."""
    corners = struct.pack("<9f", *(number for corner in CORNERS for number in corner))
    document = {
        "asset": {"version": "2.0"},
        "nodes": [{"mesh": 0, "scale": [2, 2, 2]}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}],
        "accessors": [
            {"bufferView": 0, "count": 3, "min": WEDGE.low, "max": WEDGE.high, "componentType": 5126},
            {"bufferView": 1, "count": 3, "componentType": 5123},
        ],
        "bufferViews": [{"byteLength": 36}, {"byteOffset": 36, "byteLength": 6}],
    }
    head = json.dumps(document).encode()
    head += b" " * (-len(head) % 4)
    binary = corners + struct.pack("<3H", 0, 1, 2)
    chunks = (
        struct.pack("<I", len(head)) + b"JSON" + head + struct.pack("<I", len(binary)) + b"BIN\0" + binary
    )
    return b"glTF" + struct.pack("<II", 2, 12 + len(chunks)) + chunks


OBJ = "".join(f"v {x} {y} {z}\n" for x, y, z in CORNERS).encode()
UNIT = '<unit meter="0.5"/>'


@pytest.mark.parametrize(
    ("name", "data", "scale"),
    [
        ("a.stl", binary_stl(), 1.0),
        ("a.stl", text_stl(), 1.0),
        ("a.obj", OBJ + b"f 1/1 2/2 -1\n", 1.0),
        ("a.obj", OBJ + b"v 0 3 -1\nf 1 2 3 4\n", 1.0),
        ("a.obj", OBJ + b"vt 0 0\nf 1//1 2//1 3/1/1\n", 1.0),
        ("a.dae", collada(), 1.0),
        ("a.dae", collada(polygons="polylist", unit=UNIT), 0.5),
        ("a.dae", collada(polygons="polygons", node="<scale>3 3 3</scale>"), 3.0),
        ("a.glb", filled_glb(), 2.0),
    ],
)
def test_a_skin_has_points_on_the_triangles(tmp_path: Path, name: str, data: bytes, scale: float) -> None:
    path = tmp_path / name
    path.write_bytes(data)
    first, kept = skin_at(path), skin_at(path)
    assert first is not None
    assert kept is not None
    triangle = np.array(CORNERS) * scale
    normal = np.cross(triangle[1], triangle[2])
    assert np.abs(first.points @ normal).max() < 0.01 * scale * np.linalg.norm(normal)
    assert np.allclose(np.abs(first.normals @ normal), np.linalg.norm(normal), rtol=1e-4)
    copies = round(first.areas.sum() / (np.linalg.norm(normal) / 2))
    assert copies == (2 if data == text_stl() else 1)
    assert (kept.points == first.points).all()
    assert kept.areas.sum() == pytest.approx(first.areas.sum())


@pytest.mark.parametrize(
    ("name", "data"),
    [("a.obj", OBJ + b"f 1 2 9\n"), ("a.glb", filled_glb()[:-4]), ("a.dae", b"<COLLADA"), ("a.stl", b"")],
)
def test_a_mesh_without_triangles_has_no_skin(tmp_path: Path, name: str, data: bytes) -> None:
    path = tmp_path / name
    path.write_bytes(data)
    assert skin_at(path) is None
    assert skin_at(tmp_path / "missing.stl") is None


@pytest.mark.parametrize(
    ("name", "data"),
    [
        ("a.dae", collada(node='<instance_geometry url="#g"/>' * 6000)),
        ("a.obj", OBJ + b"# \n" * 12_000_000),
        ("a.dae", collada(polygons="polylist").replace(b"<vcount>3<", b"<vcount>700000000<")),
        ("a.dae", collada(polygons="polylist").replace(b"<vcount>3<", b"<vcount>-5 8<")),
    ],
)
def test_a_file_that_would_take_long_has_no_skin(tmp_path: Path, name: str, data: bytes) -> None:
    start = time.process_time()
    assert skin_at(written(tmp_path, name, data)) is None
    assert time.process_time() - start < 5


def moved(x: float) -> npt.NDArray[np.float64]:
    pose = np.eye(4)
    pose[0, 3] = x
    return pose


@pytest.mark.parametrize(
    ("kind", "size", "area"),
    [
        ("box", (1, 1, 1), 6),
        ("sphere", (0.5,), math.pi),
        ("cylinder", (0.5, 1), 1.5 * math.pi),
        ("capsule", (0.5, 1), 2 * math.pi),
    ],
)
def test_skins_of_shapes_know_what_is_near_and_inside(
    kind: str, size: tuple[float, ...], area: float
) -> None:
    skin, small = of_shape(kind, size), of_shape("sphere", (0.1,))
    assert skin is not None
    assert small is not None
    assert skin.areas.sum() == pytest.approx(area, rel=0.02)
    assert small.share_in(skin) == 1
    assert skin.share_in(small) == 0
    assert small.scaled((-1, 1, 1)).moved(moved(0.2)).share_in(skin) == 1
    assert 0.2 < small.moved(moved(0.5)).share_in(skin) < 0.8
    assert skin.is_near(small.moved(moved(0.6)), 0.05)
    assert not skin.is_near(small.moved(moved(0.9)), 0.05)
    assert not skin.is_near(small.moved(moved(9.0)), 0.05)
    assert skin.distance_to(small.moved(moved(0.9))) == pytest.approx(0.3, abs=0.06)


def test_a_skin_knows_the_moments_of_what_it_holds() -> None:
    skin = of_shape("box", (0.6, 0.3, 0.2))
    assert skin is not None
    moments = np.diag([0.13, 0.40, 0.45]) / 12
    place = moved(1)
    place[:3, :3] = about_axis((0.0, 0.6, 0.8), 0.7)
    for way in (1, -1):  # normals may point inwards
        turned = skin._replace(normals=way * skin.normals).moved(place)
        expected = place[:3, :3] @ moments @ place[:3, :3].T
        assert turned.filled is not None
        assert turned.filled[:3] == pytest.approx(np.diag(expected), rel=0.05)
        assert turned.filled[3:] == pytest.approx(expected[(0, 0, 1), (1, 2, 2)], abs=0.001)
    flat = skin.scaled((1, 1, 1e-6))
    assert flat.filled is None


def test_other_shapes_have_no_skin() -> None:
    assert of_shape("plane", (1, 1)) is None
    assert together([]) is None


def test_measurements_of_a_folder_are_in_one_file_that_does_not_grow_without_end(
    tmp_path: Path, cache: Path
) -> None:
    paths = [written(tmp_path, f"{number}.stl", binary_stl()) for number in range(3)]
    shelves = Shelves()
    for path in paths:
        mesh_at(path, shelves=shelves, with_skin=True)
    assert not cache.exists()
    shelves.save()
    assert len(list(cache.iterdir())) == 2
    assert [
        Shelves().find(str(tmp_path), path.name, "-bounds", mesh_at(path).stamp) is not None for path in paths
    ] == [True] * 3
    shelves.keep(str(tmp_path), "a", "-bounds", ["1", 2], most=2)
    shelves.save()
    found = [Shelves().find(str(tmp_path), name, "-bounds", "1") for name in ("a", "0.stl")]
    assert found == [[2], None]
    (kept,) = cache.glob("*-bounds*")
    assert list(json.loads(kept.read_text())["rows"]) == ["2.stl", "a"]


def test_a_file_that_a_visual_and_a_collision_share_is_read_once(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    measure = Mock(wraps=mesh._content)
    monkeypatch.setattr(mesh, "_content", measure)
    shape = '<geometry><mesh filename="a.stl"/></geometry>'
    written(tmp_path, "a.stl", binary_stl())
    text = f'<robot name="r"><link name="a"><collision>{shape}</collision><visual>{shape}</visual></link></robot>'
    (robot,) = root_of(opened(written(tmp_path, "r.urdf", text.encode()))).each(Model)
    link = robot.links[0]
    assert link.collision_box == link.visual_box == WEDGE
    assert link.skin is not None
    assert measure.call_count == 1


def test_the_oldest_measurements_give_way(
    tmp_path: Path, cache: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("sdfcheck.files.library._MOST_SHELVES", 2)
    places: list[Path] = []
    for number, folder in enumerate("abc"):
        (tmp_path / folder).mkdir()
        mesh_at(written(tmp_path / folder, "a.stl", binary_stl()))
        places += (path for path in cache.iterdir() if path not in places)
        os.utime(places[-1], (number, number))
    assert sorted(cache.iterdir()) == sorted(places[1:])

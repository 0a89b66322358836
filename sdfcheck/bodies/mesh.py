"""The bounds of mesh files and the number of their triangles, by their content.

Read are STL (binary and text), OBJ, COLLADA, glTF and GLB: headers and accessors where they say
enough, else the coordinates. Lengths are in m as RViz and Gazebo take them: COLLADA's ``unit`` is
applied, its ``up_axis`` is not (https://github.com/ros-visualization/rviz/issues/1045,
https://github.com/gazebosim/gazebo-classic/issues/1305).
"""

from __future__ import annotations

import json
import math
import os
import re
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from itertools import islice, pairwise
from pathlib import Path
from typing import TYPE_CHECKING, Any, BinaryIO, Generic, TypeAlias, TypeVar
from urllib.parse import unquote

from sdfcheck.bodies.box import Box, around
from sdfcheck.files.overwrite import overwrite
from sdfcheck.files.regular import MEGABYTE, open_regular, read_on, read_regular
from sdfcheck.source.record import NamedTuple

if TYPE_CHECKING:
    import numpy as np
    import numpy.typing as npt

    from sdfcheck.bodies.solid import Skin

    Points: TypeAlias = npt.NDArray[np.float64]

LIMIT = 128 * MEGABYTE
"""Larger files are not measured."""
ENDINGS = {".stl": "STL", ".obj": "OBJ", ".dae": "COLLADA", ".gltf": "glTF", ".glb": "GLB"}
"""Ending of a file's name → the format that it promises."""
_POINTER = "is a pointer of Git LFS, not the file itself"
_DEPTH = 200
"""Nodes in nodes that are followed."""
_MOST_FILES = 100
"""Files that one names."""
_MOST = 20_000
"""Parts of one file that are placed."""


class Mesh(NamedTuple):
    """The content of a mesh file."""

    format: str
    """``STL``, ``OBJ``, ``COLLADA``, ``glTF``, ``GLB``; empty for what is not recognized."""
    bounds: Box | None = None
    """Without the scale that a description gives; None where nothing is known."""
    triangles: int = 0
    fault: str = ""
    """The reason why a consumer cannot read it; empty where there is none, or the format is not known."""
    unit: float = 1.0
    """m for each unit of length in the file, which COLLADA alone says; it is applied to ``bounds``."""
    is_upright: bool = True
    """Do consumers agree on its axes? Not for glTF, which has y up."""
    files: tuple[str, ...] = ()
    """The files that it names: libraries of materials, pictures, buffers."""

    @property
    def is_pointer(self) -> bool:
        """Is only a pointer of Git LFS here, and the file itself elsewhere?"""
        return self.fault == _POINTER


class Faulty(ValueError):
    """A file that is not what its format demands; the text says why."""


Read = Callable[[Path, int], bytes]
Open = Callable[[Path, int], BinaryIO]
"""Read, or open, a file of at most so many bytes; raise OSError."""


def read_mesh(path: Path, read: Read = read_regular) -> Mesh:
    """Measure a mesh file. Raises OSError where it cannot be read."""
    data = read(path, LIMIT)
    promised = ENDINGS.get(path.suffix.lower(), "")
    if not data:
        return Mesh(promised, fault="is empty")
    if data.startswith(b"version https://git-lfs"):
        return Mesh("", fault=_POINTER)
    found = _format(data, promised)
    if not found:
        return Mesh("", fault=f"is not {_article(promised)} file" if promised else "")
    try:
        return _READERS[found](data)
    except Faulty as error:
        return Mesh(found, fault=str(error))
    except (ArithmeticError, IndexError, KeyError, RecursionError, TypeError, ValueError, AttributeError):
        return Mesh(found, fault="cannot be decoded")


def _article(name: str) -> str:
    return f"an {name}" if name[0] in "SO" else f"a {name}"


def _format(data: bytes, promised: str) -> str:
    """The format of a content; that of the ending where the content does not decide."""
    if data.startswith(b"glTF"):
        return "GLB"
    head = data[:4096].lstrip(b"\xef\xbb\xbf \t\r\n")
    if head.startswith(b"{"):
        return "glTF" if b'"asset"' in data else ""
    if head.startswith(b"<"):
        return "COLLADA" if b"<COLLADA" in data[:65536] else ""
    if _is_binary_stl(data, promised):
        return "STL"
    if head[:5].lower() == b"solid" and (b"facet" in data[:65536] or b"endsolid" in data[:65536]):
        return "STL"
    return "OBJ" if re.search(rb"^[ \t]*v[ \t]+[-+.\d]", data, re.MULTILINE) else ""


def _is_binary_stl(data: bytes, promised: str) -> bool:
    if len(data) < 84:
        return False
    needed = 84 + 50 * int.from_bytes(data[80:84], "little")
    is_text = data[:5].lower() == b"solid" and b"facet" in data[:4096]
    return needed == len(data) or (promised == "STL" and not is_text and b"\0" in data[:4096])


def _read_stl(data: bytes) -> Mesh:
    if not _is_binary_stl(data, "STL"):
        return _read_text_stl(data)
    count = int.from_bytes(data[80:84], "little")
    there = (len(data) - 84) // 50
    if count > there:
        raise Faulty(f"ends after {there} of the {count} triangles that its header announces")
    if not count:
        raise Faulty("has no triangle")
    return Mesh("STL", _bounds(_stl_corners(data, count)), count)


def _stl_corners(data: bytes, count: int) -> Any:
    """The corners of a binary STL's triangles, shape (3 n, 3)."""
    import numpy as np

    row = np.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("attribute", "<u2")])
    return np.frombuffer(data, row, count, 84)["corners"].reshape(-1, 3)


_FACET = 21
"""Words of a facet in a text STL: facet normal x y z outer loop, three times vertex x y z, endloop endfacet."""


def _read_text_stl(data: bytes) -> Mesh:
    corners = _text_stl_corners(data)
    return Mesh("STL", _bounds(corners), len(corners) // 3)


def _text_stl_corners(data: bytes) -> Points:
    import numpy as np

    start, end = data.lower().find(b"facet"), data.lower().rfind(b"endfacet")
    if start < 0 or end < 0:
        raise Faulty("has no triangle")
    words = data[start : end + len(b"endfacet")].split()
    columns = [8, 9, 10, 12, 13, 14, 16, 17, 18]
    if len(words) % _FACET == 0 and {word.lower() for word in words[7::_FACET]} == {b"vertex"}:
        return np.array(words).reshape(-1, _FACET)[:, columns].astype(float).reshape(-1, 3)
    # several solids, or comments
    found = re.findall(rb"vertex\s+(\S+)\s+(\S+)\s+(\S+)", data, re.IGNORECASE)
    return np.array(found).astype(float).reshape(-1, 3)


def _read_obj(data: bytes) -> Mesh:
    corners, faces = _obj_parts(data)
    triangles = sum(max(len(face.split()) - 2, 0) for face in faces)
    if not triangles:
        raise Faulty("has no face")
    named = re.findall(rb"^[ \t]*mtllib[ \t]+(.+?)[ \t\r]*$", data, re.MULTILINE)
    return Mesh(
        "OBJ", _bounds(corners), triangles, files=_names(name.decode(errors="replace") for name in named)
    )


def _obj_parts(data: bytes) -> tuple[Points, list[bytes]]:
    """The corners (n, 3) of an OBJ file, and the texts of its faces."""
    import numpy as np

    rows = [line.split()[:3] for line in re.findall(rb"^[ \t]*v[ \t]+(.+)$", data, re.MULTILINE)]
    corners = np.array(rows).astype(float).reshape(-1, 3)
    return corners, re.findall(rb"^[ \t]*f[ \t]+(.+)$", data, re.MULTILINE)


def _read_collada(data: bytes) -> Mesh:
    return _collada(data).mesh()


def _collada(data: bytes) -> _Collada:
    from lxml import etree

    try:
        # Entities are not resolved and nothing is fetched.
        parser = etree.XMLParser(
            resolve_entities=False, no_network=True, huge_tree=True, remove_comments=True
        )
        root = etree.fromstring(data, parser)
    except etree.XMLSyntaxError as error:
        raise Faulty(f"is not well-formed XML ({error.msg})") from None
    return _Collada(root)


class _Collada:
    """The geometries of a COLLADA file, and the nodes that place them."""

    def __init__(self, root: Any) -> None:
        self.root = root
        self.named = {element.get("id"): element for element in root.iter() if element.get("id")}
        self.measured: dict[Any, tuple[Box | None, int]] = {}
        self.points: dict[Any, Points | None] = {}
        self.corners: dict[Any, list[Points]] = {}

    @property
    def meter(self) -> float:
        """m for each unit of length."""
        unit = next(self._all(self.root, "unit"), None)
        return float(unit.get("meter", 1)) if unit is not None else 1.0

    def mesh(self) -> Mesh:
        import numpy as np

        meter = self.meter
        boxes: list[Points] = []
        triangles = 0
        for transform, geometry in self._placed():
            box, count = self._geometry(geometry)
            triangles += count
            if box is not None:
                corners = np.array(list(box.corners()))
                boxes.append(corners @ transform[:3, :3].T + transform[:3, 3])
        if not boxes:
            raise Faulty("has no triangle")
        named = (each for image in self._all(self.root, "image") for each in self._all(image, "init_from"))
        texts = (each.text or "".join(ref.text or "" for ref in self._all(each, "ref")) for each in named)
        files = _names(unquote(text).strip().removeprefix("file://") for text in texts)
        return Mesh("COLLADA", _bounds(np.concatenate(boxes) * meter), triangles, unit=meter, files=files)

    def _placed(self) -> Iterator[tuple[Points, Any]]:
        """Each geometry with its 4×4 transform; without a scene, all as they are."""
        import numpy as np

        scenes = list(self._all(self.root, "visual_scene"))
        shown = next((self._target(each) for each in self._all(self.root, "instance_visual_scene")), None)
        scene = shown if shown is not None else next(iter(scenes), None)
        waiting = [(np.eye(4), scene, 0)] if scene is not None else []
        count = 0
        while waiting:
            above, node, depth = waiting.pop()
            here = above @ _transform(node)
            for child in node:
                name = _name(child)
                target = self._target(child) if name.startswith("instance_") else None
                count += 1
                if count > _MOST:
                    return
                if name == "node" and depth < _DEPTH:
                    waiting.append((here, child, depth + 1))
                elif name == "instance_node" and target is not None and depth < _DEPTH:
                    waiting.append((here, target, depth + 1))
                elif name in {"instance_geometry", "instance_controller"} and target is not None:
                    yield here, target
        if scene is None:
            yield from ((np.eye(4), each) for each in self._all(self.root, "geometry"))

    def _geometry(self, element: Any) -> tuple[Box | None, int]:
        """The bounds of a geometry, or of that of a controller, and its triangles."""
        element = self._unskinned(element)
        if element not in self.measured:
            points = (self._positions(vertices) for vertices in self._all(element, "vertices"))
            box = around(_bounds(each) for each in points if each is not None)
            self.measured[element] = box, sum(map(_triangles, element.iter()))
        return self.measured[element]

    def _unskinned(self, element: Any) -> Any:
        """The geometry of a controller."""
        skin = next(self._all(element, "skin"), None) if _name(element) == "controller" else None
        source = self.named.get(skin.get("source", "")[1:]) if skin is not None else None
        return source if source is not None and _name(source) == "geometry" else element

    def _positions(self, vertices: Any) -> Points | None:
        """The positions (n, 3) of ``vertices``."""
        inputs = (each for each in self._all(vertices, "input") if each.get("semantic") == "POSITION")
        source = next((self._target(each, "source") for each in inputs), None)
        floats = next(self._all(source, "float_array"), None) if source is not None else None
        if source is None or floats is None or not (floats.text or "").strip():
            return None
        accessor = next(self._all(source, "accessor"), None)
        stride = int(accessor.get("stride", 3)) if accessor is not None else 3
        numbers = _numbers(floats.text)
        return numbers[: len(numbers) // stride * stride].reshape(-1, stride)[:, :3]

    def triangles(self) -> Iterator[Points]:
        """The triangles (n, 3, 3) of each primitive (m)."""
        meter = self.meter
        for transform, placed in self._placed():
            element = self._unskinned(placed)
            if element not in self.corners:  # which may be placed often
                parts = (self._corners(each) for each in element.iter() if _triangles(each))
                self.corners[element] = [part for part in parts if part is not None and len(part)]
            for part in self.corners[element]:
                yield (part @ transform[:3, :3].T + transform[:3, 3]) * meter

    def _corners(self, primitive: Any) -> Points | None:
        """The triangles of one primitive, in its own frame."""
        import numpy as np

        inputs = [each for each in primitive if _name(each) == "input"]
        vertex = next((each for each in inputs if each.get("semantic") == "VERTEX"), None)
        vertices = self._target(vertex, "source") if vertex is not None else None
        if vertices not in self.points:
            self.points[vertices] = self._positions(vertices) if vertices is not None else None
        points = self.points[vertices]
        if vertex is None or points is None:
            return None
        stride = 1 + max(int(each.get("offset", 0)) for each in inputs)
        rows = [_numbers(each.text or "").astype(int) for each in primitive if _name(each) == "p"]
        corners = [row[int(vertex.get("offset", 0)) :: stride] for row in rows]
        sides = next((_numbers(each.text or "") for each in primitive if _name(each) == "vcount"), None)
        if _name(primitive) == "triangles":
            return np.asarray(points[corners[0][: len(corners[0]) // 3 * 3].reshape(-1, 3)])
        counts = sides.astype(int).tolist() if sides is not None else list(map(len, corners))
        return np.asarray(points[_fans(counts, [corner for row in corners for corner in row.tolist()])])

    def _target(self, element: Any, attribute: str = "url") -> Any:
        return self.named.get((element.get(attribute) or "").lstrip("#"))

    @staticmethod
    def _all(element: Any, name: str) -> Iterator[Any]:
        return iter(element.iter(f"{{*}}{name}"))


def _name(element: Any) -> str:
    tag = element.tag
    return tag.rpartition("}")[2] if isinstance(tag, str) else ""


def _triangles(element: Any) -> int:
    """The triangles of one primitive of COLLADA."""
    name = _name(element)
    if name not in {"triangles", "polylist", "polygons", "trifans", "tristrips"}:
        return 0
    count = int(element.get("count") or 0)
    if name == "polylist":
        sides = next((child.text or "" for child in element if _name(child) == "vcount"), "").split()
        return sum(map(int, sides)) - 2 * len(sides)
    return count


def _transform(node: Any) -> Points:
    """The 4×4 transform of a node: its matrices, translations, rotations and scales in their order."""
    import numpy as np

    result = np.eye(4)
    for child in node:
        name = _name(child)
        if name not in {"matrix", "translate", "rotate", "scale"}:
            continue
        numbers = _numbers(child.text or "")
        step = np.eye(4)
        if name == "matrix":
            step = numbers.reshape(4, 4)
        elif name == "translate":
            step[:3, 3] = numbers
        elif name == "scale":
            step[:3, :3] = np.diag(numbers)
        else:
            step[:3, :3] = _turn(numbers[:3], math.radians(numbers[3]))
        result = result @ step
    return result


def _turn(axis: Points, angle: float) -> Points:
    import numpy as np

    length = float(np.linalg.norm(axis))
    if not length:
        return np.eye(3)
    x, y, z = axis / length
    cross = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    return np.asarray(np.eye(3) + math.sin(angle) * cross + (1 - math.cos(angle)) * (cross @ cross))


def _fans(counts: Sequence[int], corners: Sequence[int]) -> Any:
    """The triangles (n, 3) of polygons with so many corners each."""
    import numpy as np

    if set(counts) == {3}:
        return np.array(corners[: 3 * len(counts)]).reshape(-1, 3)
    starts, found = 0, []
    for count in counts:
        first, *others = corners[starts : starts + count]
        found += [(first, *pair) for pair in pairwise(others)]
        starts += count
    return np.array(found, dtype=int).reshape(-1, 3)


def _read_glb(data: bytes) -> Mesh:
    length, kind = int.from_bytes(data[12:16], "little"), data[16:20]
    if kind != b"JSON" or len(data) < 20 + length:
        raise Faulty("ends before its JSON part does")
    return _read_gltf(data[20 : 20 + length])._replace(format="GLB")


def _read_gltf(data: bytes) -> Mesh:
    import numpy as np

    try:
        document = json.loads(data)
    except ValueError:
        raise Faulty("is not valid JSON") from None
    boxes: list[Points] = []
    triangles = 0
    for transform, primitive in _gltf_primitives(document):
        accessors = document["accessors"]
        position = accessors[primitive["attributes"]["POSITION"]]
        indices = accessors[primitive["indices"]] if "indices" in primitive else position
        triangles += int(indices["count"]) // 3
        corners = np.array(list(Box(tuple(position["min"]), tuple(position["max"])).corners()))
        boxes.append(corners @ transform[:3, :3].T + transform[:3, 3])
    if not boxes:
        raise Faulty("has no triangle")
    named = (each.get("uri", "") for kind in ("buffers", "images") for each in document.get(kind, ()))
    files = _names(unquote(name) for name in named if not name.startswith("data:"))
    return Mesh("glTF", _bounds(np.concatenate(boxes)), triangles, is_upright=False, files=files)


_INDICES = {5121: "<u1", 5123: "<u2", 5125: "<u4"}


def _gltf_triangles(document: Mapping[str, Any], buffer: bytes) -> Iterator[Points]:
    """The triangles (n, 3, 3) of each primitive (m); all must be in one buffer."""
    import numpy as np

    def read(number: int, kind: str, width: int) -> Any:
        accessor = document["accessors"][number]
        view = document["bufferViews"][accessor["bufferView"]]
        row = np.dtype((kind, (width,)))
        start = view.get("byteOffset", 0) + accessor.get("byteOffset", 0)
        steps = (view.get("byteStride") or row.itemsize, np.dtype(kind).itemsize)
        size = view.get("byteOffset", 0) + view["byteLength"]
        return np.ndarray((accessor["count"], width), kind, buffer[:size], start, steps)

    for transform, primitive in _gltf_primitives(document):
        if primitive.get("mode", 4) != 4:
            continue
        points = read(primitive["attributes"]["POSITION"], "<f4", 3) @ transform[:3, :3].T + transform[:3, 3]
        if "indices" in primitive:
            kind = _INDICES[document["accessors"][primitive["indices"]]["componentType"]]
            points = points[read(primitive["indices"], kind, 1)[:, 0]]
        yield points[: len(points) // 3 * 3].reshape(-1, 3, 3)


def _names(found: Iterable[str]) -> tuple[str, ...]:
    """The first names that are not empty, each once."""
    return tuple(dict.fromkeys(islice((name.strip() for name in found if name.strip()), _MOST_FILES)))


def _gltf_primitives(document: Mapping[str, Any]) -> Iterator[tuple[Points, Mapping[str, Any]]]:
    """The primitives of the scene with their 4×4 transforms."""
    import numpy as np

    nodes: Sequence[Mapping[str, Any]] = document.get("nodes", ())
    scenes = document.get("scenes", ())
    below = {child for node in nodes for child in node.get("children", ())}
    roots = (number for number in range(len(nodes)) if number not in below)
    first = scenes[document.get("scene", 0)].get("nodes", ()) if scenes else tuple(roots)
    waiting = [(np.eye(4), number, 0) for number in first]
    count = 0
    while waiting and count < _MOST:
        above, number, depth = waiting.pop()
        node = nodes[number]
        here = above @ _gltf_transform(node)
        count += 1
        if "mesh" in node:
            yield from ((here, each) for each in document["meshes"][node["mesh"]]["primitives"])
        if depth < _DEPTH:
            waiting += [(here, child, depth + 1) for child in node.get("children", ())]


def _gltf_transform(node: Mapping[str, Any]) -> Points:
    import numpy as np

    if "matrix" in node:
        return np.asarray(np.array(node["matrix"], dtype=float).reshape(4, 4).T)
    result = np.eye(4)
    x, y, z, w = node.get("rotation", (0.0, 0.0, 0.0, 1.0))
    axis = np.array((x, y, z), dtype=float)
    turn = _turn(axis, 2 * math.atan2(float(np.linalg.norm(axis)), w))
    result[:3, :3] = turn @ np.diag(node.get("scale", (1.0, 1.0, 1.0)))
    result[:3, 3] = node.get("translation", (0.0, 0.0, 0.0))
    return result


def _numbers(text: str) -> Points:
    import numpy as np

    return np.array(text.split(), dtype=float)


def _bounds(points: Any) -> Box:
    """The box around points of shape (n, 3)."""
    import numpy as np

    if not len(points):
        raise Faulty("has no triangle")
    low, high = points.min(axis=0), points.max(axis=0)
    if not (np.isfinite(low).all() and np.isfinite(high).all()):
        raise Faulty("has coordinates that are not finite numbers")
    return Box(tuple(map(float, low)), tuple(map(float, high)))


_READERS: dict[str, Callable[[bytes], Mesh]] = {
    "STL": _read_stl,
    "OBJ": _read_obj,
    "COLLADA": _read_collada,
    "glTF": _read_gltf,
    "GLB": _read_glb,
}


def read_skin(path: Path, read: Read = read_regular) -> Skin | None:
    """The skin of a mesh file (m), without scale; None where its triangles are not known. Raises OSError."""
    import numpy as np

    from sdfcheck.bodies.solid import skin_of

    data, found, count = read(path, LIMIT), [], 0
    form = _format(data, ENDINGS.get(path.suffix.lower(), ""))
    if form in {"COLLADA", "OBJ"} and len(data) > _MOST_TEXT:
        return None
    try:
        for part in _each_triangle(data, form):
            found.append(part)
            count += max(len(part), _LEAST_TRIANGLES)
            if count > _MOST_TRIANGLES:
                return None
    except (ArithmeticError, IndexError, KeyError, RecursionError, TypeError, ValueError, AttributeError):
        return None
    return skin_of(np.concatenate(found)) if found else None


_MOST_TEXT = 32 * MEGABYTE
"""Texts take many times their size in memory until they are numbers."""
_MOST_TRIANGLES, _LEAST_TRIANGLES = 5_000_000, 1_000
"""Parts of a file that are placed often would be endless, be they large or small: each counts as so many at least."""


def _each_triangle(data: bytes, form: str) -> Iterator[Points]:
    """The triangles (n, 3, 3) of a file, part by part."""
    if form == "COLLADA":
        yield from _collada(data).triangles()
    elif form == "OBJ":
        corners, faces = _obj_parts(data)
        rows = [[int(corner.split(b"/")[0]) for corner in face.split()] for face in faces]
        numbers = [number - 1 if number > 0 else number for row in rows for number in row]
        yield corners[_fans(list(map(len, rows)), numbers)]
    elif form == "GLB":
        length = int.from_bytes(data[12:16], "little")
        yield from _gltf_triangles(json.loads(data[20 : 20 + length]), data[28 + length :])
    elif form == "STL":
        is_binary = _is_binary_stl(data, "STL")
        corners = _stl_corners(data, (len(data) - 84) // 50) if is_binary else _text_stl_corners(data)
        yield corners[: len(corners) // 3 * 3].reshape(-1, 3, 3)


# Kept from run to run


_SLOTS = 0x4000
"""Meshes in the cache at most: each has its place, and gives way to another one of the same place."""
_T = TypeVar("_T")


@dataclass(frozen=True)
class _Kept(Generic[_T]):
    """A measurement that is kept: the end of its files' names, how it is read, and a row of JSON there and back."""

    ending: str
    read: Callable[[Path, Read], _T]
    packed: Callable[[_T], list[Any]]
    unpacked: Callable[[list[Any]], _T]


def mesh_at(path: Path, open: Open = open_regular) -> Mesh:
    """The content of a mesh file, read again only where its size or time of change is another one.

    It is opened each time, as it may be where this run must not read. A file that cannot be read has a
    ``fault``, and never raises.
    """
    try:
        return _kept_or_read(path, open, _MESH)
    except OSError as error:
        return Mesh("", fault=f"cannot be read: {error.strerror or error}")


def skin_at(path: Path, open: Open = open_regular) -> Skin | None:
    """The skin of a mesh file (m), without scale, likewise; None where it is not known."""
    try:
        return _kept_or_read(path, open, _SKIN)
    except OSError:
        return None


def _kept_or_read(path: Path, open: Open, kind: _Kept[_T]) -> _T:
    with open(path, LIMIT) as stream:
        status = os.fstat(stream.fileno())
        key = f"{_EDITION} {os.path.realpath(path)} {status.st_size} {status.st_mtime_ns}"
        place = _place(key, kind.ending)
        try:
            if place is not None:
                said, *rest = json.loads(read_regular(place, MEGABYTE))
                if said == key:
                    return kind.unpacked(rest)
        except (OSError, ValueError, TypeError, RecursionError):
            pass  # nothing is kept, or that of another one
        row = kind.packed(kind.read(path, lambda file, limit: read_on(stream, file, limit)))
        if place is not None:
            _keep(place, [key, *row])
        return kind.unpacked(row)  # rounded as it is kept, so that every run sees the same


_EDITION = 3
"""To be counted up whenever files are measured in another way."""


def _place(key: str, ending: str) -> Path | None:
    folder = cache_folder()
    if folder is None:
        return None
    from zlib import crc32

    path = key.split(" ", 1)[1].rpartition(" ")[0].rpartition(" ")[0]
    return folder / f"{crc32(path.encode('utf-8', 'surrogateescape')) % _SLOTS:04x}{ending}.json"


def cache_folder() -> Path | None:
    """The folder of kept measurements: that of ``SDFCHECK_CACHE_DIR``, or the user's; None for none."""
    given = os.environ.get("SDFCHECK_CACHE_DIR")
    if given is not None:
        return Path(given, "meshes") if os.path.isabs(given) else None
    if os.name == "nt":
        folder = os.environ.get("LOCALAPPDATA", "")
    else:
        folder = os.environ.get("XDG_CACHE_HOME", "") or os.path.expanduser("~/.cache")
    return Path(folder, "sdfcheck", "meshes") if os.path.isabs(folder) else None


def _keep(place: Path, row: list[Any]) -> None:
    """Write it; where that cannot be, the next run measures again."""
    try:
        os.makedirs(place.parent, exist_ok=True)
        overwrite(place, json.dumps(row).encode("utf-8", "surrogateescape"), instead=True, lasting=False)
    except OSError:
        return


def _packed_mesh(mesh: Mesh) -> list[Any]:
    form, box, *rest = mesh
    return [form, *((box.low, box.high) if box is not None else ((), ())), *rest]


def _unpacked_mesh(row: list[Any]) -> Mesh:
    form, low, high, *rest = row
    found = Mesh(form, Box(tuple(low), tuple(high)) if low else None, *rest)
    return found._replace(files=tuple(found.files))


def _packed_skin(skin: Skin | None) -> list[Any]:
    return [] if skin is None else skin.packed()


def _unpacked_skin(row: list[Any]) -> Skin | None:
    from sdfcheck.bodies.solid import unpacked

    return unpacked(*row) if row else None


_MESH = _Kept("", read_mesh, _packed_mesh, _unpacked_mesh)
_SKIN = _Kept("-skin", read_skin, _packed_skin, _unpacked_skin)

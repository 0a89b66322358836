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
from contextlib import contextmanager, suppress
from itertools import islice
from pathlib import Path
from typing import TYPE_CHECKING, Any, BinaryIO, TypeAlias
from urllib.parse import unquote
from warnings import catch_warnings, simplefilter

from sdfcheck.bodies.box import Box, around
from sdfcheck.files.library import Shelves
from sdfcheck.files.regular import MEGABYTE, Outside, open_regular, read_on, read_regular
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
    stamp: str = ""
    """Tells it from what the file holds at another time; empty for what was not read by ``mesh_at``."""

    @property
    def is_pointer(self) -> bool:
        """Is only a pointer of Git LFS here, and the file itself elsewhere?"""
        return self.fault == _POINTER

    @property
    def is_exact(self) -> bool:
        """Is it a binary STL file without a byte too many, as decoders want it that look at its size first?"""
        size, _, _ = self.stamp.partition(" ")
        return self.format == "STL" and size == str(84 + 50 * self.triangles)


class Faulty(ValueError):
    """A file that is not what its format demands; the text says why."""


Read = Callable[[Path, int], bytes]
Open = Callable[[Path, int], BinaryIO]
"""Read, or open, a file of at most so many bytes; raise OSError."""
if TYPE_CHECKING:
    Content: TypeAlias = tuple[Mesh, Callable[[], Iterable[Points]]]
    """A mesh, and what gives its triangles (n, 3, 3), part by part (m)."""
_DECODING = (
    ArithmeticError,
    AttributeError,
    IndexError,
    KeyError,
    RecursionError,
    TypeError,
    ValueError,
)
"""The errors where a file is not what its format demands."""


def read_mesh(path: Path, read: Read = read_regular) -> Mesh:
    """Measure a mesh file. Raises OSError where it cannot be read."""
    return _content(path, read)[0]


def read_skin(path: Path, read: Read = read_regular) -> Skin | None:
    """The skin of a mesh file (m), without scale; None where its triangles are not known. Raises OSError."""
    return _skin(_content(path, read))


def _content(path: Path, read: Read) -> Content:
    data = read(path, LIMIT)
    promised = ENDINGS.get(path.suffix.lower(), "")
    if not data:
        return Mesh(promised, fault="is empty"), tuple
    if data.startswith(b"version https://git-lfs"):
        return Mesh("", fault=_POINTER), tuple
    found = _format(data, promised)
    if not found:
        return Mesh("", fault=f"is not {_article(promised)} file" if promised else ""), tuple
    try:
        mesh, triangles = _READERS[found](data)
    except Faulty as error:
        return Mesh(found, fault=str(error)), tuple
    except _DECODING:
        return Mesh(found, fault="cannot be decoded"), tuple
    return mesh, tuple if found in {"COLLADA", "OBJ"} and len(data) > _MOST_TEXT else triangles


_MOST_TEXT = 32 * MEGABYTE
"""Texts take many times their size in memory until they are numbers."""
_MOST_TRIANGLES, _LEAST_TRIANGLES = 5_000_000, 1_000
"""Parts of a file that are placed often would be endless, be they large or small: each counts as so many at least."""


def _skin(content: Content) -> Skin | None:
    import numpy as np

    from sdfcheck.bodies.solid import skin_of

    found, count = [], 0
    try:
        for part in content[1]():
            found.append(part)
            count += max(len(part), _LEAST_TRIANGLES)
            if count > _MOST_TRIANGLES:
                return None
    except _DECODING:
        return None
    return skin_of(np.concatenate(found) if len(found) > 1 else found[0]) if found else None


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


def _read_stl(data: bytes) -> Content:
    if not _is_binary_stl(data, "STL"):
        corners = _text_stl_corners(data)
    else:
        count = int.from_bytes(data[80:84], "little")
        there = (len(data) - 84) // 50
        if count > there:
            raise Faulty(f"ends after {there} of the {count} triangles that its header announces")
        if not count:
            raise Faulty("has no triangle")
        corners = _stl_corners(data, count)
    number = len(corners) // 3
    return Mesh("STL", _bounds(corners), number), lambda: [corners[: 3 * number].reshape(-1, 3, 3)]


def _stl_corners(data: bytes, count: int) -> Any:
    """The corners of a binary STL's triangles, shape (3 n, 3), one coordinate after the other in memory."""
    import numpy as np

    row = np.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("attribute", "<u2")])
    return np.frombuffer(data, row, count, 84)["corners"].reshape(-1, 3).T.copy().T


_FACET = (b"endfacet", b"facet normal", b"outer loop", b"vertex", b"endloop")
"""The words of a facet in a text STL, beside twelve numbers: its normal and its corners."""


def _text_stl_corners(data: bytes) -> Points:
    import numpy as np

    data = data.lower()
    start, end = data.find(b"facet"), data.rfind(b"endfacet")
    if start < 0 or end < 0:
        raise Faulty("has no triangle")
    text = data[start:end]
    for word in _FACET:
        text = text.replace(word, b"")
    with suppress(ValueError):
        return np.asarray(_numbers(text).reshape(-1, 4, 3)[:, 1:].reshape(-1, 3))
    # several solids, comments, or normals that are not numbers
    found = re.findall(rb"vertex\s+(\S+)\s+(\S+)\s+(\S+)", data)
    return np.array(found).astype(float).reshape(-1, 3)


def _read_obj(data: bytes) -> Content:
    data = b"\n" + data.replace(b"\t", b" ").replace(b"\r", b"\n") + b"\n"
    if b"\n " in data:
        data = b"\n".join(line.lstrip(b" ") for line in data.split(b"\n"))
    rows, faces, others = _lines(data, b"v ", b"f ", b"mt")
    triangles = _words(faces) - 3 * faces.count(b"f ")
    if triangles <= 0:
        raise Faulty("has no face")
    corners = _rows(rows.replace(b"v", b""))
    named = (line[7:] for line in others.split(b"\n") if line[:7] == b"mtllib ")
    files = _names(name.decode(errors="replace") for name in named)
    return Mesh("OBJ", _bounds(corners), triangles, files=files), lambda: [
        corners.take(_obj_triangles(faces), axis=0)
    ]


def _lines(data: bytes, *kinds: bytes) -> Iterator[bytes]:
    """The lines that begin with two characters, for each of these; of a text between two ends of lines."""
    import numpy as np

    codes = np.frombuffer(data + b"\0\0", np.uint8)
    starts = np.flatnonzero(codes == ord("\n")) + 1
    for kind in kinds:
        chosen = (codes[starts] == kind[0]) & (codes[starts + 1] == kind[1])
        edges = starts[np.flatnonzero(np.diff(chosen, prepend=False))]
        yield b"".join([data[first:last] for first, last in edges.reshape(-1, 2).tolist()])


def _words(text: bytes) -> int:
    """The number of words."""
    import numpy as np

    is_inside = np.frombuffer(b" " + text, np.uint8) > ord(" ")
    return int(np.count_nonzero(is_inside[1:] > is_inside[:-1]))


def _rows(text: bytes) -> Points:
    """The first three numbers of each line."""
    import numpy as np

    numbers, width = _numbers(text), len(text.partition(b"\n")[0].split())
    if width and len(numbers) == width * text.count(b"\n"):
        return np.asarray(numbers.reshape(-1, width)[:, :3])
    return np.array([line.split()[:3] for line in text.splitlines()]).astype(float)


def _obj_triangles(faces: bytes) -> Any:
    """The corners (n, 3) of faces, whose lines are such as ``f 12/3/4 5/6/7 8/9/10``."""
    import numpy as np

    parts = faces.split(maxsplit=2)[1].split(b"/")
    width = len(parts) - parts.count(b"")
    numbers = _numbers(faces.replace(b"f", b"0").replace(b"/", b" "), int)
    corners = numbers[numbers != 0]
    if faces.count(b"/") * width != (len(parts) - 1) * len(corners):
        return _obj_triangles(re.sub(rb"/\S*", b"", faces))
    sides = np.diff(np.flatnonzero(numbers == 0), append=len(numbers)) - 1
    return _fans(sides // width, np.where(corners > 0, corners - 1, corners)[::width])


_OPEN_VALUE = re.compile(rb'="[^"<]*<[^"]*"')
"""The value of an attribute with the bracket of a tag in it."""


def _read_collada(data: bytes) -> Content:
    from lxml import etree

    try:
        root = _xml(data)
    except etree.XMLSyntaxError as error:
        # An exporter writes ids like "<STL_BINARY>", which the parsers of consumers take.
        try:
            root = _xml(_OPEN_VALUE.sub(lambda value: value[0].replace(b"<", b"&lt;"), data))
        except etree.XMLSyntaxError:
            raise Faulty(f"is not well-formed XML ({error.msg})") from None
    collada = _Collada(root)
    return collada.mesh(), collada.triangles


def _xml(data: bytes) -> Any:
    """The root element; entities are not resolved and nothing is fetched."""
    from lxml import etree

    parser = etree.XMLParser(resolve_entities=False, no_network=True, huge_tree=True, remove_comments=True)
    return etree.fromstring(data, parser)


_DEEPEST = 8
"""So many elements up a geometry is looked for: an accessor is four below one."""


def _geometry_around(element: Any) -> Any:
    """The geometry that an element of COLLADA is in, which is a few elements up; None outside of one."""
    around = islice(element.iterancestors(), _DEEPEST)
    return next((each for each in around if each.tag.rpartition("}")[2] == "geometry"), None)


class _Collada:
    """The geometries of a COLLADA file, and the nodes that place them."""

    def __init__(self, root: Any) -> None:
        self.root = root
        self.named = dict(self._with_ids(root))
        self.own = {(_geometry_around(each), name): each for name, each in self._with_ids(root)}
        """By the geometry as well: in some files each uses the same ids, and means its own."""
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
            points = (self._points(vertices) for vertices in self._all(element, "vertices"))
            box = around(_bounds(each) for each in points if each is not None)
            self.measured[element] = box, sum(map(_triangles, element.iter()))
        return self.measured[element]

    def _unskinned(self, element: Any) -> Any:
        """The geometry of a controller."""
        skin = next(self._all(element, "skin"), None) if _name(element) == "controller" else None
        source = self.named.get(skin.get("source", "")[1:]) if skin is not None else None
        return source if source is not None and _name(source) == "geometry" else element

    def _points(self, vertices: Any) -> Points | None:
        """The positions (n, 3) of ``vertices``."""
        if vertices not in self.points:
            self.points[vertices] = self._positions(vertices)
        return self.points[vertices]

    def _positions(self, vertices: Any) -> Points | None:
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
                corners = part.reshape(-1, 3) @ (transform[:3, :3].T * meter) + transform[:3, 3] * meter
                yield corners.reshape(-1, 3, 3)

    def _corners(self, primitive: Any) -> Points | None:
        """The triangles of one primitive, in its own frame."""
        import numpy as np

        inputs = [each for each in primitive if _name(each) == "input"]
        vertex = next((each for each in inputs if each.get("semantic") == "VERTEX"), None)
        vertices = self._target(vertex, "source") if vertex is not None else None
        points = self._points(vertices) if vertices is not None else None
        if vertex is None or points is None:
            return None
        stride = 1 + max(int(each.get("offset", 0)) for each in inputs)
        rows = [_numbers(each.text or "", int) for each in primitive if _name(each) == "p"]
        corners = [row[int(vertex.get("offset", 0)) :: stride] for row in rows]
        sides = next((_numbers(each.text or "", int) for each in primitive if _name(each) == "vcount"), None)
        if _name(primitive) == "triangles":
            chosen = corners[0][: len(corners[0]) // 3 * 3].reshape(-1, 3)
        else:
            sides = np.array(list(map(len, corners))) if sides is None else sides
            chosen = _fans(sides, np.concatenate(corners))
        return np.take(points, chosen, axis=0)

    def _target(self, element: Any, attribute: str = "url") -> Any:
        name = (element.get(attribute) or "").lstrip("#")
        return self.own.get((_geometry_around(element), name), self.named.get(name))

    @staticmethod
    def _with_ids(root: Any) -> Iterator[tuple[str, Any]]:
        return ((element.get("id"), element) for element in root.iter() if element.get("id"))

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
        sides = next((_numbers(child.text or "", int) for child in element if _name(child) == "vcount"), None)
        return int(sides.sum()) - 2 * len(sides) if sides is not None else 0
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


def _fans(sides: Any, corners: Any) -> Any:
    """The triangles (n, 3) of polygons with so many sides each; raises ValueError where there are fewer corners."""
    import numpy as np

    if len(sides) and (sides.min() < 0 or sides.max() > len(corners) or sides.sum() > len(corners)):
        raise ValueError("more sides than corners")
    counts = np.maximum(sides - 2, 0)
    first = np.repeat(np.cumsum(sides) - sides, counts)
    next_ = first + np.arange(1, len(first) + 1) - np.repeat(np.cumsum(counts) - counts, counts)
    return corners.take(np.stack((first, next_, next_ + 1), axis=1))


def _read_glb(data: bytes) -> Content:
    length, kind = int.from_bytes(data[12:16], "little"), data[16:20]
    if kind != b"JSON" or len(data) < 20 + length:
        raise Faulty("ends before its JSON part does")
    document, buffer = _gltf_document(data[20 : 20 + length]), data[28 + length :]
    return _gltf_mesh(document)._replace(format="GLB"), lambda: _gltf_triangles(document, buffer)


def _read_gltf(data: bytes) -> Content:
    return _gltf_mesh(_gltf_document(data)), tuple


def _gltf_document(data: bytes) -> Any:
    try:
        return json.loads(data)
    except ValueError:
        raise Faulty("is not valid JSON") from None


def _gltf_mesh(document: Mapping[str, Any]) -> Mesh:
    import numpy as np

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


def _numbers(text: str | bytes, kind: type = float) -> npt.NDArray[Any]:
    """The numbers of a text."""
    import numpy as np

    data = text.encode() if isinstance(text, str) else text
    with catch_warnings():
        simplefilter("error", DeprecationWarning)
        if kind is float and len(data) > _SHORT:
            with suppress(DeprecationWarning, ValueError):
                return _decimals(data)
        try:
            return np.fromstring(data, kind, sep=" ") if data.strip() else np.empty(0, kind)
        except DeprecationWarning:
            raise ValueError("no number") from None


_SHORT = 1000
"""Characters: numpy reads less text sooner by itself."""
_BLANK, _POINT, _POWER = b" .e"
_BLANKS, _APART = bytes.maketrans(b"\t\n\v\f\rE", b"     e"), bytes.maketrans(b"e", b" ")
_LONGEST, _GREATEST = 2**62, 300


def _decimals(data: bytes) -> Points:
    """The numbers of a text by their digits and the places of their points, in half of numpy's time.

    Raises ValueError, or numpy's DeprecationWarning, where it has other words than such as ``-1.5e3``, or longer ones.
    """
    import numpy as np

    data = data.translate(_BLANKS) + b" "
    digits = np.fromstring(data.translate(_APART, b"."), np.int64, sep=" ")
    codes = np.frombuffer(data, np.uint8)
    marks = np.flatnonzero((codes == _BLANK) | (codes == _POINT) | (codes == _POWER))
    kinds = codes[marks]
    ends = np.flatnonzero((kinds != _POINT) & (codes[marks - 1] != _BLANK))
    has_point = kinds[ends - 1] == _POINT
    places = np.where(has_point, marks[ends] - marks[ends - 1] - 1, 0)
    powers = np.flatnonzero(kinds[ends] == _POWER) + 1
    counted = len(digits), int(has_point.sum()), len(powers)
    if counted != (len(ends), int((kinds == _POINT).sum()), int((kinds == _POWER).sum())):
        raise ValueError("other words than numbers")
    if not -_LONGEST < digits.min() <= digits.max() < _LONGEST:
        raise ValueError("too many digits")
    places[powers - 1] -= digits[powers]
    places = np.delete(places, powers).clip(-_GREATEST, _GREATEST)
    return np.asarray(
        np.delete(digits, powers) / (10.0 ** np.arange(-_GREATEST, _GREATEST + 1))[places + _GREATEST]
    )


def _bounds(points: Any) -> Box:
    """The box around points of shape (n, 3)."""
    import numpy as np

    if not len(points):
        raise Faulty("has no triangle")
    low, high = points.min(axis=0), points.max(axis=0)
    if not (np.isfinite(low).all() and np.isfinite(high).all()):
        raise Faulty("has coordinates that are not finite numbers")
    return Box(tuple(map(float, low)), tuple(map(float, high)))


_READERS: dict[str, Callable[[bytes], Content]] = {
    "STL": _read_stl,
    "OBJ": _read_obj,
    "COLLADA": _read_collada,
    "glTF": _read_gltf,
    "GLB": _read_glb,
}


# Kept from run to run


_BOUNDS, _SKINS = ("-bounds", 4000), ("-skin", 1000)
"""The kinds of measurements, and how many of a folder are kept."""


def mesh_at(
    path: Path, open: Open = open_regular, shelves: Shelves | None = None, *, with_skin: bool = False
) -> Mesh:
    """The content of a mesh file, read again only where its size or time of change is another one.

    It is opened each time, as it may be where this run must not read: then nothing is known of it. A file that cannot
    be read has a ``fault``, and never raises. ``with_skin``: where it is read, its skin will be asked for, too.
    """
    used = Shelves() if shelves is None else shelves
    try:
        with _opened(path, open) as (read, stamp):
            found = _mesh_kept(used, path, stamp)
            if found is None:
                content = _content(path, read)
                found = content[0]
                _keep(used, path, _BOUNDS, [stamp, *_packed_mesh(found)])
                if with_skin:
                    _keep(used, path, _SKINS, [stamp, *_packed_skin(_skin(content))])
    except Outside:
        return Mesh("")  # the run may not read it; others can
    except OSError as error:
        return Mesh("", fault=f"cannot be read: {error.strerror or error}")
    if shelves is None:
        used.save()
    return found._replace(stamp=stamp)


def skin_at(path: Path, open: Open = open_regular, shelves: Shelves | None = None) -> Skin | None:
    """The skin of a mesh file (m), without scale, likewise; None where it is not known."""
    used = Shelves() if shelves is None else shelves
    try:
        with _opened(path, open) as (read, stamp):
            row = used.find(*os.path.split(path), _SKINS[0], stamp)
            with suppress(ValueError, TypeError, AttributeError):  # where it is not what was written
                if row is not None:
                    return _unpacked_skin(row)
            packed = _packed_skin(read_skin(path, read))
    except OSError:
        return None
    _keep(used, path, _SKINS, [stamp, *packed])
    if shelves is None:
        used.save()
    return _unpacked_skin(packed)  # rounded as it is kept, so that every run sees the same


@contextmanager
def _opened(path: Path, open: Open) -> Iterator[tuple[Read, str]]:
    """A mesh file to be read, and its stamp."""
    with open(path, LIMIT) as stream:
        status = os.fstat(stream.fileno())
        yield lambda file, limit: read_on(stream, file, limit), f"{status.st_size} {status.st_mtime_ns}"


def _mesh_kept(shelves: Shelves, path: Path, stamp: str) -> Mesh | None:
    row = shelves.find(*os.path.split(path), _BOUNDS[0], stamp)
    with suppress(ValueError, TypeError, AttributeError):  # where it is not what was written
        return _unpacked_mesh(row) if row is not None else None
    return None


def _keep(shelves: Shelves, path: Path, kind: tuple[str, int], row: list[Any]) -> None:
    shelves.keep(*os.path.split(path), kind[0], row, kind[1])


def _packed_mesh(mesh: Mesh) -> list[Any]:
    form, box, *rest = mesh._replace(stamp="")
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

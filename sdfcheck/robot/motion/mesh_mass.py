"""Mass properties of closed meshes, measured by trimesh (the extra ``mesh``)."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from importlib.util import find_spec
from io import BytesIO
from typing import Any

import numpy as np
from lxml import etree

from sdfcheck.files.library import library_of
from sdfcheck.files.regular import MEGABYTE, Unfit
from sdfcheck.files.uris import locate
from sdfcheck.formats.sdf.values import floats
from sdfcheck.robot.motion.mass_properties import MassProperties
from sdfcheck.source.document import Document
from sdfcheck.source.element import Element

FORMATS = frozenset({"stl", "obj", "dae", "glb", "gltf"})
"""Those that simulators read."""
SIZE_LIMIT = 50 * MEGABYTE
"""Larger files, and buffers of such a size, are not measured."""
MOST_WORK = 50e6


class MeshError(ValueError):
    """A mesh that cannot be measured."""


def mesh_body(mesh: Element, density: float) -> MassProperties:
    """A ``mesh`` element filled with a density (kg/m³), in the frame of its file.

    Raises MeshError where the file is missing, cannot be read or is not a closed surface, where
    only a part of it is meant, and where trimesh is not installed.
    """
    if find_spec("trimesh") is None:
        raise MeshError("meshes need trimesh (install the extra `mesh`)")
    if mesh.has("submesh"):
        raise MeshError("the mass of a submesh cannot be computed")
    written = mesh.value("uri") or mesh.value("filename")
    uri = written.text.strip() if written is not None else ""
    surface: Any = _surface(mesh.document, uri)
    if not surface.is_watertight:
        raise MeshError(f"mesh `{uri}` is not closed")
    surface.apply_scale(_scale(mesh))
    surface.density = density
    if not surface.volume > 0:
        raise MeshError(f"mesh `{uri}` has its inside out")
    return MassProperties(
        float(surface.mass), np.array(surface.center_mass), np.array(surface.moment_inertia)
    )


def _surface(document: Document, uri: str) -> Any:
    """The surface of a file, all its parts in one; materials and textures are not read."""
    import trimesh

    path = locate(document, uri).path if uri else None
    library = library_of(document)
    if path is None or library is None:
        raise MeshError(f"there is no mesh `{uri}`")
    form = path.suffix.lower().removeprefix(".")
    if form not in FORMATS:
        raise MeshError(f"mesh `{uri}` is in a format that is not measured")
    try:
        data = library.read(path, document, SIZE_LIMIT)
        if _work(data, form) > MOST_WORK:
            raise MeshError(f"mesh `{uri}` has too many parts to be measured")
        beside = _Buffers(lambda name: library.read(path.parent / name, document, SIZE_LIMIT))
        return trimesh.load(BytesIO(data), form, beside, force="mesh", skip_materials=True)
    except MeshError:
        raise
    except Unfit as error:
        raise MeshError(f"mesh `{uri}` is {error.strerror}") from None
    except OSError as error:
        raise MeshError(f"mesh `{uri}` is not read: {error.strerror}") from None
    except Exception:  # trimesh and its importers raise any kind, and quote what they read
        raise MeshError(f"mesh `{uri}` cannot be read as {form.upper()}") from None


class _Buffers(Mapping[str, bytes]):
    """The buffers beside a glTF file, by name; nothing else that a mesh names is there."""

    def __init__(self, read: Callable[[str], bytes]) -> None:
        self._read = read

    def __getitem__(self, name: str) -> bytes:
        if not name.endswith(".bin"):
            raise KeyError(name)
        return self._read(name)

    def __iter__(self) -> Iterator[str]:
        return iter(())

    def __len__(self) -> int:
        return 0

    def get(self, name: str, default: object = None) -> bytes:
        return self[name]


def _work(data: bytes, form: str) -> float:
    """The size of what a mesh becomes: scenes may use a part often, in parts that are used often, and so on.

    In bytes of COLLADA, or in numbers of glTF; 0 for formats that cannot repeat.
    """
    if form == "dae":
        return _collada_work(data)
    if form in {"glb", "gltf"}:
        return _gltf_work(data)
    return 0


def _collada_work(data: bytes) -> float:
    if data.startswith(b"PK") or b"<!ENTITY" in data:
        raise ValueError("packed")
    root = etree.fromstring(data, etree.XMLParser(resolve_entities=False, no_network=True))
    parts = list(root.iter("{*}node", "{*}geometry", "{*}controller"))
    names = {part: f"#{part.get('id', number)}" for number, part in enumerate(parts)}
    sizes, uses = dict.fromkeys(names.values(), 1.0), {}
    for part, name in names.items():
        if etree.QName(part).localname == "node":
            inner = part.iterchildren("{*}instance_node", "{*}instance_geometry", "{*}instance_controller")
            below = [names[child] for child in part.iterchildren("{*}node")]
            uses[name] = [*below, *(use.get("url", "") for use in inner)]
        else:
            sizes[name] += sum(len(text) for text in part.itertext())
    return _expanded(uses, sizes)


def _gltf_work(data: bytes) -> float:
    import json

    length = int.from_bytes(data[12:16], "little")
    tree = json.loads(data[20 : 20 + length] if data.startswith(b"glTF") else data)
    counts = [float(accessor["count"]) for accessor in tree.get("accessors", ())]
    sizes, uses = {}, {}
    for number, mesh in enumerate(tree.get("meshes", ())):
        used = [at for primitive in mesh["primitives"] for at in primitive["attributes"].values()]
        used += [primitive["indices"] for primitive in mesh["primitives"] if "indices" in primitive]
        sizes[f"mesh {number}"] = 1.0 + sum(counts[at] for at in used)
    for number, node in enumerate(tree.get("nodes", ())):
        sizes[f"node {number}"] = 1.0
        below = [f"node {child}" for child in node.get("children", ())]
        uses[f"node {number}"] = [*below, *([f"mesh {node['mesh']}"] if "mesh" in node else ())]
    return sum(counts) + _expanded(uses, sizes)


def _expanded(uses: Mapping[str, Sequence[str]], sizes: Mapping[str, float]) -> float:
    """The size of all parts with what they use, each as often as it is used; infinite where parts use themselves."""
    found: dict[str, float] = {}
    inner = {name for names in uses.values() for name in names}
    waiting = list(uses)
    entered: set[str] = set()
    while waiting:
        name = waiting[-1]
        missing = [used for used in uses.get(name, ()) if used not in found]
        if not missing:
            found[name] = sizes.get(name, 0.0) + sum(found[used] for used in uses.get(name, ()))
            waiting.pop()
        elif name in entered:
            return math.inf
        else:
            entered.add(name)
            waiting += dict.fromkeys(missing)
    return sum(size for name, size in found.items() if name not in inner)


def _scale(mesh: Element) -> tuple[float, ...]:
    scale = mesh.value("scale")
    numbers = floats(scale.text) if scale is not None and scale.text.strip() else (1.0, 1.0, 1.0)
    if numbers is None or len(numbers) != 3:
        raise MeshError("its scale is not 3 numbers")
    return numbers

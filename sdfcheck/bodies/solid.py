"""Volume, center, inertia and closedness of meshes, measured by trimesh (the extra ``mesh``)."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from io import BytesIO
from typing import TYPE_CHECKING, Any

from sdfcheck.files.regular import MEGABYTE
from sdfcheck.source.record import NamedTuple

if TYPE_CHECKING:
    import numpy as np
    import numpy.typing as npt

FORMATS = frozenset({"stl", "obj", "dae", "glb", "gltf"})
"""Those that simulators read."""
SIZE_LIMIT = 50 * MEGABYTE
"""Larger files, and buffers of such a size, are not measured."""
MOST_WORK = 50e6


class Unmeasured(ValueError):
    """A mesh that is not measured; the text says why."""


class Solid(NamedTuple):
    """A mesh filled evenly, with lengths in m and a density of 1 kg/m³."""

    volume: float
    """m³; negative where the surface has its inside out, and without meaning unless it is closed."""
    center: npt.NDArray[np.float64]
    """The center of mass, shape (3,)."""
    moments: npt.NDArray[np.float64]
    """About the center of mass (kg·m²), shape (3, 3)."""
    is_closed: bool
    """Is the surface watertight?"""
    is_convex: bool
    triangles: int


def solid_of(data: bytes, form: str, scale: Sequence[float], beside: Callable[[str], bytes]) -> Solid:
    """Measure the content of a mesh file with its scale, all its parts in one; materials are not read.

    ``form`` is one of FORMATS, ``beside`` reads a buffer of glTF by its name. Raises Unmeasured, also where
    trimesh is not installed.
    """
    import numpy as np

    try:
        import trimesh
    except ImportError:
        raise Unmeasured("meshes need trimesh (install the extra `mesh`)") from None
    try:
        if _work(data, form) > MOST_WORK:
            raise Unmeasured("has too many parts to be measured")
        surface: Any = trimesh.load(BytesIO(data), form, _Buffers(beside), force="mesh", skip_materials=True)
    except Unmeasured:
        raise
    except OSError as error:
        raise Unmeasured(f"is not read: {error.strerror}") from None
    except Exception:  # trimesh and its importers raise any kind, and quote what they read
        raise Unmeasured(f"cannot be read as {form.upper()}") from None
    if not len(surface.faces):
        raise Unmeasured(f"cannot be read as {form.upper()}")
    surface.apply_scale(scale)
    surface.density = 1.0
    with np.errstate(all="ignore"):  # a flat surface has no volume to divide by
        center, moments = surface.center_mass, surface.moment_inertia
    return Solid(
        float(surface.volume),
        center,
        moments,
        bool(surface.is_watertight),
        bool(surface.is_convex),
        len(surface.faces),
    )


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
    from lxml import etree

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

"""Bodies as solids and as surfaces.

Volume, center, inertia and closedness of meshes are measured by trimesh (the extra ``mesh``). A skin has points all
over a surface: it says how far two bodies are apart, and how much of one lies in the other. Bodies may be open, turned
inside out or made of many parts: whether a point is inside is asked of the solid angle around it.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from io import BytesIO
from itertools import pairwise
from typing import TYPE_CHECKING, Any, TypeAlias

import numpy as np

from sdfcheck.files.regular import MEGABYTE
from sdfcheck.source.record import NamedTuple

if TYPE_CHECKING:
    import numpy.typing as npt

    Array: TypeAlias = npt.NDArray[np.float64]

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


# Surfaces as points.


POINTS = 1500
"""Of a mesh or another shape."""
_LEVELS = (100, 400, POINTS)
_GOLDEN = (0.754877666246693, 0.569840290998053)
"""Steps that spread points over a square, whatever their number (the plastic constant)."""
_SIDES = 24
_THIN = 1e-3
"""Of its surface and size: less volume may be none."""
_BYTE = 255
"""The bounds have so many steps along each axis, and so have directions."""


class Skin(NamedTuple):
    """Points (n, 3) of a surface (m), its directions outwards (n, 3), and the area (n,) of each (m²)."""

    points: Array
    normals: Array
    areas: Array

    def moved(self, pose: Array) -> Skin:
        """The same in the frame in which its own has this pose (4×4)."""
        turn = pose[:3, :3].T
        return Skin(self.points @ turn + pose[:3, 3], self.normals @ turn, self.areas)

    def scaled(self, factors: Sequence[float]) -> Skin:
        """The same with each coordinate multiplied."""
        scale = np.array(factors, dtype=float)
        normals = self.normals * np.prod(scale) / scale
        stretch = np.linalg.norm(normals, axis=1)
        return Skin(self.points * scale, normals / stretch[:, None], self.areas * stretch)

    @property
    def filled(self) -> tuple[float, ...] | None:
        """The moments ixx, iyy, izz, ixy, ixz and iyz about its center (m²), filled evenly with 1 kg; about right.

        None where nothing is inside.
        """
        flux = self.normals * self.areas[:, None]
        volume = float((self.points * flux).sum()) / 3
        if not abs(volume) > _THIN * float(self.areas.sum()) * self.size:
            return None
        points = self.points - (self.points**2 * flux).sum(axis=0) / 2 / volume
        squares = (points**3 * flux).sum(axis=0) / 3 / volume
        pairs = ((0, 1), (0, 2), (1, 2))
        flows = [points[:, i] * points[:, j] * (points * flux)[:, (i, j)].sum(axis=1) for i, j in pairs]
        products = [-float(flow.sum()) / 4 / volume for flow in flows]
        return (*(float(squares.sum() - square) for square in squares), *products)

    def some(self, count: int) -> Skin:
        """So many of its points, for all of its surface."""
        step = max(1, len(self.points) // count)
        return Skin(self.points[::step], self.normals[::step], self.areas[::step] * step)

    def within(self, other: Skin, reach: float) -> Skin:
        """The part of it that is in the bounds of another one, or not farther away from them."""
        if not len(other.points):
            return self
        low, high = other.bounds
        chosen = ((self.points >= low - reach) & (self.points <= high + reach)).all(axis=1)
        return Skin(self.points[chosen], self.normals[chosen], self.areas[chosen])

    @property
    def bounds(self) -> tuple[Array, Array]:
        """The least and the greatest coordinates of its points (m)."""
        return self.points.min(axis=0), self.points.max(axis=0)

    @property
    def size(self) -> float:
        """Its greatest length along an axis."""
        return float(np.ptp(self.points, axis=0).max())

    def distance_to(self, other: Skin) -> float:
        """How far another surface is away (m); each point is a disc, of which the larger one counts."""
        few, others = (skin.some(_LEVELS[0]).points for skin in (self, other))
        reach = math.sqrt(_squares(few, others).min()) + max(self._radii.max(), other._radii.max())
        mine, theirs = self.within(other, reach), other.within(self, reach)
        discs = np.maximum.outer(mine._radii, theirs._radii)
        return float((np.sqrt(_squares(mine.points, theirs.points)) - discs).min())

    def distance_of_bounds(self, other: Skin) -> float:
        """How far its bounds are from those of another surface (m)."""
        (low, high), (bottom, top) = self.bounds, other.bounds
        return float(np.linalg.norm(np.maximum(0, np.maximum(bottom - high, low - top))))

    def is_near(self, other: Skin, least: float) -> bool:
        """Is it no farther away than that (m)? Few points show what is near."""
        if self.distance_of_bounds(other) > least:
            return False
        reach = least + max(self._radii.max(), other._radii.max()) * math.sqrt(POINTS / _LEVELS[0])
        return any(_are_near(self.some(count), other.some(count), least, reach) for count in _LEVELS)

    @property
    def _radii(self) -> Array:
        return np.sqrt(self.areas / math.pi)

    def packed(self) -> list[str | float]:
        """Its points and normals in bytes, as text, with its bounds and area."""
        from base64 import b64encode

        low, high = self.bounds
        inside = (self.points - low) / np.where(high > low, high - low, 1)
        rows = np.concatenate((inside * _BYTE, (self.normals + 1) / 2 * _BYTE), axis=1)
        text = b64encode(np.rint(rows).astype(np.uint8).tobytes()).decode("ascii")
        return [text, float(self.areas.sum()), *map(float, (*low, *high))]

    def share_in(self, other: Skin, least: float = 0.0) -> float:
        """The share of its surface that is inside of another body; 0 where bounds show that it is ``least`` at most."""
        points = self.points
        low, high = other.bounds
        near = points[((points > low) & (points < high)).all(axis=1)]
        if len(near) <= least * len(points):
            return 0.0
        squares = np.maximum(_squares(near, other.points), 1e-18)
        cubes = squares * np.sqrt(squares)
        ahead = (other.points * other.normals).sum(axis=1) - near @ other.normals.T
        angles = (ahead / cubes) @ other.areas
        return float((np.abs(angles) > 2 * math.pi).sum()) / len(points)


def _squares(points: Array, others: Array) -> Array:
    """The squares of the distances of all points from all others."""
    own, theirs = (points**2).sum(axis=1)[:, None], (others**2).sum(axis=1)
    return np.asarray(np.maximum(own + theirs - 2 * points @ others.T, 0.0))


def _are_near(mine: Skin, others: Skin, least: float, reach: float) -> bool:
    """Are two surfaces near to each other? Points farther from the bounds of the other than ``reach`` are not."""
    mine = mine.within(others, reach)
    others = others.within(mine, reach)
    if not len(mine.points) or not len(others.points):
        return False
    discs = np.maximum.outer(mine._radii, others._radii)
    return bool((_squares(mine.points, others.points) <= (least + discs) ** 2).any())


def unpacked(text: str, area: float, *bounds: float) -> Skin:
    """The skin that was packed."""
    from base64 import b64decode

    rows = np.frombuffer(b64decode(text), np.uint8).reshape(-1, 6) / _BYTE
    low, high = np.array(bounds).reshape(2, 3)
    normals = rows[:, 3:] * 2 - 1
    normals /= np.linalg.norm(normals, axis=1)[:, None]
    return Skin(low + rows[:, :3] * (high - low), normals, np.full(len(rows), area / len(rows)))


def together(skins: Iterable[Skin]) -> Skin | None:
    """All as one; None of none."""
    known = list(skins)
    if not known:
        return None
    return Skin(*(np.concatenate(column) for column in zip(*known, strict=True)))


def skin_of(triangles: Any) -> Skin | None:
    """The skin of triangles, shape (n, 3, 3); None where they have no area."""
    corners = np.asarray(triangles)
    start, middle, end = corners.transpose(1, 2, 0)  # of three rows each: numpy is fast along long ones
    first, second = middle - start, end - start
    pairs = ((1, 2), (2, 0), (0, 1))
    crosses = np.stack([first[i] * second[j] - first[j] * second[i] for i, j in pairs])
    doubled = np.sqrt((crosses**2).sum(axis=0))
    sums = np.cumsum(doubled, dtype=float)
    if not len(sums) or not 0 < sums[-1] < math.inf:
        return None
    number = np.arange(POINTS)
    chosen = np.searchsorted(sums, (number + 0.5) / POINTS * sums[-1]).clip(max=len(sums) - 1)
    u, v = ((number * step) % 1.0 for step in _GOLDEN)
    over = u + v > 1
    u, v = np.where(over, 1 - u, u), np.where(over, 1 - v, v)
    points = start[:, chosen] + u * first[:, chosen] + v * second[:, chosen]
    normals = crosses[:, chosen].astype(float) / np.maximum(doubled[chosen], 1e-30)
    return Skin(points.T, normals.T, np.full(POINTS, sums[-1] / 2 / POINTS))


def of_shape(kind: str, size: Sequence[float]) -> Skin | None:
    """The skin of a box (lengths), sphere (radius), cylinder or capsule (radius, length); None of another shape."""
    if kind == "box":
        return skin_of(_BOX * np.array(size))
    radius, half = size[0], size[-1] / 2
    turns = np.linspace(-math.pi / 2, math.pi / 2, _SIDES // 2 + 1)
    round_ = [(radius * math.cos(turn), radius * math.sin(turn)) for turn in turns]
    profiles = {
        "sphere": round_,
        "cylinder": [(0.0, -half), (radius, -half), (radius, half), (0.0, half)],
        "capsule": [(across, along + math.copysign(half, along)) for across, along in round_],
    }
    return skin_of(_turned(profiles[kind])) if kind in profiles else None


def _turned(profile: Sequence[tuple[float, float]]) -> Array:
    """The triangles of what turns about z; the profile has distances from it and heights, upwards."""
    turns = np.linspace(0, 2 * math.pi, _SIDES + 1)
    rings = [np.stack((r * np.cos(turns), r * np.sin(turns), np.full(len(turns), z)), 1) for r, z in profile]
    quads = [(low[:-1], low[1:], high[1:], high[:-1]) for low, high in pairwise(rings)]
    halves = [np.stack(three, 1) for a, b, c, d in quads for three in ((a, b, c), (a, c, d))]
    return np.concatenate(halves)


def _box() -> Array:
    """The twelve triangles of a box with edges of length 1."""
    faces = []
    for across in range(3):
        for side in (-0.5, 0.5):
            square = np.array([(-0.5, -0.5), (0.5, -0.5), (0.5, 0.5), (-0.5, 0.5)])[:: int(2 * side)]
            corners = np.insert(square, across, side, axis=1)
            if across == 1:
                corners = corners[::-1]
            faces += [corners[[0, 1, 2]], corners[[0, 2, 3]]]
    return np.array(faces)


_BOX = _box()

"""Volume, center, inertia and closedness of mesh files, measured by trimesh (the extra ``mesh``)."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

from sdfcheck.bodies.mesh import LIMIT
from sdfcheck.files.regular import read_regular
from sdfcheck.source.record import NamedTuple

if TYPE_CHECKING:
    import numpy as np
    import numpy.typing as npt


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


def solid_at(path: Path, scale: Sequence[float] = (1.0, 1.0, 1.0)) -> Solid:
    """Measure a mesh with its scale. Raises Unmeasured, also where trimesh is not installed."""
    try:
        import trimesh
    except ImportError:
        raise Unmeasured("meshes need trimesh (install the extra `mesh`)") from None
    try:
        read_regular(path, LIMIT)
        surface: Any = trimesh.load(path, force="mesh")
    except OSError as error:
        raise Unmeasured(f"cannot be read: {error.strerror or error}") from None
    except Exception as error:  # trimesh and its importers raise any kind
        why = " ".join(str(error).split()) or type(error).__name__
        raise Unmeasured(f"cannot be read: {why}") from None
    surface.apply_scale(scale)
    surface.density = 1.0
    return Solid(
        float(surface.volume),
        surface.center_mass,
        surface.moment_inertia,
        bool(surface.is_watertight),
        bool(surface.is_convex),
        len(surface.faces),
    )

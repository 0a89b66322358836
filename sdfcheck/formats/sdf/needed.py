"""Required children that matter when they are left out.

libsdformat fills in every required child but a joint's ends, and says nothing. For
most (a world's atmosphere, a physics' step) the default is what an author who leaves
them out expects; for these it makes another robot, or nothing sensible at all.
"""

from __future__ import annotations

NOT_GIVEN = "__default__"
"""The default that stands for "not given": there is nothing sensible to take."""

_NEEDED = frozenset(
    """
    box/size capsule/length capsule/radius cone/length cone/radius cylinder/length cylinder/radius
    ellipsoid/radii image/height image/scale polyline/height polyline/point sphere/radius
    axis/xyz axis2/xyz inertia/ixx inertia/iyy inertia/izz
    joint/child joint/parent
    lidar/range lidar/scan ray/range ray/scan range/max range/min scan/horizontal
    horizontal/max_angle horizontal/min_angle horizontal/samples
    logical_camera/far logical_camera/near sonar/max sonar/min
    spherical_coordinates/latitude_deg spherical_coordinates/longitude_deg
    trajectory/waypoint waypoint/pose waypoint/time
    """.split()
)


def is_needed(parent: str, child: str, default: str | None) -> bool:
    """Whether leaving out the required ``child`` of an element called ``parent`` is worth a word."""
    return default == NOT_GIVEN or f"{parent}/{child}" in _NEEDED

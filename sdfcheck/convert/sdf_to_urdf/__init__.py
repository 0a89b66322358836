"""SDF models as URDF robots: every link at its joint, the robot the same."""

from sdfcheck.convert.sdf_to_urdf.conversion import convert
from sdfcheck.convert.sdf_to_urdf.plan import Loops, Options, Planes, Unsupported

__all__ = ["Loops", "Options", "Planes", "Unsupported", "convert"]

"""The elements of SDFormat that have a counterpart in URDF, and the attributes in which they say something."""

from __future__ import annotations

from sdfcheck.convert.ledger import TEXT, Words

_ELEMENTS = {
    "axis": "",
    "axis2": "",
    "box": "",
    "capsule": "",
    "collision": "name",
    "cylinder": "",
    "dynamics": "",
    "ellipsoid": "",
    "frame": "name attached_to",
    "geometry": "",
    "include": "merge",
    "inertia": "",
    "inertial": "auto",
    "joint": "name type",
    "limit": "",
    "link": "name",
    "material": "",
    "mesh": "optimization",
    "mimic": "joint axis",
    "model": "name canonical_link placement_frame",
    "plane": "",
    "sdf": "version",
    "sphere": "",
    "visual": "name",
    "world": "name",
}
_VALUES = {
    **dict.fromkeys(("ixx", "ixy", "ixz", "iyy", "iyz", "izz", "mass"), ""),
    **dict.fromkeys(("length", "normal", "radii", "radius", "scale", "size", "uri"), ""),
    **dict.fromkeys(("child", "parent", "use_parent_model_frame"), ""),
    **dict.fromkeys(("damping", "effort", "friction", "lower", "upper", "velocity"), ""),
    **dict.fromkeys(("multiplier", "offset", "reference"), ""),
    "pose": "degrees frame relative_to rotation_format",
    "xyz": "expressed_in",
}
WORDS: Words = {
    **{name: frozenset(attributes.split()) for name, attributes in _ELEMENTS.items()},
    **{name: frozenset((TEXT, *attributes.split())) for name, attributes in _VALUES.items()},
}

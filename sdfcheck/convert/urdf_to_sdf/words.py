"""The elements of URDF that have a counterpart in SDFormat, and the attributes in which they say something."""

from __future__ import annotations

from sdfcheck.convert.ledger import Words

_PAIRS = {
    "axis": "xyz",
    "box": "size",
    "capsule": "radius length",
    "child": "link",
    "collision": "name",
    "color": "rgba",
    "cylinder": "radius length",
    "drake:capsule": "radius length",
    "drake:ellipsoid": "a b c",
    "drake:joint": "name type",
    "dynamics": "damping friction",
    "frame": "link name xyz rpy",
    "gazebo": "reference",
    "geometry": "",
    "inertia": "ixx ixy ixz iyy iyz izz",
    "inertial": "",
    "joint": "name type",
    "limit": "lower upper effort velocity",
    "link": "name",
    "mass": "value",
    "material": "name",
    "mesh": "filename scale",
    "mimic": "joint multiplier offset",
    "origin": "xyz rpy quat_xyzw",
    "parent": "link",
    "robot": "name version",
    "sphere": "radius",
    "texture": "filename",
    "visual": "name",
}
WORDS: Words = {name: frozenset(attributes.split()) for name, attributes in _PAIRS.items()}

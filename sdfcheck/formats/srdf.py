"""SRDF: what srdfdom and MoveIt read of it, and what its attributes name.

Source: srdfdom (ros2, noetic) and MoveIt's robot model.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence

REQUIRED: Mapping[str, tuple[str, ...]] = {
    "chain": ("base_link", "tip_link"),
    "disable_collisions": ("link1", "link2"),
    "disable_default_collisions": ("link",),
    "enable_collisions": ("link1", "link2"),
    "end_effector": ("name", "group", "parent_link"),
    "group": ("name",),
    "group_state": ("name", "group"),
    "joint": ("name",),
    "link": ("name",),
    "link_sphere_approximation": ("link",),
    "passive_joint": ("name",),
    "virtual_joint": ("name", "type", "parent_frame", "child_link"),
}
"""Element → the attributes without which srdfdom drops it; a joint of a state needs its value, too."""

NAMES: Mapping[tuple[str, str], str] = {
    ("chain", "base_link"): "link",
    ("chain", "tip_link"): "link",
    ("disable_collisions", "link1"): "link",
    ("disable_collisions", "link2"): "link",
    ("disable_default_collisions", "link"): "link",
    ("enable_collisions", "link1"): "link",
    ("enable_collisions", "link2"): "link",
    ("end_effector", "parent_link"): "link",
    ("joint", "name"): "joint",
    ("link", "name"): "link",
    ("link_sphere_approximation", "link"): "link",
    ("passive_joint", "name"): "joint",
    ("virtual_joint", "child_link"): "link",
}
"""Element and attribute → what of the robot it names."""

GROUPS = frozenset({("end_effector", "group"), ("end_effector", "parent_group"), ("group_state", "group")})
"""Elements and attributes that name groups; a group in a group does by its name."""

CHILDREN: Mapping[str, tuple[str, ...]] = {
    "robot": (
        "group",
        "group_state",
        "end_effector",
        "virtual_joint",
        "passive_joint",
        "disable_collisions",
        "enable_collisions",
        "disable_default_collisions",
        "link_sphere_approximation",
    ),
    "group": ("joint", "link", "chain", "group"),
    "group_state": ("joint",),
    "link_sphere_approximation": ("sphere",),
}
"""Element → the elements that it may hold."""

OPTIONAL: Mapping[str, tuple[str, ...]] = {
    "disable_collisions": ("reason",),
    "enable_collisions": ("reason",),
    "end_effector": ("parent_group",),
    "joint": ("value",),
    "robot": ("name", "version"),
    "sphere": ("center", "radius"),
}
CHOICES: Mapping[tuple[str, str], tuple[str, ...]] = {
    ("disable_collisions", "reason"): ("Adjacent", "Never", "Default", "Always", "User"),
    ("enable_collisions", "reason"): ("User",),
    ("virtual_joint", "type"): ("fixed", "floating", "planar"),
}
"""Element and attribute → the values that MoveIt's assistant writes or its robot model reads."""


def named_by(around: Sequence[str], attribute: str) -> tuple[str, ...]:
    """The kinds of things that an attribute names; ``around`` are the names of the elements down to its own."""
    tag = around[-1]
    if tag == "group" and attribute == "name":
        return ("group",) if "group" in around[:-1] else ()
    if (tag, attribute) in GROUPS:
        return ("group",)
    kind = NAMES.get((tag, attribute))
    return () if kind is None else (kind,)

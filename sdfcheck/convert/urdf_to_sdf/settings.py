"""The settings of ``<gazebo>`` blocks: libsdformat's words, and where SDFormat has them."""

from __future__ import annotations

from sdfcheck.convert.writer import Node
from sdfcheck.source.element import Element

COUNT = ("max_contacts",)
"""Where a whole number is wanted."""
OF_COLLISIONS = {
    "mu1": ("surface", "friction", "ode", "mu"),
    "mu": ("surface", "friction", "ode", "mu"),
    "mu2": ("surface", "friction", "ode", "mu2"),
    "fdir1": ("surface", "friction", "ode", "fdir1"),
    "kp": ("surface", "contact", "ode", "kp"),
    "kd": ("surface", "contact", "ode", "kd"),
    "maxVel": ("surface", "contact", "ode", "max_vel"),
    "minDepth": ("surface", "contact", "ode", "min_depth"),
    "maxContacts": COUNT,
    "max_contacts": COUNT,
    "laserRetro": ("laser_retro",),
}
"""The settings in a block for a link about each of its collisions."""
OF_JOINT = {
    "stopCfm": ("physics", "ode", "limit", "cfm"),
    "stopErp": ("physics", "ode", "limit", "erp"),
    "fudgeFactor": ("physics", "ode", "fudge_factor"),
    "provideFeedback": ("physics", "provide_feedback"),
    "implicitSpringDamper": ("physics", "ode", "implicit_spring_damper"),
    "cfmDamping": ("physics", "ode", "implicit_spring_damper"),
    "springReference": ("axis", "dynamics", "spring_reference"),
    "springStiffness": ("axis", "dynamics", "spring_stiffness"),
}
BOUNDS = frozenset({"lower", "upper", "effort", "velocity", "damping", "friction"})
FLAGS = {"turnGravityOff": ("gravity", True), "selfCollide": ("self_collide", False)}
"""Setting → SDFormat's name for it, and whether it says the contrary."""
TRUE = frozenset({"true", "yes", "1"})


def merge(extra: Node, into: Node) -> None:
    """Write what is in one element into another: values replace, structures are joined."""
    into.attributes.update({k: v for k, v in extra.attributes.items() if k != "name"})
    if extra.text:
        into.text = extra.text
    for child in extra.children:
        if not isinstance(child, Node):
            into.children.append(child)
        elif (there := into.find(child.name)) is not None and child.name not in {"plugin", "sensor"}:
            merge(child, there)
        else:
            into.children.append(child)


def value_of(entry: Element) -> str:
    """The text of a setting, or its ``value`` attribute."""
    return " ".join((entry.content or entry.attributes.get("value", "")).split())

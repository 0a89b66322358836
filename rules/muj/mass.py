"""The links that MuJoCo takes for bodies without mass."""

from sdfcheck import Link

LEAST = 1e-15
"""The least mass and moments of a body that moves."""


def is_massless(link: Link) -> bool:
    """Does a joint move the link, and has neither it nor anything fixed to it mass and moments?"""
    joint = link.parent_joints[0] if link.parent_joints else None
    is_moved = joint is not None and (joint.moves or joint.type == "spherical")
    return is_moved and not any(map(_has_mass, _fused(link)))


def _fused(link: Link) -> set[Link]:
    """The link with all that fixed joints tie to it from below, which MuJoCo makes one body."""
    found = {link}
    waiting = [link]
    while waiting:
        for joint in waiting.pop().child_joints:
            child = joint.child_link if joint.is_fixed else None
            if child is not None and child not in found:
                found.add(child)
                waiting.append(child)
    return found


def _has_mass(link: Link) -> bool:
    """By its inertial, or by its collisions where it has none; what is not a number is reported for itself."""
    inertial = link.inertial
    if not inertial.is_given:
        return link.has("collision")
    if not inertial.has("mass") or not inertial.has("inertia"):
        return True
    numbers = [inertial.mass, *(inertial.moments[moment] for moment in ("ixx", "iyy", "izz"))]
    return not any(number.is_given and number.number < LEAST for number in numbers)

from collections.abc import Iterator
from math import inf, sqrt

from sdfcheck import Bad, Diagnostic, Good, Joint, Link, Model, Rule, Severity
from sdfcheck_rules.jnt.powerless_joint import is_held_by_effort

GRAVITY = 9.81
"""m/s²."""
MOST = 3.0
"""Times the effort: of 6,972 joints of public robots that have an effort five in three robots ask for more."""
INERTIAL = (
    '<inertial><origin xyz="{} 0 0"/><mass value="10"/><inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/>'
    "</inertial>"
)
ARM = (
    f'<robot name="r"><link name="base">{INERTIAL.format(0)}</link><link name="arm">{INERTIAL.format(0.5)}</link>'
    '<joint name="lift" type="{1}"><parent link="base"/><child link="arm"/><axis xyz="{2}"/>'
    '<limit lower="-1" upper="1" effort="{0}" velocity="1"/></joint></robot>'
)


class OverloadedJoint(Rule):
    """The weight of what a joint carries is several times its effort.

    It cannot hold its load, and gives way as soon as the simulation starts. Often a mass is in grams, or the effort
    was left as a placeholder. The torque is that of gravity about the axis, where the center of all links below is as
    far to the side as it can come by this joint; the others are at zero, and the root of the robot stands upright.
    Springs that carry the load are not known here. In a robot that drives none of these joints by its effort, this is
    a hint.
    """

    code = "JNT026"
    name = "overloaded-joint"
    severity = Severity.WARNING
    remedy = """Compare the masses below the joint with the machine, then the effort with its drive.

    `sdfcheck inertia FILE` lists the masses in kg; the effort is in N·m, or in N for a slide. If a spring or a
    counterweight carries the load, ignore this finding.
    """
    looks_at = (Model,)
    selects = ("urdf:robot",)
    needs = ("effort",)

    bad = (
        Bad(
            ARM.format("«5»", "revolute", "0 1 0"),
            says="gravity asks up to 49.05 N·m of joint `lift`, and its effort is 5",
        ),
        Bad(
            ARM.format("«5»", "prismatic", "0 0 1"),
            says="gravity asks 98.1 N of joint `lift`, and its effort is 5",
        ),
    )
    good = (
        Good(ARM.format("60", "revolute", "0 1 0")),
        Good(ARM.format("20", "revolute", "0 1 0"), why="springs may help"),
        Good(ARM.format("5", "revolute", "0 0 1"), why="it turns about the vertical"),
        Good(ARM.format("0", "revolute", "0 1 0"), why="zero-limit and powerless-joint own this one"),
    )

    @staticmethod
    def applies(model: Model) -> bool:
        return bool(overloaded(model))

    def check(self, model: Model) -> Iterator[Diagnostic]:
        (joint, load), *others = overloaded(model)
        asked = f"{load:.4g} N" if joint.type == "prismatic" else f"up to {load:.4g} N·m"
        more = f"; the same holds for {len(others)} more" if others else ""
        effort = joint.axis.limit.effort
        yield self.diagnostic(
            effort,
            f"gravity asks {asked} of {joint.title}, and its effort is {effort.text}{more}",
            labels={each.axis.limit.effort: "the same" for each, _ in others[:3]},
            severity=None if is_held_by_effort(joint) else Severity.INFO,
        )


def overloaded(model: Model) -> list[tuple[Joint, float]]:
    """The joints that carry several times their effort, with the torque or force; first the worst that is driven."""
    limited = [
        joint
        for joint in model.joints
        if joint.type in {"revolute", "prismatic"} and 0 < joint.axis.limit.effort.number < inf
    ]
    if not limited:
        return []
    carried = weights(model)
    found = [(joint, load) for joint in limited if (load := load_of(joint, carried.get(joint))) > 0]
    return sorted(
        found, key=lambda each: (not is_held_by_effort(each[0]), -each[1] / each[0].axis.limit.effort.number)
    )


def weights(model: Model) -> dict[Joint, list[float]]:
    """Each joint with the mass (kg) of all links below it, and the sum of mass times position (kg·m)."""
    below: dict[Link, list[float]] = {}
    for link, pose in model.poses_at_rest.items():
        mass, center = link.inertial.mass.number, link.inertial.center
        below[link] = [0.0] * 4
        if link.inertial.is_given and 0 < mass < inf and center is not None:
            below[link] = [mass, *(mass * at for at in pose.applied_to(center))]
    found: dict[Joint, list[float]] = {}
    for link, moments in reversed(below.items()):  # parents are in front of their children
        if link.parent_joints and any(moments):
            joint = link.parent_joints[0]
            found[joint] = moments
            if joint.parent_link is not None:
                at = below[joint.parent_link]
                at[:] = (own + more for own, more in zip(at, moments, strict=True))
    return found


def load_of(joint: Joint, carried: list[float] | None) -> float:
    """The torque or force of gravity on a joint (N·m or N), if that is several times its effort; else 0."""
    place, axis = joint.at_rest, joint.direction
    if carried is None or place is None or axis is None:
        return 0.0
    mass, *moments = carried
    if joint.type == "prismatic":
        load = mass * abs(axis[2])
    else:
        arm = [moment - mass * at for moment, at in zip(moments, place.position, strict=True)]
        along = sum(one * other for one, other in zip(arm, axis, strict=True))
        aside = max(0.0, sum(each * each for each in arm) - along * along)
        load = sqrt(aside * max(0.0, 1 - axis[2] ** 2))
    load *= GRAVITY
    return load if load > MOST * joint.axis.limit.effort.number else 0.0

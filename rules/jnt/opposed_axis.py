from collections.abc import Iterator, Sequence
from math import dist, hypot
from operator import mul

from sdfcheck import Bad, Diagnostic, Good, Joint, Rule, Severity
from sdfcheck_rules.jnt.asymmetric_joint import origin_of

LEAST, TWINS = 3, 2
"""Counterparts that agree: by their names, or by the same meshes."""
NEAR = 0.02
"""Of the cosine: the axes of parts that were measured differ by as much."""
ASIDE, APART = 0.005, 0.15
"""How far a finger is from the middle of its hand (m), and the share of its distance that it may be off the place of
the mirror image of another one."""
SIDES = ("front_left", "front_right", "rear_left", "rear_right")


def wheels(*axes: str) -> str:
    """A robot with a wheel for each axis."""
    text = "".join(
        f'<link name="{side}_wheel"/><joint name="{side}_joint" type="continuous"><parent link="base"/>'
        f'<child link="{side}_wheel"/><axis xyz="{axis}"/></joint>'
        for side, axis in zip(SIDES, axes, strict=True)
    )
    return f'<robot name="r"><link name="base"/>{text}</robot>'


def fingers(*axes: str, places: tuple[str, ...] = ("0 0 0",) * 3) -> str:
    """A hand with a finger of one mesh for each axis."""
    visual = '<visual><geometry><mesh filename="finger.stl"/></geometry></visual>'
    text = "".join(
        f'<link name="{name}">{visual}</link><joint name="{name}_joint" type="continuous"><parent link="palm"/>'
        f'<child link="{name}"/><origin xyz="{place}"/><axis xyz="{axis}"/></joint>'
        for name, axis, place in zip("abc", axes, places, strict=True)
    )
    return f'<robot name="r"><link name="palm"/>{text}</robot>'


class OpposedAxis(Rule):
    """A joint turns the other way than all its counterparts.

    Four wheels or legs have axes in one direction, or in one direction on each side. Where three agree and one is
    the opposite, that one drives backwards. No robot of 369 public ones has such a joint. Three fingers that are made
    of the same meshes have the same axes in their links, however they are mounted: of 64 such groups in public robots
    one has a joint that is the opposite.
    """

    code = "JNT021"
    name = "opposed-axis"
    severity = Severity.WARNING
    remedy = """Turn the axis around, or the sign of the counterparts, so that all of them agree.

    Watch the frame: a joint that is mounted with half a turn in its `rpy` needs the opposite axis to turn
    the same way. With the axis, the limits change: exchange and negate them. If the drive is really mounted
    the other way, say so in a comment that ignores this.
    """
    looks_at = (Joint,)
    selects = ("urdf:robot/joint",)

    bad = (
        Bad(
            wheels("0 1 0", "0 1 0", "«0 -1 0»", "0 1 0"),
            says="the axis 0 -1 0 of joint `rear_left_joint` is opposite to those of its 3 counterparts",
        ),
        Bad(
            fingers("0 1 0", "«0 -1 0»", "0 1 0"),
            says="the axis 0 -1 0 of joint `b_joint` is opposite to those of its 2 counterparts",
        ),
    )
    good = (
        Good(wheels("0 1 0", "0 -1 0", "0 1 0", "0 -1 0"), why="mirrored"),
        Good(wheels(*["0 1 0"] * 4)),
        Good(
            fingers("0 1 0", "0 1 0", "0 -1 0", places=("0.03 0 0.1", "0.01 0 0.1", "-0.01 0 0.1")),
            why="the fingers spread from the middle of the hand",
        ),
    )

    @staticmethod
    def applies(joint: Joint) -> bool:
        return is_opposed(joint)

    def check(self, joint: Joint) -> Iterator[Diagnostic]:
        axis, others = joint.axis.xyz, agreeing(joint)
        yield self.diagnostic(
            axis,
            f"the axis {axis.text} of {joint.title} is opposite to those of its {len(others)} counterparts",
            labels={others[0].axis.xyz: "the axis of one of them"},
        )


def is_opposed(joint: Joint) -> bool:
    """Is its axis the opposite of one that all its counterparts have?"""
    others = agreeing(joint) if joint.moves and len(joint.axis.xyz) == 3 and joint.axis.xyz.is_given else ()
    return bool(others) and cosine(joint.axis.xyz, others[0].axis.xyz) < NEAR - 1


def is_across(joint: Joint, other: Joint) -> bool:
    """Is it where the mirror image of another one is, on the other side of their link?"""
    own, its = origin_of(joint), origin_of(other)
    near = APART * hypot(*own)
    return len(own) == len(its) == 3 and any(
        abs(own[axis]) > ASIDE
        and dist(own, [-at if axis == each else at for each, at in enumerate(its)]) < near
        for axis in range(3)
    )


def agreeing(joint: Joint) -> tuple[Joint, ...]:
    """The other joints of its kind, if they have one axis, and there are enough of them."""
    named = joint.counterparts
    if len(named) >= LEAST and all(turns(other) == turns(joint) for other in named) and has_one_axis(named):
        return named
    twins = joint.twins
    if len(twins) < TWINS or not has_one_axis(twins) or any(is_across(joint, twin) for twin in twins):
        return ()
    return twins


def has_one_axis(joints: tuple[Joint, ...]) -> bool:
    """Have they the same axis, which points somewhere?"""
    return all(cosine(joints[0].axis.xyz, joint.axis.xyz) > 1 - NEAR for joint in joints)


def cosine(one: Sequence[float], other: Sequence[float]) -> float:
    """That of the angle between two directions; 0 where one of them points nowhere."""
    lengths = hypot(*one) * hypot(*other)
    return sum(map(mul, one, other)) / lengths if len(one) == len(other) == 3 and lengths else 0.0


def turns(joint: Joint) -> tuple[str, str]:
    """Type and turn of its frame."""
    origin = joint.find("origin")
    return joint.type, "" if origin is None else " ".join(origin.text_of("rpy", "0 0 0").split())

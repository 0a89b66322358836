from collections.abc import Iterator, Sequence
from math import copysign, hypot
from operator import mul

from sdfcheck import Bad, Diagnostic, Good, Joint, Model, Rule, Severity

LEAST, TWINS = 3, 2
"""Counterparts that agree: by their names, or by the same meshes."""
BARS = 4
"""The bars of a gripper whose fingers stay parallel, each on a joint."""
NEAR, SMALL = 0.02, 0.002
"""Of the cosine, and m: axes of parts that were measured differ by as much."""
FOLLOW = ('<mimic joint="a_joint"/>',) * 3
SIDES = ("front_left", "front_right", "rear_left", "rear_right")


def wheels(*axes: str) -> str:
    """A robot with a wheel for each axis."""
    text = "".join(
        f'<link name="{side}_wheel"/><joint name="{side}_joint" type="continuous"><parent link="base"/>'
        f'<child link="{side}_wheel"/><axis xyz="{axis}"/></joint>'
        for side, axis in zip(SIDES, axes, strict=True)
    )
    return f'<robot name="r"><link name="base"/>{text}</robot>'


def fingers(*axes: str) -> str:
    """A hand with a finger of one mesh for each axis."""
    visual = '<visual><geometry><mesh filename="finger.stl"/></geometry></visual>'
    text = "".join(
        f'<link name="{name}">{visual}</link><joint name="{name}_joint" type="continuous"><parent link="palm"/>'
        f'<child link="{name}"/><origin rpy="0 0 {turn}"/><axis xyz="{axis}"/></joint>'
        for turn, (name, axis) in enumerate(zip("abc", axes, strict=True))
    )
    return f'<robot name="r"><link name="palm"/>{text}</robot>'


def bars(*axes: str) -> str:
    """A gripper with a bar for each axis, two on each side."""
    text = "".join(
        f'<link name="{name}"/><joint name="{name}_joint" type="revolute"><parent link="palm"/><child link="{name}"/>'
        f'<origin xyz="0 {place} 0.05"/><axis xyz="{axis}"/><limit lower="0" upper="0.8" effort="1" velocity="1"/>'
        f"{follows}</joint>"
        for name, place, axis, follows in zip(
            "abcd", (0.03, 0.01, -0.01, -0.03), axes, ("", *FOLLOW), strict=True
        )
    )
    return f'<robot name="r"><link name="palm"/>{text}</robot>'


class OpposedAxis(Rule):
    """A joint turns the other way than all its counterparts.

    Four wheels or legs have axes in one direction, or in one direction on each side. Where three agree and one is
    the opposite, that one drives backwards. No robot of 369 public ones has such a joint. Three fingers that are made
    of the same meshes have the same axes in their links, however they are mounted: of 64 such groups in public robots
    one has a joint that is the opposite. The four bars of a gripper that move as one (`mimic`) turn one way on one
    side, and the opposite way on the other; all of 19 public ones do.
    """

    code = "JNT021"
    name = "opposed-axis"
    severity = Severity.WARNING
    remedy = """Turn the axis around, or the sign of the counterparts, so that all of them agree.

    Watch the frame: a joint that is mounted with half a turn in its `rpy` needs the opposite axis to turn
    the same way. With the axis, the limits change: exchange and negate them. If the drive is really mounted
    the other way, say so in a comment that ignores this.
    """
    looks_at = (Model,)
    selects = ("urdf:robot",)

    bad = (
        Bad(
            wheels("0 1 0", "0 1 0", "«0 -1 0»", "0 1 0"),
            says="the axis 0 -1 0 of joint `rear_left_joint` is opposite to those of its 3 counterparts",
        ),
        Bad(
            fingers("0 1 0", "«0 -1 0»", "0 1 0"),
            says="the axis 0 -1 0 of joint `b_joint` is opposite to those of its 2 counterparts",
        ),
        Bad(
            bars("1 0 0", "«-1 0 0»", "-1 0 0", "-1 0 0"),
            says="joint `b_joint` turns the other way than the three that move with it, seen from its side",
        ),
    )
    good = (
        Good(bars("1 0 0", "1 0 0", "-1 0 0", "-1 0 0")),
        Good(wheels("0 1 0", "0 -1 0", "0 1 0", "0 -1 0"), why="mirrored"),
        Good(wheels(*["0 1 0"] * 4)),
    )

    @staticmethod
    def applies(model: Model) -> bool:
        return any(map(is_opposed, model.joints)) or any(reversed_links(model))

    def check(self, model: Model) -> Iterator[Diagnostic]:
        for joint in filter(is_opposed, model.joints):
            axis, others = joint.axis.xyz, agreeing(joint)
            yield self.diagnostic(
                axis,
                f"the axis {axis.text} of {joint.title} is opposite to those of its {len(others)} counterparts",
                labels={others[0].axis.xyz: "the axis of one of them"},
            )
        for joint, other in reversed_links(model):
            yield self.diagnostic(
                joint.axis.xyz,
                f"{joint.title} turns the other way than the three that move with it, seen from its side",
                labels={other.axis.xyz: "the axis of one of them"},
            )


def is_opposed(joint: Joint) -> bool:
    """Is its axis the opposite of one that all its counterparts have?"""
    others = agreeing(joint) if joint.moves and len(joint.axis.xyz) == 3 and joint.axis.xyz.is_given else ()
    return bool(others) and cosine(joint.axis.xyz, others[0].axis.xyz) < NEAR - 1


def agreeing(joint: Joint) -> tuple[Joint, ...]:
    """The other joints of its kind, if they have one axis, and there are enough of them."""
    named = joint.counterparts
    if len(named) >= LEAST and all(turns(other) == turns(joint) for other in named) and has_one_axis(named):
        return named
    twins = joint.twins
    return twins if len(twins) >= TWINS and has_one_axis(twins) else ()


def has_one_axis(joints: tuple[Joint, ...]) -> bool:
    """Have they the same axis, which points somewhere?"""
    return all(cosine(joints[0].axis.xyz, joint.axis.xyz) > 1 - NEAR for joint in joints)


def cosine(one: Sequence[float], other: Sequence[float]) -> float:
    """That of the angle between two directions; 0 where one of them points nowhere."""
    lengths = hypot(*one) * hypot(*other)
    return sum(map(mul, one, other)) / lengths if len(one) == len(other) == 3 and lengths else 0.0


def reversed_links(model: Model) -> Iterator[tuple[Joint, Joint]]:
    """The one joint of a linkage that turns the other way than the three others do, with one of these.

    Four joints that move as one on one parent, about parallel axes, carry two pairs of bars, as in a gripper: those on
    one side turn one way, those on the other the opposite way.
    """
    groups: dict[tuple[object, Joint], list[tuple[Joint, float]]] = {}
    for joint in model.joints:
        leader, way = led(joint)
        if joint.type == "revolute" and joint.is_one_sided and joint.at_rest is not None and joint.direction:
            groups.setdefault((joint.parent, leader), []).append((joint, way))
    for group in groups.values():
        if len(group) != BARS:
            continue
        senses = sides_of([joint for joint, _ in group], [way for _, way in group])
        odd = [joint for (joint, _), sense in zip(group, senses, strict=True) if senses.count(sense) == 1]
        if 0 not in senses and len(odd) == 1:
            yield odd[0], next(joint for joint, _ in group if joint is not odd[0])


def led(joint: Joint) -> tuple[Joint, float]:
    """The joint that it follows in the end, or itself, and the factor between them."""
    factor = 1.0
    for _ in range(BARS):
        mimic = joint.axis.mimic
        if mimic is None or mimic.leader is None:
            break
        joint, factor = mimic.leader, factor * float(mimic.multiplier)
    return joint, factor


def sides_of(joints: Sequence[Joint], ways: Sequence[float]) -> list[int]:
    """1 for each joint that turns one way, seen from the side where it is, -1 for the other way; 0 in the middle."""
    along = joints[0].direction or (0.0, 0.0, 0.0)
    places = [joint.at_rest.position for joint in joints if joint.at_rest is not None]
    middle = [sum(numbers) / len(places) for numbers in zip(*places, strict=True)]
    offsets = [across([a - b for a, b in zip(place, middle, strict=True)], along) for place in places]
    farthest = max(offsets, key=lambda offset: hypot(*offset))
    found = []
    for joint, way, offset in zip(joints, ways, offsets, strict=True):
        reach = sum(map(mul, offset, farthest)) / (hypot(*farthest) or 1.0)
        turn = cosine(joint.direction or (), along)
        found.append(
            0
            if abs(reach) < SMALL or abs(turn) < 1 - NEAR or not way
            else round(copysign(1, reach * turn * way))
        )
    return found


def across(offset: Sequence[float], along: Sequence[float]) -> list[float]:
    """The part of it that is at right angles to a direction of length 1."""
    share = sum(map(mul, offset, along))
    return [a - share * b for a, b in zip(offset, along, strict=True)]


def turns(joint: Joint) -> tuple[str, str]:
    """Type and turn of its frame."""
    origin = joint.find("origin")
    return joint.type, "" if origin is None else " ".join(origin.text_of("rpy", "0 0 0").split())

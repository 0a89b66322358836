from collections.abc import Iterator

from sdfcheck import Bad, Diagnostic, Good, Joint, Rule, Severity

LEAST = 3
"""Counterparts that agree."""
SIDES = ("front_left", "front_right", "rear_left", "rear_right")


def wheels(*axes: str) -> str:
    """A robot with a wheel for each axis."""
    text = "".join(
        f'<link name="{side}_wheel"/><joint name="{side}_joint" type="continuous"><parent link="base"/>'
        f'<child link="{side}_wheel"/><axis xyz="{axis}"/></joint>'
        for side, axis in zip(SIDES, axes, strict=True)
    )
    return f'<robot name="r"><link name="base"/>{text}</robot>'


class OpposedAxis(Rule):
    """A joint turns the other way than all its counterparts.

    Four wheels or legs have axes in one direction, or in one direction on each side. Where three agree and one is
    the opposite, that one drives backwards. No robot of 369 public ones has such a joint.
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
    )
    good = (Good(wheels("0 1 0", "0 -1 0", "0 1 0", "0 -1 0"), why="mirrored"), Good(wheels(*["0 1 0"] * 4)))

    @staticmethod
    def applies(joint: Joint) -> bool:
        return is_opposed(joint)

    def check(self, joint: Joint) -> Iterator[Diagnostic]:
        axis, others = joint.axis.xyz, joint.counterparts
        yield self.diagnostic(
            axis,
            f"the axis {axis.text} of {joint.title} is opposite to those of its {len(others)} counterparts",
            labels={others[0].axis.xyz: "the axis of one of them"},
        )


def is_opposed(joint: Joint) -> bool:
    """Is its axis the opposite of one that all its counterparts have?"""
    if not joint.moves or len(others := joint.counterparts) < LEAST:
        return False
    if not joint.axis.xyz.is_given or len(joint.axis.xyz) != 3 or turns(joint) != turns(others[0]):
        return False
    first = tuple(others[0].axis.xyz)
    if any(tuple(other.axis.xyz) != first or turns(other) != turns(joint) for other in others[1:]):
        return False
    return any(first) and tuple(-number for number in joint.axis.xyz) == first


def turns(joint: Joint) -> tuple[str, str]:
    """Type and turn of its frame."""
    origin = joint.find("origin")
    return joint.type, "" if origin is None else " ".join(origin.text_of("rpy", "0 0 0").split())

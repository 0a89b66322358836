from collections.abc import Iterator
from math import dist, hypot

from sdfcheck import Bad, Diagnostic, Good, Joint, Model, Rule, Severity

LEAST, SHARE = 0.005, 0.05
"""m, and of the distance: joints that are made by hand differ by less."""
MOST = 3
"""Pairs: a robot with more of them is not meant to be symmetric."""
JOINT = (
    '<joint name="{0}_wheel_joint" type="continuous"><origin xyz="{1}"/><parent link="base"/>'
    '<child link="{0}_wheel"/><axis xyz="0 1 0"/></joint>'
)
ROBOT = '<robot name="r"><link name="base"/><link name="left_wheel"/><link name="right_wheel"/>{}</robot>'


class AsymmetricJoint(Rule):
    """A joint on the right is not where the one of the same name is on the left.

    Machines are symmetric: apart from signs, the origins of two such joints are the same numbers. Of a thousand pairs
    in public robots two differ by more than 5 mm and 5 %, in one hand. A robot with more than three such pairs is
    not meant to be symmetric.
    """

    code = "JNT020"
    name = "asymmetric-joint"
    severity = Severity.WARNING
    remedy = """Place the joint where its counterpart is, mirrored: the same numbers with y negated.

    That is so for a robot that looks along x. Check both against the drawing, for either may be the wrong
    one. A macro of xacro with a `reflect` of 1 and -1 writes both sides from one set of numbers.
    """
    looks_at = (Model,)
    selects = ("urdf:robot",)
    scaffold = ROBOT

    bad = (
        Bad(
            JOINT.format("left", "0.1 0.2 0") + JOINT.format("right", "«0.1 -0.15 0»"),
            says="joint `right_wheel_joint` is 0.05 m from where the mirrored origin of `left_wheel_joint` is",
        ),
    )
    good = (
        Good(
            JOINT.format("left", "0.1 0.2 0") + JOINT.format("right", "0.1 -0.202 0"), why="rounded by hand"
        ),
        Good(
            JOINT.format("left", "0.1 0.2 0") + JOINT.format("right", "-0.1 0.2 0"), why="the frame is turned"
        ),
        Good(JOINT.format("left", "0.1 0.2 0") + JOINT.format("third", "0 0 0"), why="no counterpart"),
    )

    @staticmethod
    def applies(model: Model) -> bool:
        return bool(displaced(model))

    def check(self, model: Model) -> Iterator[Diagnostic]:
        for joint, mirror in displaced(model):
            origin, other = joint.find("origin"), mirror.find("origin")
            value = None if origin is None else origin.attribute("xyz")
            yield self.diagnostic(
                value or joint,
                f"{joint.title} is {displacement(joint, mirror):.3g} m from where the mirrored origin of"
                f" `{mirror.name}` is",
                labels={mirror if other is None else other: "its counterpart"},
            )


def displaced(model: Model) -> list[tuple[Joint, Joint]]:
    """The joints that are not where their counterparts are, each with it; none where a robot is not symmetric."""
    pairs = [
        (joint, mirror) for joint in model.joints if joint.moves and (mirror := joint.mirror) is not None
    ]
    found = [
        (joint, mirror)
        for joint, mirror in pairs
        if mirror.moves and joint.element.index > mirror.element.index and displacement(joint, mirror) > 0
    ]
    return found if len(found) <= MOST else []


def displacement(joint: Joint, mirror: Joint) -> float:
    """How far a joint is off the place of its counterpart (m); 0 where that is little."""
    own, other = place(joint), place(mirror)
    if len(own) != 3 or len(other) != 3:
        return 0.0
    found = dist(own, other)
    return found if found > max(LEAST, SHARE * max(hypot(*own), hypot(*other))) else 0.0


def place(joint: Joint) -> list[float]:
    """The coordinates of its origin without signs and order, for frames may be turned; none where unreadable."""
    origin = joint.find("origin")
    text = "0 0 0" if origin is None else origin.text_of("xyz", "0 0 0")
    try:
        return sorted(abs(float(word)) for word in text.split())
    except ValueError:
        return []

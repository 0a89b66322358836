from collections.abc import Iterator
from math import dist, hypot

from sdfcheck import Bad, Consumer, Diagnostic, Good, Joint, Rule, Severity, warns

LEAST, SHARE = 0.005, 0.05
"""m, and of the distance: joints that are made by hand differ by less."""
JOINT = (
    '<joint name="{0}_wheel_joint" type="continuous"><origin xyz="{1}"/><parent link="base"/>'
    '<child link="{0}_wheel"/><axis xyz="0 1 0"/></joint>'
)
ROBOT = '<robot name="r"><link name="base"/><link name="left_wheel"/><link name="right_wheel"/>{}</robot>'


class AsymmetricJoint(Rule):
    """A joint on the right is not where the one of the same name is on the left.

    Machines are symmetric: apart from signs, the origins of two such joints are the same numbers. Of 1,091 pairs
    in public robots those of four robots differ by more than 5 mm and 5 %, and one of these is a test whose places
    are random.
    """

    code = "JNT020"
    name = "asymmetric-joint"
    severity = Severity.WARNING
    affects = dict.fromkeys(Consumer, warns("takes it as it is"))
    looks_at = (Joint,)
    selects = ("urdf:robot/joint",)
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
    def applies(joint: Joint) -> bool:
        return displacement(joint) > 0

    def check(self, joint: Joint) -> Iterator[Diagnostic]:
        mirror = joint.mirror
        if mirror is None:
            return
        origin, other = joint.find("origin"), mirror.find("origin")
        value = None if origin is None else origin.attribute("xyz")
        yield self.diagnostic(
            value or joint,
            f"{joint.title} is {displacement(joint):.3g} m from where the mirrored origin of `{mirror.name}` is",
            labels={mirror if other is None else other: "its counterpart"},
        )


def displacement(joint: Joint) -> float:
    """How far the joint is off the place of its counterpart (m), on the second of the two; 0 where that is little."""
    mirror = joint.mirror if joint.moves else None
    if mirror is None or not mirror.moves or joint.span.start < mirror.span.start:
        return 0.0
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

from collections.abc import Iterator

from sdfcheck import Bad, Diagnostic, Element, Good, Joint, Link, Rule, Severity

LEAST, NEAR = 0.005, 1e-4
"""m"""
DOOR = (
    '<sdf version="1.9"><model name="m"><link name="frame"/><link name="door"><pose>0.4 0 1 0 0 0</pose></link>'
    '<joint name="hinge" type="revolute">{}<parent>frame</parent><child>door</child><axis><xyz>0 0 1</xyz></axis>'
    "</joint></model></sdf>"
)


class RepeatedPose(Rule):
    """The pose of a joint is that of its child once more.

    A joint is placed in the frame of its child link: without a pose it is at the origin of the link. The pose of the
    link in the model, written again for the joint, puts the axis twice as far away, and the part turns about a place
    beside it.
    """

    code = "JNT035"
    name = "repeated-pose"
    severity = Severity.WARNING
    remedy = """Remove the pose of the joint, or say that it is in the model: `<pose relative_to="__model__">`.

    `relative_to` came with SDFormat 1.7.
    """
    looks_at = (Joint,)
    selects = ("sdf:model/joint",)
    scaffold = "{}"

    bad = (
        Bad(
            DOOR.format("<pose>«0.4 0 1 0 0 0»</pose>"),
            says="the pose of joint `hinge` is in link `door`, whose own pose it repeats",
        ),
    )
    good = (
        Good(DOOR.format("")),
        Good(DOOR.format('<pose relative_to="__model__">0.4 0 1 0 0 0</pose>')),
        Good(DOOR.format("<pose>-0.4 0 0 0 0 0</pose>"), why="at the edge of the door"),
    )

    @staticmethod
    def applies(joint: Joint) -> bool:
        child, pose = joint.child_link, joint.find("pose")
        if child is None or pose is None or not joint.moves or pose.attributes:
            return False
        lower, upper = joint.axis.limit.range
        return lower != upper and repeats(pose, child)

    def check(self, joint: Joint) -> Iterator[Diagnostic]:
        pose, child = joint.find("pose"), joint.child_link
        assert pose is not None
        assert child is not None
        message = f"the pose of {joint.title} is in {child.title}, whose own pose it repeats"
        yield self.diagnostic(pose.own_value, message, labels={child: "this link"})


def repeats(pose: Element, link: Link) -> bool:
    """Has it the position of a link that is somewhere else than its model?"""
    own = link.find("pose")
    if own is None or own.attributes:
        return False
    mine, its = position(pose), position(own)
    far = max(map(abs, mine), default=0.0) > LEAST
    return far and len(mine) == len(its) and all(abs(x - y) < NEAR for x, y in zip(mine, its, strict=True))


def position(pose: Element) -> list[float]:
    """The first three numbers of a pose; none where one is not a number."""
    try:
        return [float(word) for word in pose.content.split()[:3]]
    except ValueError:
        return []

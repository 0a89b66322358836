from collections.abc import Iterator

from sdfcheck import IN_ROBOT, Bad, Diagnostic, Good, Joint, Rule, Severity

ENDLESS = 100.0
"""rad"""
VISUAL = '<visual><geometry><sphere radius="0.1"/></geometry></visual>'
LIMIT = '<limit lower="-1" upper="1" effort="1" velocity="1"/>'
WRIST = (
    f'<link name="{{0}}_hand">{VISUAL}</link><joint name="{{0}}_wrist" type="{{1}}"><parent link="base"/>'
    f'<child link="{{0}}_hand"/>{LIMIT}</joint>'
)


class UnlikeCounterpart(Rule):
    """A joint moves in another way than the one of the same name on the other side.

    One of them turns between limits, and the other without end, or slides. Robots are built alike on both sides, so the
    type of one is a mistake of a person or an exporter; `fixed-counterpart` is about joints that are fixed.
    """

    code = "JNT032"
    name = "unlike-counterpart"
    severity = Severity.WARNING
    remedy = """Give both joints the same type, and limits where it is `revolute` or `prismatic`.

    If the two sides differ on purpose, name the joints after what they do, or ignore this.
    """
    looks_at = (Joint,)
    selects = ("urdf:robot/joint",)
    scaffold = IN_ROBOT

    bad = (
        Bad(
            WRIST.format("left", "revolute") + WRIST.format("right", "«continuous»"),
            says="joint `right_wrist` is continuous, and its counterpart `left_wrist` is revolute",
            also=("JNT011",),
        ),
        Bad(WRIST.format("left", "«continuous»") + WRIST.format("right", "revolute"), also=("JNT011",)),
        Bad(WRIST.format("left", "revolute") + WRIST.format("right", "«prismatic»")),
    )
    good = (
        Good(WRIST.format("left", "revolute") + WRIST.format("right", "revolute")),
        Good(WRIST.format("left", "revolute") + WRIST.format("right", "fixed"), why="JNT028 says so"),
        Good(
            WRIST.format("left", "revolute") + WRIST.format("right", "revolute").replace(LIMIT, ""),
            why="missing-limit reports it",
        ),
        Good(
            WRIST.format("left", "revolute").replace("1", "1e16") + WRIST.format("right", "continuous"),
            why="neither has limits in effect",
        ),
    )

    @staticmethod
    def applies(joint: Joint) -> bool:
        mirror = joint.mirror
        if mirror is None or not joint.moves or not mirror.moves or kind_of(mirror) == kind_of(joint):
            return False
        if mirror.type == joint.type and not (mirror.has("limit") and joint.has("limit")):
            return False  # one of them lacks its limits, which missing-limit reports
        one, other = ((kind_of(each) == "continuous", each.name) for each in (joint, mirror))
        return one > other and all(
            each.child_link is not None and each.child_link.shapes for each in (joint, mirror)
        )

    def check(self, joint: Joint) -> Iterator[Diagnostic]:
        mirror = joint.mirror
        assert mirror is not None
        message = f"{joint.title} is {joint.type}, and its counterpart `{mirror.name}` is {mirror.type}"
        yield self.diagnostic(joint.type_value or joint, message, labels={mirror: "its counterpart"})


def kind_of(joint: Joint) -> str:
    """Its type; one that may turn many times over is as good as continuous."""
    low, high = joint.axis.limit.range
    return "continuous" if joint.type == "revolute" and high - low > ENDLESS else joint.type

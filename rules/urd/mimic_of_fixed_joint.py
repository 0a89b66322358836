from collections.abc import Iterator

from sdfcheck import Bad, Diagnostic, Good, Mimic, Rule, Severity

ROBOT = (
    '<robot name="r"><link name="a"/><link name="b"/><link name="c"/>'
    '<joint name="j" type="{}"><parent link="a"/><child link="b"/></joint>'
    '<joint name="k" type="continuous"><parent link="a"/><child link="c"/>'
    '<mimic joint="«j»"/></joint></robot>'
)


class MimicOfFixedJoint(Rule):
    """A joint follows one that is fixed.

    It can never move. In Gazebo the leader is merged away, and libsdformat refuses a
    mimic whose leader does not exist; Drake refuses it because the joints differ in their
    degrees of freedom.
    """

    code = "URD018"
    name = "mimic-of-fixed-joint"
    severity = Severity.ERROR
    remedy = """Let it follow a joint that moves, or remove the `mimic`.

    If the leader was made fixed for a simpler robot, make the follower fixed as well. Its position is then
    in its `<origin>`.
    """
    looks_at = (Mimic,)
    selects = ("urdf:joint/mimic",)

    bad = (Bad(ROBOT.replace("{}", "fixed"), says="joint `k` follows joint `j`, which is fixed"),)
    good = (
        Good(ROBOT.replace("{}", "continuous").replace("«", "").replace("»", "")),
        Good(
            ROBOT.replace("{}", "fixed").replace("continuous", "fixed").replace("«", "").replace("»", ""),
            why="a hand that was frozen as a whole",
        ),
    )

    @staticmethod
    def applies(mimic: Mimic) -> bool:
        return not mimic.joint.is_fixed and mimic.leader is not None and mimic.leader.is_fixed

    def check(self, mimic: Mimic) -> Iterator[Diagnostic]:
        leader, name = mimic.leader, mimic.leader_value
        if leader is not None and name is not None:
            message = f"{mimic.joint.title} follows joint `{name.text}`, which is fixed"
            yield self.diagnostic(name, message, labels={leader.type_value or leader: "its type"})

from collections.abc import Iterator

from sdfcheck import Bad, Consumer, Diagnostic, Good, Joint, Rule, Severity, accepts

OTHERWISE = (
    '<robot name="r"><link name="a"/><link name="b"/>'
    '<joint name="j" type="floating"><parent link="a"/><child link="b"/></joint>'
    '<gazebo><joint name="j" type="ball"><pose relative_to="a"/><parent>a</parent><child>b</child></joint></gazebo>'
    "</robot>"
)


class UnconvertedJoint(Rule):
    """A joint is of a type that SDFormat does not have.

    libsdformat drops a floating or planar joint when it converts the robot, but still
    places the child relative to it, so that Gazebo refuses the result, unless a `<gazebo>` block
    gives a joint or frame of that name.
    """

    code = "URD020"
    name = "unconverted-joint"
    severity = Severity.WARNING
    remedy = """Write a planar joint as two prismatic joints and a continuous one; remove a floating joint.

    The two links between them need a small mass and no shape. A robot whose root has no joint above it is
    free in Gazebo, which is what a floating joint says.
    """
    looks_at = (Joint,)
    selects = ("urdf:robot/joint",)
    scaffold = (
        '<robot name="r"><link name="a"/><link name="b"/>'
        '<joint name="j" type="{}"><parent link="a"/><child link="b"/></joint></robot>'
    )

    bad = (
        Bad("«planar»", says="joint `j` is planar, which SDFormat has no joint for"),
        Bad("«floating»", says="joint `j` is floating", also=("DRK008",)),
    )
    good = (
        Good("continuous", why="a revolute joint without limits"),
        Good("fixed"),
        Good(OTHERWISE, scaffold="{}"),
    )

    @staticmethod
    def applies(joint: Joint) -> bool:
        return joint.is_unconverted and not joint.is_replaced

    def check(self, joint: Joint) -> Iterator[Diagnostic]:
        child = joint.child_link
        is_dropped = child is not None and child.model.as_built_by(Consumer.GAZEBO).is_dropped(child)
        yield self.diagnostic(
            joint.type_value or joint,
            f"{joint.title} is {joint.type}, which SDFormat has no joint for",
            affects={Consumer.GAZEBO: accepts("drops its child, which has no mass")} if is_dropped else {},
        )

from collections.abc import Iterator

from sdfcheck import Bad, Diagnostic, GazeboBlock, Good, Rule, Severity, rename

DISABLED = "disableFixedJointLumping"
PRESERVED = "preserveFixedJoint"

LINKS = '<link name="a"/><link name="b"/>'
ENDS = '<parent link="a"/><child link="b"/>'
ROBOT = f'<robot name="r">{LINKS}<joint name="j" type="fixed">{ENDS}</joint>{{}}</robot>'


class DisabledLumping(Rule):
    """`disableFixedJointLumping` makes a fixed joint a revolute one.

    libsdformat then writes a revolute joint whose limits are both zero, which solvers hold
    only softly and drivers of joints count. `preserveFixedJoint` keeps a joint that is fixed.
    """

    code = "GAZ005"
    name = "disabled-lumping"
    severity = Severity.WARNING
    remedy = """Rename it to `preserveFixedJoint`.

    A fixed joint that is kept needs a link with mass on each side. Where only a sensor needs the frame, the
    name of the link survives as a frame without either setting.
    """
    looks_at = (GazeboBlock,)
    scaffold = ROBOT

    bad = (
        Bad(
            '<gazebo reference="j"><«disableFixedJointLumping»>true</disableFixedJointLumping></gazebo>',
            fixed='<gazebo reference="j"><preserveFixedJoint>true</preserveFixedJoint></gazebo>',
            unsafe=True,
            says="`disableFixedJointLumping` makes joint `j` revolute",
        ),
        Bad(
            '<gazebo reference="j"><«disableFixedJointLumping» value="1"/></gazebo>',
            fixed='<gazebo reference="j"><preserveFixedJoint value="1"/></gazebo>',
            unsafe=True,
        ),
    )
    good = (
        Good('<gazebo reference="j"><preserveFixedJoint>true</preserveFixedJoint></gazebo>'),
        Good('<gazebo reference="j"><disableFixedJointLumping>false</disableFixedJointLumping></gazebo>'),
        Good(
            '<gazebo reference="j"><disableFixedJointLumping>true</disableFixedJointLumping>'
            "<preserveFixedJoint>true</preserveFixedJoint></gazebo>",
            why="of both the better one wins",
        ),
    )

    @staticmethod
    def applies(block: GazeboBlock) -> bool:
        joint = block.joint if block.is_on(DISABLED) else None
        if joint is None or not joint.is_fixed:
            return False
        return not any(other.is_on(PRESERVED) for other in joint.gazebo_blocks)

    def check(self, block: GazeboBlock) -> Iterator[Diagnostic]:
        for element in block.switched_on(DISABLED):
            title = block.joint.title if block.joint is not None else block.reference
            fix = rename(PRESERVED, element)
            yield self.diagnostic(element, f"`{DISABLED}` makes {title} revolute", fix=fix)

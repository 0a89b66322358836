from collections.abc import Iterator

from sdfcheck import Bad, Consumer, Diagnostic, Edit, Good, Rule, Severity, make_fix, problems, warns

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
    affects = {Consumer.GAZEBO: warns("makes a revolute joint")}
    explains = (problems.DisabledLumping,)
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

    def check(self, problem: problems.DisabledLumping) -> Iterator[Diagnostic]:
        element = problem.element
        spans = (element.span, element.document.spans.end_name(element))
        edits = tuple(Edit(span, "preserveFixedJoint") for span in spans if span is not None)
        fix = make_fix("rename it to `preserveFixedJoint`", edits, unsafe=True)
        message = f"`{element.name}` makes {problem.joint.title} revolute"
        yield self.diagnostic(element, message, fix=fix)

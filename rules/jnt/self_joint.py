from collections.abc import Iterator

from sdfcheck import IN_MODEL, IN_ROBOT, REFUSES, Bad, Consumer, Diagnostic, Good, Rule, Severity, problems


class SelfJoint(Rule):
    """A joint ties a link to itself.

    Parent and child are one name, or frames that move with one link. libsdformat and
    Drake refuse the file, and in URDF the link hangs below itself, so there is no tree.
    """

    code = "JNT002"
    name = "self-joint"
    severity = Severity.ERROR
    affects = dict.fromkeys(Consumer, REFUSES)
    explains = (problems.SelfJoint,)
    scaffold = IN_MODEL

    bad = (
        Bad(
            '<joint name="j" type="fixed"><parent>base</parent><child>«base»</child></joint>',
            says="parent and child of joint `j` are both `base`",
        ),
        Bad(
            '<frame name="tip" attached_to="base"/>'
            '<joint name="j" type="fixed"><parent>base</parent><child>«tip»</child></joint>',
            says="parent `base` and child `tip` of joint `j` are both on link `base`",
        ),
        Bad(
            '<joint name="j" type="fixed"><parent>__model__</parent><child>«base»</child></joint>',
            says="both on link `base`",
        ),
        Bad(
            '<joint name="j" type="fixed"><parent link="base"/><child link="«base»"/></joint>',
            scaffold=IN_ROBOT,
            says="are both `base`",
        ),
    )
    good = (
        Good(
            '<link name="arm"/><frame name="tip" attached_to="arm"/>'
            '<joint name="j" type="fixed"><parent>base</parent><child>tip</child></joint>'
        ),
    )

    def check(self, problem: problems.SelfJoint) -> Iterator[Diagnostic]:
        child, parent, joint = problem.child, problem.parent, problem.joint
        if problem.link is None:
            message = f"parent and child of {joint.title} are both `{child.text}`"
        else:
            ends = f"parent `{parent.text}` and child `{child.text}` of {joint.title}"
            message = f"{ends} are both on link `{problem.link}`"
        yield self.diagnostic(child, message, labels={parent: "the parent"})

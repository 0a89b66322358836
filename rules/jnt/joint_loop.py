from collections.abc import Iterator

from sdfcheck import IN_MODEL, IN_ROBOT, REFUSES, Bad, Consumer, Diagnostic, Good, Rule, Severity, problems

_SHOWN = 6


class JointLoop(Rule):
    """Joints lead from a link, from parent to child, back to it.

    None of these links is the root, so nothing holds them. A URDF robot is a tree, and
    urdfdom refuses the file. SDFormat allows loops; Drake refuses two links that are
    each other's parents.
    """

    code = "JNT008"
    name = "joint-loop"
    severity = Severity.WARNING
    affects = {
        Consumer.GAZEBO: {"urdf": REFUSES},
        Consumer.DRAKE: REFUSES,
        Consumer.URDFDOM: REFUSES,
        Consumer.MUJOCO: REFUSES,
    }
    explains = (problems.JointLoop,)
    scaffold = IN_MODEL

    bad = (
        Bad(
            '<link name="arm"/><joint name="j" type="fixed"><parent>base</parent><child>«arm»</child></joint>'
            '<joint name="k" type="fixed"><parent>arm</parent><child>base</child></joint>',
            says="joints lead from link `arm` back to it: `arm` → `base` → `arm`",
        ),
        Bad(
            '<link name="a"/><link name="b"/>'
            '<joint name="j" type="fixed"><parent link="a"/><child link="«b»"/></joint>'
            '<joint name="k" type="fixed"><parent link="b"/><child link="a"/></joint>',
            scaffold=IN_ROBOT,
            says="joints lead from link `b` back to it",
        ),
    )
    good = (
        Good(
            '<link name="arm"/><joint name="j" type="fixed"><parent>world</parent><child>base</child></joint>'
            '<joint name="k" type="fixed"><parent>base</parent><child>arm</child></joint>'
        ),
    )

    def check(self, problem: problems.JointLoop) -> Iterator[Diagnostic]:
        links, ends = problem.links, problem.ends
        shown = [f"`{name}`" for name in links[:_SHOWN]]
        more = ["…"] if len(links) > _SHOWN else []
        loop = " → ".join((*shown, *more, f"`{links[0]}`"))
        labels = dict.fromkeys(ends[1:_SHOWN], "and on from here")
        yield self.diagnostic(
            ends[0],
            f"joints lead from link `{links[0]}` back to it: {loop}",
            labels=labels,
            severity=Severity.ERROR if problem.refused else None,
        )

from collections.abc import Iterator

from sdfcheck import (
    IN_MODEL,
    IN_ROBOT,
    REFUSES,
    Bad,
    Consumer,
    Diagnostic,
    Element,
    Good,
    Rule,
    Severity,
    accepts,
    named,
    problems,
    refuses,
    warns,
)


class SeveralParents(Rule):
    """A link is the child of more than one joint.

    A URDF robot is a tree, and urdfdom refuses a link with two parents. SDFormat allows it, and
    Gazebo closes the loop, but it is seldom meant; Drake and the solvers of kinematics want a tree.
    """

    code = "JNT007"
    name = "several-parents"
    severity = Severity.WARNING
    affects = {
        Consumer.GAZEBO: {"urdf": REFUSES},
        Consumer.DRAKE: refuses("refuses the loop"),
        Consumer.URDFDOM: warns("keeps one of the joints only"),
        Consumer.MUJOCO: REFUSES,
    }
    explains = (problems.SeveralParents,)
    scaffold = IN_MODEL

    bad = (
        Bad(
            '<link name="arm"/><joint name="j" type="fixed"><parent>base</parent><child>arm</child></joint>'
            '<joint name="k" type="fixed"><parent>world</parent><child>«arm»</child></joint>',
            says="link `arm` is child of 2 joints: `j` and `k`",
        ),
        Bad(
            '<link name="arm"/><link name="top"/>'
            '<joint name="j" type="fixed"><parent link="base"/><child link="arm"/></joint>'
            '<joint name="t" type="fixed"><parent link="base"/><child link="top"/></joint>'
            '<joint name="k" type="fixed"><parent link="top"/><child link="«arm»"/></joint>',
            scaffold=IN_ROBOT,
            says="link `arm` is child of 2 joints: `j` and `k`",
        ),
    )
    good = (
        Good(
            '<link name="arm"/><link name="hand"/>'
            '<joint name="j" type="fixed"><parent>base</parent><child>arm</child></joint>'
            '<joint name="k" type="fixed"><parent>arm</parent><child>hand</child></joint>'
        ),
        Good(
            '<link name="arm"/>'
            '<joint name="j" type="revolute"><parent>base</parent><child>arm</child>'
            "<axis><xyz>0 0 1</xyz></axis></joint>"
            '<joint name="g" type="gearbox"><parent>base</parent><child>arm</child>'
            "<gearbox_reference_body>base</gearbox_reference_body><gearbox_ratio>2</gearbox_ratio>"
            "<axis><xyz>0 0 1</xyz></axis><axis2><xyz>0 0 1</xyz></axis2></joint>",
            why="a gearbox couples links that other joints carry",
        ),
    )

    def check(self, problem: problems.SeveralParents) -> Iterator[Diagnostic]:
        joints = named(problem.joints, most=4)
        holders = (problem.child.element.parent, problem.first.element.parent)
        is_held = any(joint is not None and _is_held(joint) for joint in holders)
        affects = {Consumer.DRAKE: accepts("holds the link")} if is_held else {}
        yield self.diagnostic(
            problem.child,
            f"link `{problem.link}` is child of {len(problem.joints)} joints: {joints}",
            labels={problem.first: "first a child here"},
            severity=Severity.ERROR if problem.refused else None,
            affects=affects,
        )


def _is_held(joint: Element) -> bool:
    """Does a joint of SDFormat hold its child to the world? Then another one makes no loop."""
    parent = joint.find("parent")
    return parent is not None and parent.content.strip() == "world"

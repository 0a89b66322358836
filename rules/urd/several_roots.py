from collections.abc import Iterator

from sdfcheck import Bad, Diagnostic, Good, Model, Rule, Severity

TREES = (
    '<robot name="r"><link name="a"/><link name="b"/><link name="c"/>{}'
    '<joint name="j" type="fixed"><parent link="a"/><child link="b"/></joint></robot>'
)


class SeveralRoots(Rule):
    """The links form more than one tree.

    A URDF robot is one tree with one root. urdfdom, and with it nearly every program of
    ROS and the conversion to SDFormat, refuses anything else; Drake makes a free body of
    every root. Mostly a joint is missing, or two robots were put into one file.
    """

    code = "URD003"
    name = "several-roots"
    severity = Severity.ERROR
    remedy = """Add the joint that ties the root of this tree to the rest of the robot.

    A fixed joint is enough for parts that do not move:
    `<joint name="d_joint" type="fixed"><parent link="base"/><child link="d"/></joint>`.
    `sdfcheck graph joints FILE` shows the trees. Two robots belong in two files, or below one root link.
    """
    looks_at = (Model,)
    selects = ("urdf:robot",)
    scaffold = TREES

    bad = (
        Bad(
            '<«link» name="d"/><joint name="k" type="fixed"><parent link="d"/><child link="c"/></joint>',
            says="link `d` is the root of a second tree (2 links)",
        ),
    )
    good = (
        Good(
            '<joint name="k" type="fixed"><parent link="c"/><child link="a"/></joint>',
            why="a root need not come first",
        ),
    )

    @staticmethod
    def applies(robot: Model) -> bool:
        return any(len(group) > 1 for group in robot.tree.loose_groups)

    def check(self, robot: Model) -> Iterator[Diagnostic]:
        tree = robot.tree
        for group in tree.loose_groups:
            if len(group) > 1:
                root = tree.top(group)
                message = f"{root.title} is the root of a second tree ({len(group)} links)"
                labels, cause = {tree.top(tree.groups[0]): "the root of the largest"}, robot.misnamed("joint")
                yield self.diagnostic(root, message, labels=labels, cause=cause)

from collections.abc import Iterator

from sdfcheck import Bad, Consumer, Diagnostic, Good, Rule, Severity, problems, warns
from sdfcheck_rules.drk.scaffolds import ROBOT

LEAF = '<link name="c"/><joint name="k" type="{}"><parent link="b"/><child link="c"/></joint>'


class MasslessLeaf(Rule):
    """A link that can move, with all that hangs on it, has no mass.

    The file loads. The simulation stops at its first step, because the mass matrix is not
    positive definite. A massless link that is fixed to one with mass is fine, and so is a free one that
    the program welds to something.
    """

    code = "DRK011"
    name = "massless-leaf"
    severity = Severity.ERROR
    default = False
    affects = {Consumer.DRAKE: warns("stops at the first step of the simulation")}
    explains = (problems.MasslessLeaf,)
    scaffold = ROBOT

    bad = (
        Bad(
            LEAF.format("continuous").replace('<link name="c"', '<«link» name="c"'),
            says="link `c` moves by joint `k` and has no mass: Drake cannot simulate it",
            also=("URD014",),
        ),
    )
    good = (Good(LEAF.format("fixed"), why="moves with a link that has mass"),)

    def check(self, problem: problems.MasslessLeaf) -> Iterator[Diagnostic]:
        link, joint = problem.link, problem.joint
        moves = f"moves by {joint.title}" if joint is not None else "is free"
        below = f" with the {problem.links - 1} below it" if problem.links > 1 else ""
        labels = {joint: "it moves here"} if joint is not None else {}
        message = f"{link.title} {moves} and{below} has no mass: Drake cannot simulate it"
        level = Severity.ERROR if joint is not None else Severity.WARNING
        yield self.diagnostic(link, message, labels=labels, severity=level)

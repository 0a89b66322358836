from collections.abc import Iterable, Iterator

from sdfcheck import Bad, Diagnostic, Good, Joint, Link, Model, Rule, Severity
from sdfcheck_rules.drk.scaffolds import ROBOT

WORLD = "world"

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
    remedy = """Give the link an `<inertial>` with its mass and moments, or fix it to one that has them.

    `sdfcheck rule missing-inertial` says how to get the numbers. If your program welds the link to
    something, ignore this.
    """
    default = False
    looks_at = (Model,)
    selects = ("urdf:robot",)
    scaffold = ROBOT

    bad = (
        Bad(
            LEAF.format("continuous").replace('<link name="c"', '<«link» name="c"'),
            says="link `c` moves by joint `k` and has no mass: Drake cannot simulate it",
            also=("URD014",),
        ),
    )
    good = (Good(LEAF.format("fixed"), why="moves with a link that has mass"),)

    def check(self, model: Model) -> Iterator[Diagnostic]:
        for link, joint, count in _massless(model):
            moves = f"moves by {joint.title}" if joint is not None else "is free"
            below = f" with the {count - 1} below it" if count > 1 else ""
            message = f"{link.title} {moves} and{below} has no mass: Drake cannot simulate it"
            labels = {joint: "it moves here"} if joint is not None else {}
            level = Severity.ERROR if joint is not None else Severity.WARNING
            yield self.diagnostic(link, message, labels=labels, severity=level)


def _massless(model: Model) -> Iterator[tuple[Link, Joint | None, int]]:
    """The outermost links that move, with everything below them, without mass.

    With the joint that moves them (None for a free link), and how many they are.
    """
    tree = model.tree
    free: list[tuple[Link, Joint | None]] = [(link, None) for link in tree.roots if link.name != WORLD]
    moved = [(tree.ends(joint), joint) for joint in tree.joints if not joint.is_fixed]
    barred: set[Link] = set()

    def bar(links: Iterable[Link]) -> None:
        """Leave out links and all that carry them."""
        waiting = [link for link in links if link not in barred]
        while waiting:
            at = waiting.pop()
            barred.add(at)
            above = [ends[0] for joint in tree.parents.get(at, ()) if (ends := tree.ends(joint)) is not None]
            waiting += [link for link in above if link not in barred]

    bar(link for link in tree.links.values() if link.has_mass)
    for link, by in (*free, *((ends[1], joint) for ends, joint in moved if ends is not None)):
        if link not in barred:
            links = list(link.below())
            bar(links)
            yield link, by, len(links)

import re
from collections.abc import Iterator

from sdfcheck import Bad, Diagnostic, Good, Rule, Semantics, Severity
from sdfcheck_rules.srd.scaffold import FILE, ROBOT

SHAPE = '<collision><geometry><sphere radius="0.1"/></geometry></collision>'
SOLID = {**ROBOT, "arm.urdf": re.sub(r'(<link name="\w+")/>', rf"\1>{SHAPE}</link>", ROBOT["arm.urdf"])}
PAIR = '<disable_collisions link1="{}" link2="{}" reason="Adjacent"/>'
IN_MOVEIT = '<robot name="arm"><group name="all"><joint name="shoulder"/></group>{}</robot>'


class CollidingNeighbors(Rule):
    """The collisions of two links that a joint connects are not disabled.

    Such links touch at their joint. MoveIt checks each pair that SRDF does not disable, so it takes the robot for one
    that collides with itself, and refuses to plan from where it is.
    """

    code = "SRD012"
    name = "colliding-neighbors"
    severity = Severity.WARNING
    remedy = """Add an element for the pair, `<disable_collisions link1="wrist" link2="gripper" reason="Adjacent"/>`.

    After a change of the robot, as a new tool, let the MoveIt Setup Assistant work out the pairs again. Only links
    that have a `<collision>` count, and pairs of which a planning group moves a link.
    """
    looks_at = (Semantics,)
    scaffold = IN_MOVEIT

    bad = (
        Bad(
            PAIR.format("base", "upper").replace("disable_collisions", "«disable_collisions»"),
            file=FILE,
            files=SOLID,
            says="collisions of `upper` with `hand` are not disabled, which joint `wrist` connects",
        ),
    )
    good = (
        Good(PAIR.format("base", "upper") + PAIR.format("hand", "upper"), file=FILE, files=SOLID),
        Good(PAIR.format("base", "hand"), why="nothing collides", file=FILE, files=ROBOT),
        Good("", why="the pairs may be in another file", file=FILE, files=SOLID),
    )

    @staticmethod
    def applies(semantics: Semantics) -> bool:
        return bool(semantics.colliding_neighbors)

    def check(self, semantics: Semantics) -> Iterator[Diagnostic]:
        first, *others = semantics.colliding_neighbors
        links = f"`{first.parent_name}` with `{first.child_name}`"
        more = f" (and {len(others)} more)" if others else ""
        message = f"collisions of {links} are not disabled, which joint `{first.name}` connects{more}"
        *_, last = semantics.element.children("disable_collisions")
        element = (
            f'<disable_collisions link1="{first.parent_name}" link2="{first.child_name}" reason="Adjacent"/>'
        )
        yield self.diagnostic(last, message, help=f"add `{element}`")

from collections.abc import Iterator

from sdfcheck import Bad, Diagnostic, Good, Rule, Semantics, Severity
from sdfcheck_rules.srd.scaffold import FILE, IN_SRDF

SOLID = '<collision><geometry><box size="0.1 0.1 0.3"/></geometry></collision>'
JOINT = '<joint name="{0}" type="continuous"><origin xyz="0 0 {3}"/><parent link="{1}"/><child link="{2}"/></joint>'
ROBOT = {
    "arm.urdf": '<robot name="arm">'
    + "".join(f'<link name="{name}">{SOLID}</link>' for name in ("base", "upper", "hand"))
    + '<link name="flange"/>'
    + JOINT.format("shoulder", "base", "upper", 0.3)
    + JOINT.format("elbow", "upper", "flange", 0.3)
    + JOINT.format("wrist", "flange", "hand", 0)
    + "</robot>",
    "package.xml": "<package><name>arm</name></package>",
}
FINGER = (
    '<link name="{0}">'
    + SOLID
    + '</link><joint name="{0}_joint" type="prismatic"><origin xyz="0 {1} 0"/><parent link="hand"/>'
    '<child link="{0}"/><axis xyz="0 1 0"/><limit lower="{2}" upper="0.2" effort="9" velocity="1"/></joint>'
)
NEAR = '<origin xyz="0 0 0.3"/><parent link="base"/>'
APART = '<origin xyz="0 0 1"/><parent link="base"/>'
OFF = '<{} link1="{}" link2="{}" reason="Adjacent"/>'
OTHER = OFF.format("disable_collisions", "hand", "upper")
ALL = (
    '<group name="tool"><joint name="left_joint"/></group>'
    + OTHER
    + OFF.format("disable_collisions", "base", "upper")
    + OFF.format("disable_collisions", "hand", "left")
    + OFF.format("«disable_collisions»", "hand", "right")
)
CLOSED = ALL.replace("«", "").replace("»", "").replace(
    "/></group>", '/><joint name="right_joint"/></group>'
) + (
    '<group_state name="«closed»" group="tool"><joint name="left_joint" value="0.06"/>'
    '<joint name="right_joint" value="0"/></group_state>'
)


def gripper(*, apart: float, lower: float = 0.0) -> dict[str, str]:
    """The robot with two fingers."""
    fingers = FINGER.format("left", 0, 0) + FINGER.format("right", apart, lower)
    return ROBOT | {"arm.urdf": ROBOT["arm.urdf"].replace("</robot>", fingers + "</robot>")}


class UnlistedNeighbors(Rule):
    """Two links that touch in any case may collide, where others may not.

    MoveIt looks for collisions between all links but the pairs that `disable_collisions` lists, neighbors too. The
    shapes of two links with a joint between them nearly always touch there, so that every state of the robot is one
    in collision, and no motion can be planned. Its setup assistant lists all neighbors, also those with links without
    collisions between them; one that is missing was added to the robot later, or its link renamed. So do other
    links that are in each other with all joints at 0, as the fingers of a closed gripper are, or in a named state:
    MoveIt refuses it as a start and as a goal.
    """

    code = "SRD012"
    name = "unlisted-neighbors"
    severity = Severity.WARNING
    remedy = """Add the pair: `<disable_collisions link1="…" link2="…" reason="Adjacent"/>`.

    Or let the setup assistant work out the pairs of the robot again. If the two are to be kept apart on purpose,
    ignore this finding.
    """
    looks_at = (Semantics,)
    scaffold = IN_SRDF

    bad = (
        Bad(
            OFF.format("«disable_collisions»", "hand", "upper"),
            file=FILE,
            files=ROBOT,
            says="links `base` and `upper` are neighbors, and their collisions are not disabled",
        ),
        Bad(
            ALL,
            file=FILE,
            files=gripper(apart=0.06),
            says="links `left` and `right` are in each other with all joints at 0, and their collisions are not",
        ),
        Bad(
            CLOSED,
            file=FILE,
            files=gripper(apart=0.12),
            says="links `left` and `right` are in each other in state `closed`, and their collisions are not disabled",
        ),
    )
    good = (
        Good(OTHER + OFF.format("disable_collisions", "base", "upper"), file=FILE, files=ROBOT),
        Good(
            OTHER + '<disable_default_collisions link="base"/>',
            file=FILE,
            files=ROBOT,
            why="all collisions of one of them are off",
        ),
        Good(
            OTHER.replace("Adjacent", "Never"),
            file=FILE,
            files=ROBOT,
            why="nothing shows that neighbors are to be listed",
        ),
        Good(
            OTHER,
            file=FILE,
            files=ROBOT | {"arm.urdf": ROBOT["arm.urdf"].replace(NEAR, APART)},
            why="they are apart",
        ),
        Good(
            ALL.replace("«", "").replace("»", ""),
            file=FILE,
            files=gripper(apart=0.1),
            why="the fingers touch",
        ),
        Good(
            CLOSED.replace("«", "").replace("»", "").replace("0.06", "0.02"),
            file=FILE,
            files=gripper(apart=0.12),
            why="they touch in this state",
        ),
        Good(
            ALL.replace("«", "").replace("»", ""),
            file=FILE,
            files=gripper(apart=0.06, lower=0.05),
            why="the finger is never there",
        ),
    )

    @staticmethod
    def applies(semantics: Semantics) -> bool:
        found = (semantics.unlisted_neighbors, semantics.unlisted_overlaps, semantics.colliding_states)
        return any(True for each in found for _ in each)

    def check(self, semantics: Semantics) -> Iterator[Diagnostic]:
        *_, last = semantics.adjacent_pairs
        for pairs, what in (
            (semantics.unlisted_neighbors, "are neighbors"),
            (semantics.unlisted_overlaps, "are in each other with all joints at 0"),
        ):
            for (one, other), *others in filter(None, [list(pairs)]):
                message = (
                    f"links `{one.name}` and `{other.name}` {what}, and their collisions are not disabled"
                )
                message += f"; the same holds for {len(others)} more pairs" if others else ""
                yield self.diagnostic(last, message)
        states = list(semantics.colliding_states)
        for value, left, right in states[:1]:
            message = (
                f"links `{left.name}` and `{right.name}` are in each other in state `{value.text.strip()}`"
            )
            message += ", and their collisions are not disabled"
            message += f"; so are {len(states) - 1} more pairs in states" if states[1:] else ""
            yield self.diagnostic(value, message)

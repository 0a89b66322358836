from collections.abc import Iterator

from sdfcheck import Bad, Diagnostic, Good, Rule, Semantics, Severity
from sdfcheck_rules.srd.scaffold import FILE, GRIPPER, IN_SRDF, ROBOT

STATE = '<group_state name="home" group="{}"><joint name="{}" value="0"/></group_state>'
TOOL = '<group name="tool"><link name="hand"/></group>'

FOLLOWED = (
    '<group name="tool"><joint name="left"/><joint name="right"/></group><group_state name="open" group="tool">'
    '<joint name="left" value="0.04"/><joint name="right" value="{}"/></group_state>'
)


class IdleStateValue(Rule):
    """A state gives a value to a joint that cannot take it: one that is fixed, or that follows another joint.

    Or one that the group of the state does not have. MoveIt logs an error and leaves the value out: the joint stays
    where it is when the robot goes to that state. A joint with `mimic` gets the value, but no motion leads there: the
    planner, and the robot, move it with its leader.
    """

    code = "SRD010"
    name = "idle-state-value"
    severity = Severity.WARNING
    remedy = """Name a joint of the group that moves, or the group that has the joint.

    A state of several groups needs a group that consists of them: `<group name="all"><group name="arm"/>…`.
    """
    looks_at = (Semantics,)
    scaffold = IN_SRDF

    bad = (
        Bad(
            TOOL + STATE.format("tool", "«shoulder»"),
            file=FILE,
            files=ROBOT,
            says="state `home` has no effect on joint `shoulder`, which is not in group `tool`",
        ),
        Bad(TOOL + STATE.format("tool", "«wrist»"), file=FILE, files=ROBOT, says="which is fixed"),
        Bad(
            FOLLOWED.format("«0»"),
            file=FILE,
            files=GRIPPER,
            says="joint `right` follows `left` to 0.04, and is not at 0 in state `open`",
        ),
    )
    good = (
        Good(STATE.format("all", "shoulder"), file=FILE, files=ROBOT),
        Good(FOLLOWED.format("0.04"), file=FILE, files=GRIPPER),
        Good(
            FOLLOWED.format("0").replace('<joint name="left" value="0.04"/>', ""),
            file=FILE,
            files=GRIPPER,
            why="the state leaves open where its leader is",
        ),
    )

    @staticmethod
    def applies(semantics: Semantics) -> bool:
        return any(True for _ in semantics.idle_states) or any(True for _ in semantics.unfollowed)

    def check(self, semantics: Semantics) -> Iterator[Diagnostic]:
        for value, why in semantics.idle_states:
            state = value.element.parent
            name = "" if state is None else state.attributes.get("name", "").strip()
            joint = value.text.strip()
            yield self.diagnostic(value, f"state `{name}` has no effect on joint `{joint}`, which is {why}")
        for given, leader, place in semantics.unfollowed:
            joint, name = (each.attributes.get("name", "").strip() for each in (given.joint, given.state))
            message = f"joint `{joint}` follows `{leader}` to {place:.6g}, and is not at {given.value.text}"
            yield self.diagnostic(given.value, f"{message} in state `{name}`")

from collections.abc import Iterator

from sdfcheck import Bad, Diagnostic, Good, Rule, Semantics, Severity
from sdfcheck_rules.srd.scaffold import FILE, IN_SRDF, ROBOT

STATE = '<group_state name="home" group="{}"><joint name="{}" value="0"/></group_state>'
TOOL = '<group name="tool"><link name="hand"/></group>'


class IdleStateValue(Rule):
    """A state gives a value to a joint that is fixed, or that the group of the state does not have.

    MoveIt logs an error and leaves the value out: the joint stays where it is when the robot goes to that state.
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
    )
    good = (Good(STATE.format("all", "shoulder"), file=FILE, files=ROBOT),)

    @staticmethod
    def applies(semantics: Semantics) -> bool:
        return any(True for _ in semantics.idle_states)

    def check(self, semantics: Semantics) -> Iterator[Diagnostic]:
        for value, why in semantics.idle_states:
            state = value.element.parent
            name = "" if state is None else state.attributes.get("name", "").strip()
            joint = value.text.strip()
            yield self.diagnostic(value, f"state `{name}` has no effect on joint `{joint}`, which is {why}")

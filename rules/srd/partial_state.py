from collections.abc import Iterator

from sdfcheck import Bad, Diagnostic, Good, Rule, Semantics, Severity, named
from sdfcheck_rules.srd.scaffold import FILE, GRIPPER, IN_SRDF

FINGERS = '<group name="tool"><joint name="left"/><joint name="right"/></group>'
BOTH = '<group name="both"><group name="all"/><group name="tool"/></group>'


class PartialState(Rule):
    """A state gives no value to a joint that its group moves.

    MoveIt warns, and the joint stays where it is when the robot goes to that state: the same state is
    another pose each time. Joints with `mimic` follow their leader and need no value.
    """

    code = "SRD018"
    name = "partial-state"
    severity = Severity.WARNING
    remedy = "Give each joint of the group a value in the state, or name a smaller group."
    looks_at = (Semantics,)
    scaffold = IN_SRDF

    bad = (
        Bad(
            f'{FINGERS}{BOTH}<group_state name="«open»" group="both"><joint name="left" value="0.04"/></group_state>',
            file=FILE,
            files=GRIPPER,
            says="state `open` gives no value to joint `shoulder`, which group `both` moves",
        ),
    )
    good = (
        Good(
            f'{FINGERS}<group_state name="open" group="tool"><joint name="left" value="0.04"/></group_state>',
            file=FILE,
            files=GRIPPER,
            why="the other one follows",
        ),
    )

    @staticmethod
    def applies(semantics: Semantics) -> bool:
        return any(True for _ in semantics.partial_states)

    def check(self, semantics: Semantics) -> Iterator[Diagnostic]:
        for value, joints in semantics.partial_states:
            group = value.element.attributes["group"].strip()
            left = f"joint{'s' * (len(joints) > 1)} {named(joints, most=4)}"
            message = f"state `{value.text.strip()}` gives no value to {left}"
            yield self.diagnostic(value, f"{message}, which group `{group}` moves")

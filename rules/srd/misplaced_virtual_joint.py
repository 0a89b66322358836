from collections.abc import Iterator

from sdfcheck import Bad, Diagnostic, Good, Rule, Semantics, Severity, write_instead
from sdfcheck_rules.srd.scaffold import FILE, IN_SRDF, ROBOT

JOINT = '<virtual_joint name="v" type="fixed" parent_frame="map" child_link="{}"/>'


class MisplacedVirtualJoint(Rule):
    """A virtual joint hangs on a link that is not the root of the robot.

    A virtual joint ties the root to the world. MoveIt skips one with another child.
    """

    code = "SRD008"
    name = "misplaced-virtual-joint"
    severity = Severity.WARNING
    remedy = """Write the root link of the robot as `child_link`.

    To plan for an arm that stands on a mobile base, the virtual joint moves the base, not the arm.
    """
    looks_at = (Semantics,)
    scaffold = IN_SRDF

    bad = (
        Bad(
            JOINT.format("«upper»"),
            fixed=JOINT.format("base"),
            unsafe=True,
            file=FILE,
            files=ROBOT,
            says="a virtual joint is for the root link `base`, not for `upper`",
        ),
    )
    good = (Good(JOINT.format("base"), file=FILE, files=ROBOT),)

    @staticmethod
    def applies(semantics: Semantics) -> bool:
        return any(True for _ in semantics.misplaced_virtual_joints)

    def check(self, semantics: Semantics) -> Iterator[Diagnostic]:
        for value, root in semantics.misplaced_virtual_joints:
            message = f"a virtual joint is for the root link `{root.name}`, not for `{value.text.strip()}`"
            yield self.diagnostic(value, message, fix=write_instead(root.name, value))

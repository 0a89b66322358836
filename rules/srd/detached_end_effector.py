from collections.abc import Iterator

from sdfcheck import Bad, Diagnostic, Good, Rule, Semantics, Severity
from sdfcheck_rules.srd.scaffold import FILE, IN_SRDF, ROBOT

TOOL = '<group name="tool"><link name="hand"/></group>'
ARM = '<group name="arm"><chain base_link="base" tip_link="upper"/></group>'
EFFECTOR = '<end_effector name="e" group="{}" parent_link="{}" parent_group="{}"/>'


class DetachedEndEffector(Rule):
    """An end effector is carried by no group, or by one that does not have its parent link.

    A group has the links below its joints: a chain from `base` to `upper` has `upper` and not `base`. Without a group
    that carries it, MoveIt knows no end effector of the arm: it cannot pick with it, and RViz has no marker to drag.
    """

    code = "SRD009"
    name = "detached-end-effector"
    severity = Severity.WARNING
    remedy = """Name the last link of the arm as `parent_link`, and the group of the arm as `parent_group`.

    `group` is the group of the gripper, with its own links and joints. If the gripper hangs on a link that is fixed
    to the arm, let the chain of the arm end at that link.
    """
    looks_at = (Semantics,)
    scaffold = IN_SRDF

    bad = (
        Bad(
            TOOL + ARM + EFFECTOR.format("tool", "«base»", "arm"),
            file=FILE,
            files=ROBOT,
            says="nothing carries end effector `e`: group `arm` does not have link `base`",
        ),
        Bad(
            ARM + EFFECTOR.format("arm", "upper", "«arm»"),
            file=FILE,
            files=ROBOT,
            says="nothing carries end effector `e`: group `arm` cannot carry itself",
        ),
        Bad(
            TOOL + ARM + EFFECTOR.format("tool", "«hand»", "arm").replace(' parent_group="arm"', ""),
            file=FILE,
            files=ROBOT | {"kinematics.yaml": "arm: {}"},
            says="no other group has link `hand`",
        ),
    )
    good = (
        Good(TOOL + ARM + EFFECTOR.format("tool", "upper", "arm"), file=FILE, files=ROBOT),
        Good(
            TOOL + ARM + EFFECTOR.format("tool", "upper", "").replace(' parent_group=""', ""),
            why="MoveIt finds the group of the arm",
            file=FILE,
            files=ROBOT,
        ),
    )

    @staticmethod
    def applies(semantics: Semantics) -> bool:
        return any(True for _ in semantics.detached_end_effectors)

    def check(self, semantics: Semantics) -> Iterator[Diagnostic]:
        for value, why in semantics.detached_end_effectors:
            name = value.element.attributes.get("name", "").strip()
            yield self.diagnostic(value, f"nothing carries end effector `{name}`: {why}")

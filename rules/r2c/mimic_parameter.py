from collections.abc import Iterator

from sdfcheck import Bad, ControlComponent, Diagnostic, Good, Rule, Severity
from sdfcheck_rules.r2c.scaffold import IN_BLOCK


class MimicParameter(Rule):
    """A parameter says which joint a joint in `ros2_control` mimics.

    Up to iron, the mock hardware and Gazebo read `<param name="mimic">`. From jazzy on only the `mimic` of
    the joint itself counts, and the parameter is ignored in silence.
    """

    code = "R2C018"
    name = "mimic-parameter"
    severity = Severity.WARNING
    remedy = """Write `<mimic joint="…" multiplier="…"/>` in the joint itself, and remove the parameter.

    For a file that also has to serve Humble, keep both.
    """
    default = False
    looks_at = (ControlComponent,)
    scaffold = IN_BLOCK

    bad = (
        Bad(
            '<joint name="follower" mimic="false"/><joint name="lift"><«param» name="mimic">follower</param></joint>',
            says="parameter `mimic` of joint `lift` is ignored from jazzy on; write `<mimic>` in the joint itself",
        ),
    )
    good = (Good('<joint name="lift"><param name="gain">3</param></joint>'),)

    @staticmethod
    def applies(component: ControlComponent) -> bool:
        return component.what == "joint" and bool(component.mimic_parameters)

    def check(self, component: ControlComponent) -> Iterator[Diagnostic]:
        for element in component.mimic_parameters:
            message = f"parameter `mimic` of {component.title} is ignored from jazzy on"
            message += (
                "; the `<mimic>` of the joint counts"
                if component.mimic
                else "; write `<mimic>` in the joint itself"
            )
            yield self.diagnostic(element, message)

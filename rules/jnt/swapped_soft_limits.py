from collections.abc import Iterator

from sdfcheck import IN_URDF_JOINT, Bad, Diagnostic, Element, Good, Rule, Severity


class SwappedSoftLimits(Rule):
    """The lower soft limit of a safety controller is above the upper one.

    No position is between them, so that the controllers of ROS, which read them, hold the joint
    at a bound or stop it.
    """

    code = "JNT017"
    name = "swapped-soft-limits"
    severity = Severity.WARNING
    preview = True
    looks_at = (Element,)
    selects = ("urdf:joint/safety_controller",)
    scaffold = IN_URDF_JOINT.replace("{}", '<limit lower="-2" upper="2" effort="5" velocity="2"/>{}')

    bad = (
        Bad(
            '<safety_controller soft_lower_limit="«1.5»" soft_upper_limit="-1.5" k_velocity="10"/>',
            says="lower soft limit 1.5 is above upper soft limit -1.5",
        ),
    )
    good = (
        Good('<safety_controller soft_lower_limit="-1.5" soft_upper_limit="1.5" k_velocity="10"/>'),
        Good('<safety_controller k_velocity="10"/>', why="neither is written"),
    )

    @staticmethod
    def applies(controller: Element) -> bool:
        lower, upper = (controller.attribute(name) for name in ("soft_lower_limit", "soft_upper_limit"))
        return lower is not None and upper is not None and lower.number > upper.number

    def check(self, controller: Element) -> Iterator[Diagnostic]:
        lower, upper = (controller.attribute(name) for name in ("soft_lower_limit", "soft_upper_limit"))
        assert lower is not None
        assert upper is not None
        message = f"lower soft limit {lower.text} is above upper soft limit {upper.text}"
        yield self.diagnostic(lower, message, labels={upper: "the upper soft limit"})

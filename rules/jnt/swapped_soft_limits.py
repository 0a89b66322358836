from collections.abc import Iterator

from sdfcheck import IN_URDF_JOINT, Bad, Diagnostic, Element, Good, Rule, Severity, Value

SLACK = 1e-3
"""rad or m: rounded figures are no findings."""
FAR = 1.0


class SwappedSoftLimits(Rule):
    """The soft limits of a safety controller leave no position, or lie outside of the limits of the joint.

    With the lower one above or at the upper one, the controllers of ROS, which read them, hold the joint at a bound or
    stop it. One that lies outside of the joint's own limit never takes effect: the joint runs into its stop.
    """

    code = "JNT017"
    name = "swapped-soft-limits"
    severity = Severity.WARNING
    remedy = """Put the soft limits between the limits of the joint, the lower below the upper.

    A margin of 0.05 to 0.1 rad (or some millimeters) to each stop is usual. A joint with no need of them
    does without `safety_controller`.
    """
    looks_at = (Element,)
    selects = ("urdf:joint/safety_controller",)
    scaffold = IN_URDF_JOINT.replace("{}", '<limit lower="-2" upper="2" effort="5" velocity="2"/>{}')

    bad = (
        Bad(
            '<safety_controller soft_lower_limit="«1.5»" soft_upper_limit="-1.5" k_velocity="10"/>',
            says="lower soft limit 1.5 is above upper soft limit -1.5",
        ),
        Bad(
            '<safety_controller soft_lower_limit="«0»" soft_upper_limit="0" k_velocity="0"/>',
            says="both soft limits are 0, so that the joint cannot move",
        ),
        Bad(
            '<safety_controller soft_lower_limit="-1.5" soft_upper_limit="«2.5»" k_velocity="10"/>',
            says="upper soft limit 2.5 is outside of the limit 2",
        ),
    )
    good = (
        Good('<safety_controller soft_lower_limit="-1.5" soft_upper_limit="1.5" k_velocity="10"/>'),
        Good('<safety_controller k_velocity="10"/>', why="neither is written"),
        Good(
            '<safety_controller soft_lower_limit="-2" soft_upper_limit="2" k_velocity="10"/>',
            why="as the joint's own",
        ),
    )

    @staticmethod
    def applies(controller: Element) -> bool:
        return next(faults(controller), None) is not None

    def check(self, controller: Element) -> Iterator[Diagnostic]:
        for value, other, message in faults(controller):
            yield self.diagnostic(value, message, labels={other: "the other limit"})


def faults(controller: Element) -> Iterator[tuple[Value, Value, str]]:
    """The soft limits that are swapped or outside, with the limit that they are compared with, and the words."""
    lower, upper = (controller.attribute(name) for name in ("soft_lower_limit", "soft_upper_limit"))
    if lower is not None and upper is not None and lower.number > upper.number:
        yield lower, upper, f"lower soft limit {lower.text} is above upper soft limit {upper.text}"
        return
    joint = controller.parent
    if lower is not None and upper is not None and lower.number == upper.number:
        yield lower, upper, f"both soft limits are {lower.text}, so that the joint cannot move"
        return
    limit = (
        joint.find("limit") if joint is not None and joint.get("type") in {"revolute", "prismatic"} else None
    )
    if limit is None:
        return
    outside: list[tuple[Value, Value, str, float]] = []
    for soft, name, sign in ((lower, "lower", -1), (upper, "upper", 1)):
        hard = limit.attribute(name)
        excess = sign * (soft.number - hard.number) if soft is not None and hard is not None else 0.0
        if soft is not None and hard is not None and excess > SLACK:
            message = f"{name} soft limit {soft.text} is outside of the limit {hard.text}"
            outside.append((soft, hard, message, excess))
    # Far outside on both sides they are switched off on purpose.
    if len(outside) < 2 or min(excess for *_, excess in outside) < FAR:
        yield from (found[:3] for found in outside)

from collections.abc import Iterator
from math import isfinite

from sdfcheck import Bad, Diagnostic, Good, Joint, Model, Rule, Severity, Value

FAR, TIMES = 0.2, 5.0
"""rad, and of what the soft limits of all other joints leave out."""
LEAST = 4
"""Joints with soft limits, of which one may differ."""
JOINT = (
    '<link name="l{0}"/><joint name="j{0}" type="revolute"><parent link="base"/><child link="l{0}"/>'
    '<axis xyz="0 0 1"/><limit lower="-{1}" upper="{1}" effort="9" velocity="1"/>'
    '<safety_controller soft_lower_limit="{3}-{2}{4}" soft_upper_limit="{2}" k_velocity="2"/></joint>'
)


def arm(*softs: str, mark: int = -1) -> str:
    """Joints of ±3 rad with these soft limits, one of which is marked."""
    marks = [("«", "»") if number == mark else ("", "") for number in range(len(softs))]
    joints = (JOINT.format(n, 3, soft, *marks[n]) for n, soft in enumerate(softs))
    return f'<robot name="r"><link name="base"/>{"".join(joints)}</robot>'


class DistantSoftLimits(Rule):
    """The soft limits keep one joint far from its ends, and all other joints close to theirs.

    They are usually a degree or two within the limits of each joint, by one rule for the whole robot: those that leave
    out far more at both ends were copied from another joint. Controllers that read them do not let the joint go
    farther. Of 135 public robots with soft limits none has such a joint.
    """

    code = "JNT037"
    name = "distant-soft-limits"
    severity = Severity.WARNING
    remedy = """Give the joint the margin of the others: its own `lower` plus, its `upper` minus, the same.

    If the joint is to stay that far from its ends, ignore this here.
    """
    looks_at = (Model,)
    selects = ("urdf:robot",)
    needs = ("safety_controller",)
    scaffold = "{}"

    bad = (
        Bad(
            arm("2.97", "2.97", "2.1", "2.97", mark=2),
            says="the soft limits of joint `j2` leave out 0.9 rad at each end, and those of the other 3 joints 0.03",
        ),
    )
    good = (
        Good(arm("2.97", "2.97", "2.95", "2.97")),
        Good(arm("2.5", "2.4", "2", "2.5"), why="all leave out much"),
        Good(arm("2.97", "2.1", "2.97"), why="too few joints to compare with"),
    )

    @staticmethod
    def applies(model: Model) -> bool:
        return odd(model) is not None

    def check(self, model: Model) -> Iterator[Diagnostic]:
        found = odd(model)
        assert found is not None
        joint, value, margin, usual, count = found
        message = f"the soft limits of {joint.title} leave out {margin:.2g} rad at each end"
        message += f", and those of the other {count} joints {usual:.2g} rad or less"
        yield self.diagnostic(value, message, labels={joint.axis.limit: "its limits"})


def odd(model: Model) -> tuple[Joint, Value, float, float, int] | None:
    """The joint with soft limits far within its limits, the lower one, both distances (rad), and how many others."""
    rows: list[tuple[float, float, Joint, Value]] = []
    for joint in model.joints:
        controller = joint.find("safety_controller") if joint.type == "revolute" else None
        if controller is None:
            continue
        lower, upper = (controller.attribute(f"soft_{end}_limit") for end in ("lower", "upper"))
        low, high = joint.axis.limit.range
        if lower is None or upper is None or low >= high:
            continue
        left, right = lower.number - low, high - upper.number
        if isfinite(left) and isfinite(right):
            rows.append((min(left, right), max(left, right), joint, lower))
    if len(rows) < LEAST:
        return None
    rows.sort(key=lambda row: row[0])
    *others, (margin, _, joint, value) = rows
    usual = max(row[1] for row in others)
    is_odd = margin > max(FAR, TIMES * usual)
    return (joint, value, margin, usual, len(others)) if is_odd else None

from collections.abc import Iterator
from itertools import combinations

from sdfcheck import Bad, Diagnostic, Good, Joint, Link, Plugin, Rule, Severity, Value
from sdfcheck_rules.gaz.slippery_wheel import IN_URDF, coefficients

MU = '<gazebo reference="{}"><mu1>{}</mu1><mu2>{}</mu2></gazebo>'


class UnevenFriction(Rule):
    """Two wheels of a drive that are counterparts have different friction.

    The side with more friction pulls the robot around: it does not go straight, and does not turn in place.
    """

    code = "GAZ026"
    name = "uneven-friction"
    severity = Severity.WARNING
    remedy = """Write the same coefficients for the left and the right wheel.

    With a property of xacro for both, or with a macro for the wheels, they stay the same.
    """
    looks_at = (Plugin,)
    scaffold = IN_URDF

    bad = (
        Bad(
            MU.format("left", 1, 1) + MU.format("right", "«0.2»", 1),
            says="link `right` has a friction of 0.2 where link `left` has one of 1",
        ),
    )
    good = (
        Good(MU.format("left", 1, 0.5) + MU.format("right", "1.0", 0.5)),
        Good(MU.format("left", 1, 1), why="the other has the default, which is 1"),
        Good(MU.format("left", 1, 0) + MU.format("right", 0, 1), why="rollers"),
    )

    @staticmethod
    def applies(plugin: Plugin) -> bool:
        return "drive" in plugin.filename.lower() and any(True for _ in uneven(plugin))

    def check(self, plugin: Plugin) -> Iterator[Diagnostic]:
        for link, value, other, its in uneven(plugin):
            message = (
                f"{link.title} has a friction of {value.text.strip()} where {other.title} has one of"
                f" {its.text.strip()}"
            )
            yield self.diagnostic(value, message, labels={its: "the other wheel", plugin: "this drive"})


def uneven(plugin: Plugin) -> Iterator[tuple[Link, Value, Link, Value]]:
    """The first coefficient of a wheel that is another than that of its counterpart, and that one."""
    joints: dict[Joint, None] = dict.fromkeys(
        reference.joint for reference in plugin.references if reference.joint is not None
    )
    for one, other in combinations(joints, 2):
        first, second = one.child_link, other.child_link
        if one.mirror is not other or first is None or second is None:
            continue
        pairs = zip(coefficients(first), coefficients(second), strict=False)
        for its, value in pairs:
            if its.number != value.number and its.number and value.number:  # Without any it is a roller.
                yield second, value, first, its
                break

from collections.abc import Iterator

from sdfcheck import IN_JOINT, IN_URDF_JOINT, Axis, Bad, Diagnostic, Good, Rule, Severity
from sdfcheck_rules.jnt.directions import has_no_length, is_used


class ZeroAxis(Rule):
    """The axis of a joint has no length, so it points nowhere.

    libsdformat and Drake refuse the file; in other consumers the joint's motion divides by zero.
    """

    code = "JNT006"
    name = "zero-axis"
    severity = Severity.ERROR
    remedy = """Write a direction of length 1, such as `0 0 1`, in the frame of the joint.

    A positive position turns about it by the rule of the right hand, or slides along it. If the joint is
    not to move, make its type `fixed` and leave the axis out.
    """
    looks_at = (Axis,)
    scaffold = IN_JOINT

    bad = (
        Bad("<axis><xyz>«0 0 0»</xyz></axis>", says="the axis of joint `j` has no length"),
        Bad(
            '<axis xyz="«0 0 0»"/><limit lower="-1" upper="1" effort="5" velocity="2"/>',
            scaffold=IN_URDF_JOINT,
            says="the axis of joint `j` has no length",
        ),
    )
    good = (
        Good("<axis><xyz>0 0 1</xyz></axis>"),
        Good("<axis><xyz>0 0 0.001</xyz></axis>", why="it has a direction"),
        Good(
            '<axis xyz="0 0 1"/><limit lower="-1" upper="1" effort="5" velocity="2"/>', scaffold=IN_URDF_JOINT
        ),
    )

    @staticmethod
    def applies(axis: Axis) -> bool:
        return has_no_length(axis) and is_used(axis)

    def check(self, axis: Axis) -> Iterator[Diagnostic]:
        yield self.diagnostic(axis.xyz, f"the axis of {axis.joint.title} has no length")

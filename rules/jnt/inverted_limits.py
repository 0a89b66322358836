from collections.abc import Iterator

from sdfcheck import (
    IN_JOINT,
    IN_URDF_JOINT,
    REFUSES,
    Bad,
    Consumer,
    Diagnostic,
    Edit,
    Good,
    Rule,
    Severity,
    edit,
    problems,
    warns,
)


class InvertedLimits(Rule):
    """A joint whose lower limit is above its upper limit has no position to be in.

    Drake refuses the file. libsdformat says nothing about SDFormat, and exchanges the two in URDF.
    urdfdom never compares them, so the mistake surfaces when something tries to move the joint.
    """

    code = "JNT005"
    name = "inverted-limits"
    severity = Severity.ERROR
    affects = {
        Consumer.GAZEBO: {"sdf": warns("takes them as they are"), "urdf": warns("exchanges them")},
        Consumer.DRAKE: REFUSES,
        Consumer.URDFDOM: warns("takes them as they are"),
        Consumer.MUJOCO: warns("drops the limits"),
    }
    explains = (problems.InvertedLimits,)
    scaffold = IN_JOINT

    bad = (
        Bad(
            "<axis><xyz>0 0 1</xyz><limit><lower>«1.57»</lower><upper>-1.57</upper></limit></axis>",
            fixed="<axis><xyz>0 0 1</xyz><limit><lower>-1.57</lower><upper>1.57</upper></limit></axis>",
            unsafe=True,
            says="lower limit 1.57 is above upper limit -1.57",
        ),
        Bad(
            '<limit lower="«1.57»" upper="-1.57" effort="5" velocity="2"/>',
            fixed='<limit lower="-1.57" upper="1.57" effort="5" velocity="2"/>',
            unsafe=True,
            scaffold=IN_URDF_JOINT,
            says="lower limit 1.57 is above upper limit -1.57",
        ),
    )
    good = (
        Good(
            "<axis><xyz>0 0 1</xyz><limit><lower>0</lower><upper>0</upper></limit></axis>",
            why="locked on purpose",
        ),
        Good('<limit lower="-1" upper="1" effort="5" velocity="2"/>', scaffold=IN_URDF_JOINT),
    )

    def check(self, problem: problems.InvertedLimits) -> Iterator[Diagnostic]:
        lower, upper = problem.lower, problem.upper
        low, high = lower.text.strip(), upper.text.strip()
        fix = edit("exchange them", (Edit(lower.span, high), Edit(upper.span, low)), unsafe=True)
        message = f"lower limit {low} is above upper limit {high}"
        yield self.diagnostic(lower, message, labels={upper: "the upper limit"}, fix=fix)

from collections.abc import Iterator

from sdfcheck import (
    IN_JOINT,
    IN_URDF_JOINT,
    Bad,
    Consumer,
    Diagnostic,
    Good,
    Rule,
    Severity,
    problems,
    refuses,
    warns,
)


class NegativeLimit(Rule):
    """An effort, velocity, damping or friction of a joint is negative.

    In SDFormat any negative effort or velocity is read as no limit, which is written `-1`.
    Everywhere else a negative number makes no sense: negative damping feeds the
    motion, and Drake refuses it.
    """

    code = "JNT010"
    name = "negative-limit"
    severity = Severity.WARNING
    affects = {
        Consumer.GAZEBO: warns("takes it as no limit, or as it is"),
        Consumer.DRAKE: refuses("refuses negative damping"),
        Consumer.URDFDOM: warns("takes it as it is"),
        Consumer.MUJOCO: warns("takes it as it is"),
    }
    explains = (problems.NegativeLimit,)
    scaffold = IN_JOINT

    bad = (
        Bad(
            "<axis><xyz>0 0 1</xyz><dynamics><damping>«-0.1»</damping></dynamics></axis>",
            says="damping -0.1 of joint `j` is negative",
        ),
        Bad(
            "<axis><xyz>0 0 1</xyz><limit><effort>«-30»</effort></limit></axis>",
            says="effort -30 of joint `j` is negative",
        ),
        Bad(
            '<limit lower="-1" upper="1" effort="5" velocity="«-2»"/>',
            scaffold=IN_URDF_JOINT,
            says="velocity -2 of joint `j` is negative",
        ),
    )
    good = (
        Good(
            "<axis><xyz>0 0 1</xyz><limit><effort>-1</effort><velocity>-1</velocity></limit></axis>",
            why="the format's way to say no limit",
        ),
        Good("<axis><xyz>0 0 1</xyz><limit><lower>-2</lower><upper>-1</upper></limit></axis>"),
    )

    def check(self, problem: problems.NegativeLimit) -> Iterator[Diagnostic]:
        value = problem.value
        message = f"{problem.quantity} {value.text.strip()} of {problem.joint.title} is negative"
        affects = {}
        if problem.quantity == "velocity" and value.attribute is not None:
            affects = {Consumer.DRAKE: refuses("aborts")}
        elif problem.quantity != "damping":
            affects = {Consumer.DRAKE: warns("takes it as no limit")}
        yield self.diagnostic(value, message, affects=affects)

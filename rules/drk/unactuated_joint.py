from collections.abc import Iterator

from sdfcheck import Bad, Consumer, Diagnostic, Good, Rule, Severity, problems, warns
from sdfcheck_rules.drk.effect import affects, consequence
from sdfcheck_rules.drk.scaffolds import AXIS, JOINT, ROBOT

DRIVE = '<transmission><type>{}</type><joint name="j"/><actuator name="m"/></transmission>'


NO_ACTUATOR = {Consumer.DRAKE: warns("makes no actuator")}


class UnactuatedJoint(Rule):
    """Drake makes no actuator for a joint.

    In URDF an actuator exists only through a transmission whose type contains `SimpleTransmission`, for
    a moving joint with an effort limit that is not 0. In SDF every joint with one axis is
    actuated unless its effort limit is 0; what is said about the rotor is then not read.
    """

    code = "DRK010"
    name = "unactuated-joint"
    severity = Severity.ERROR
    default = False
    affects = {Consumer.DRAKE: warns("makes no actuator, or refuses the file")}
    explains = (problems.UnactuatedJoint,)
    scaffold = ROBOT

    bad = (
        Bad(
            DRIVE.format("«transmission_interface/FourBarLinkageTransmission»"),
            says="`j` has no actuator in Drake: its transmission is no SimpleTransmission",
        ),
        Bad(
            '<transmission><type>SimpleTransmission</type><joint name="j"/><«actuator»/></transmission>',
            says="the actuator has no name: Drake refuses the file",
        ),
        Bad(
            '<transmission><type>SimpleTransmission</type><joint name="«f»"/><actuator name="m"/>'
            "</transmission>",
            says="`f` has no actuator in Drake: it is fixed",
        ),
        Bad(
            "",
            says="no transmission names it",
            scaffold=ROBOT.replace('<joint name="j"', '<«joint» name="j"'),
        ),
        Bad(
            "<limit><effort>«0»</effort></limit>",
            says="`j` has no actuator in Drake: its effort is 0",
            scaffold=AXIS,
        ),
        Bad(
            "<«drake:rotor_inertia»>1</drake:rotor_inertia>",
            says="so `drake:rotor_inertia` is not read",
            scaffold=JOINT.replace("revolute", "fixed").replace("<axis><xyz>0 0 1</xyz></axis>", ""),
        ),
    )
    good = (
        Good(DRIVE.format("transmission_interface/SimpleTransmission")),
        Good("<limit><effort>-1</effort></limit>", scaffold=AXIS, why="without limit"),
    )

    def check(self, problem: problems.UnactuatedJoint) -> Iterator[Diagnostic]:
        idle = problem.idle
        if problem.effect.refused:
            who = f"joint `{problem.joint}`: " if problem.joint else ""
            message = f"{who}{problem.reason}: {consequence(problem.effect)}"
            yield self.diagnostic(problem.target, message, affects=affects(problem.effect))
            return
        more = f" (and {problem.others} more)" if problem.others else ""
        who = f"`{problem.joint}`{more} has" if problem.joint else "this makes"
        message = f"{who} no actuator in Drake: {problem.reason}"
        if idle is not None:
            message += f", so `{idle.name}` is not read"
        deliberate = idle is None and problem.reason in {"no transmission names it", "its effort is 0"}
        level = Severity.INFO if deliberate else Severity.WARNING
        yield self.diagnostic(problem.target, message, severity=level, affects=NO_ACTUATOR)

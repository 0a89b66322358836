from collections.abc import Iterator

from sdfcheck import IN_MODEL, REFUSES, Bad, Consumer, Diagnostic, Good, Joint, Mimic, Number, Rule, Severity

ENDS = '<link name="a"/><link name="b"/><joint name="j" type="{}"><parent>a</parent><child>b</child>'
AXIS = "<axis><xyz>0 0 1</xyz></axis>"
SCREW = f"{ENDS.format('screw')}{AXIS}<screw_thread_pitch>{{}}</screw_thread_pitch></joint>"
GEARBOX = (
    f"{ENDS.format('gearbox')}{AXIS}<axis2><xyz>0 0 1</xyz></axis2><gearbox_ratio>{{}}</gearbox_ratio>"
    "<gearbox_reference_body>base</gearbox_reference_body></joint>"
)
FOLLOWER = (
    '<robot name="r"><link name="a"/><link name="b"/><link name="c"/><joint name="j" type="continuous">'
    '<parent link="a"/><child link="b"/><axis xyz="0 1 0"/></joint><joint name="k" type="continuous">'
    '<parent link="a"/><child link="c"/><axis xyz="0 1 0"/><mimic joint="j" multiplier="{}"/></joint></robot>'
)


class ZeroRatio(Rule):
    """The ratio of a gearbox, the pitch of a screw or the multiplier of a mimic joint is zero.

    A gearbox of ratio 0 turns one side and holds the other, a screw of pitch 0 turns in its place, and a joint that
    mimics another with a multiplier of 0 stays where it is: none does what it is for. The default of all is 1.
    """

    code = "JNT019"
    name = "zero-ratio"
    severity = Severity.WARNING
    remedy = """Write the ratio or the pitch of the mechanism: not 0.

    `gearbox_ratio` is the speed of one side by that of the other. `screw_thread_pitch` is the travel in
    meters per turn (SDFormat 1.10 on); the old `thread_pitch` is in radians per meter with the opposite
    sign. For a joint without coupling choose another type.
    """
    looks_at = (Joint, Mimic)
    scaffold = IN_MODEL

    bad = (
        Bad(
            SCREW.format("«0»"), says="`screw_thread_pitch` of joint `j` is 0, so that turning moves nothing"
        ),
        Bad(GEARBOX.format("«0.0»"), says="`gearbox_ratio` of joint `j` is 0", also=("DRK008",)),
        Bad(
            FOLLOWER.format("«0»"),
            scaffold="{}",
            says="`multiplier` of joint `k` is 0, so that it does not follow `j`",
        ),
    )
    good = (
        Good(SCREW.format("-0.01"), why="a left-handed screw"),
        Good(GEARBOX.format("-1"), why="turns the other way round"),
    )

    @staticmethod
    def applies(part: Joint | Mimic) -> bool:
        if isinstance(part, Mimic):
            return part.multiplier.is_given and part.multiplier.number == 0
        return part.type in {"gearbox", "screw"} and bool(zeros(part))

    def check(self, part: Joint | Mimic) -> Iterator[Diagnostic]:
        if isinstance(part, Mimic):
            message = (
                f"`multiplier` of {part.joint.title} is 0, so that it does not follow `{part.leader_name}`"
            )
            yield self.diagnostic(part.multiplier, message)
            return
        affects = {Consumer.DRAKE: REFUSES} if part.type == "gearbox" else {}
        for name, number in zeros(part).items():
            message = f"`{name}` of {part.title} is 0, so that turning moves nothing"
            yield self.diagnostic(number, message, affects=affects)


def zeros(joint: Joint) -> dict[str, Number]:
    """The factors of the coupling that are 0."""
    if joint.type == "gearbox":
        found = {"gearbox_ratio": joint.gearbox_ratio}
    else:
        found = {"screw_thread_pitch": joint.screw_thread_pitch, "thread_pitch": joint.thread_pitch}
    return {name: number for name, number in found.items() if number.is_given and number.number == 0}

from collections.abc import Iterator

from sdfcheck import IN_URDF_LINK, Bad, Consumer, Diagnostic, Good, Rule, Severity, problems, warns

VISUAL = '<visual><origin rpy="{}"/><geometry><sphere radius="1"/></geometry></visual>'


class SingularPitch(Rule):
    """The pitch of a shape is so near to 90° that urdfdom takes it for 90°.

    Where the sine of the pitch is beyond 0.99999, its conversion back to angles gives
    exactly a right angle. libsdformat writes the poses of visuals and collisions with it,
    so they turn by up to 4.5 milliradians; other readers take the angle as written.
    """

    code = "URD016"
    name = "singular-pitch"
    severity = Severity.INFO
    affects = {Consumer.GAZEBO: warns("turns the shape to 90°")}
    explains = (problems.SingularPitch,)
    scaffold = IN_URDF_LINK

    bad = (
        Bad(VISUAL.replace("{}", "0 «1.57» 0"), says="pitch 1.57 is taken for 90°, which is off by 0.8 mrad"),
        Bad(VISUAL.replace("{}", "0.3 «-1.573» 0.5"), says="off by 2.2 mrad"),
    )
    good = (
        Good(VISUAL.replace("{}", "0 1.5708 0"), why="off by less than anybody sees"),
        Good(VISUAL.replace("{}", "0 1.56 0"), why="far enough away"),
        Good(VISUAL.replace("{}", "1.57 0 1.57"), why="only the pitch is singular"),
    )

    def check(self, problem: problems.SingularPitch) -> Iterator[Diagnostic]:
        pitch = problem.value.part(1)
        message = f"pitch {pitch.text} is taken for 90°, which is off by {problem.error * 1000:.1f} mrad"
        yield self.diagnostic(pitch, message)

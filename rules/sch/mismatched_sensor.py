from collections.abc import Iterator

from sdfcheck import IN_LINK, Bad, Consumer, Diagnostic, Good, Rule, Severity, problems, warns

SCAN = (
    "<scan><horizontal><samples>9</samples><min_angle>-1</min_angle><max_angle>1</max_angle></horizontal></scan>"
    "<range><min>0.1</min><max>9</max></range>"
)


class MismatchedSensor(Rule):
    """The type of a sensor and the element that configures it do not go together.

    Each type reads one element: a camera `<camera>`, an IMU `<imu>`. Settings of another
    type are ignored, and a camera or lidar without settings runs on the defaults.
    """

    code = "SCH018"
    name = "mismatched-sensor"
    severity = Severity.WARNING
    affects = {Consumer.GAZEBO: warns("takes defaults")}
    explains = (problems.MismatchedSensor,)
    scaffold = IN_LINK

    bad = (
        Bad(
            '<sensor name="s" type="imu"><«camera»/></sensor>',
            says="sensor `s` of type `imu` does not read `camera`, but `imu`",
        ),
        Bad(
            '<sensor name="s" type="«camera»"><update_rate>30</update_rate></sensor>',
            says="sensor `s` of type `camera` has no `camera`, so it runs on defaults",
        ),
    )
    good = (
        Good('<sensor name="s" type="imu"/>', why="an IMU without settings is ideal"),
        Good(
            f'<sensor name="s" type="gpu_lidar"><ray>{SCAN}</ray></sensor>',
            why="the older name is read too",
        ),
        Good(
            '<sensor name="s" type="custom"><camera/></sensor>', why="nobody knows what a custom sensor reads"
        ),
    )

    def check(self, problem: problems.MismatchedSensor) -> Iterator[Diagnostic]:
        kind, wrong, expected = problem.type, problem.wrong, problem.expected
        subject = f"{kind.element.title} of type `{kind.text.strip()}`"
        if wrong is None:
            yield self.diagnostic(kind, f"{subject} has no `{expected}`, so it runs on defaults")
            return
        message = f"{subject} does not read `{wrong.name}`, but `{expected}`"
        yield self.diagnostic(wrong, message, labels={kind: "the type"})

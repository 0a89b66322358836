from collections.abc import Iterator

from sdfcheck import IN_URDF_JOINT, Bad, Consumer, Diagnostic, Good, Rule, Severity, problems, warns

LIMIT = '<limit lower="0" upper="1" effort="1" velocity="1"/></joint>'
CONTROL = (
    '<ros2_control name="arm" type="system">'
    "<hardware><plugin>mock_components/GenericSystem</plugin></hardware>"
    '<joint name="{}"><command_interface name="position"/></joint></ros2_control>'
)


class UnknownControlJoint(Rule):
    """`ros2_control` names a joint that the robot does not have.

    The controller manager takes the joint for one of its own: it has no limits, the state
    publisher knows no transform for it, and the joint that was meant does not move.
    """

    code = "URD012"
    name = "unknown-control-joint"
    severity = Severity.ERROR
    affects = {Consumer.GAZEBO: warns("does not drive the joint")}
    explains = (problems.UnknownControlJoint,)
    scaffold = IN_URDF_JOINT.replace("{}</joint>", f"{LIMIT}{{}}").replace('name="j"', 'name="shoulder"')

    bad = (
        Bad(
            CONTROL.replace("{}", "«shoulder_joint»"),
            says="ros2_control `arm` is for joint `shoulder_joint`, which does not exist",
        ),
    )
    good = (
        Good(CONTROL.replace("{}", "shoulder")),
        Good(
            '<ros2_control name="s" type="sensor"><sensor name="imu"/><gpio name="io"/></ros2_control>',
            why="sensors and other signals are no joints",
        ),
    )

    def check(self, problem: problems.UnknownControlJoint) -> Iterator[Diagnostic]:
        value = problem.value
        message = f"{problem.control.title} is for joint `{value.text}`, which does not exist"
        if problem.suggestion is not None:
            message += f"; did you mean `{problem.suggestion}`?"
        yield self.diagnostic(value, message)

from collections.abc import Iterator

from sdfcheck import IN_URDF_JOINT, Bad, Diagnostic, Good, Ros2Control, Rule, Severity

LIMIT = '<limit lower="0" upper="1" effort="1" velocity="1"/></joint>'
CONTROL = (
    '<ros2_control name="arm" type="system">'
    "<hardware><plugin>mock_components/GenericSystem</plugin></hardware>"
    '<joint name="{}"><command_interface name="position"/></joint></ros2_control>'
)


class UnknownControlJoint(Rule):
    """`ros2_control` names a joint that the robot does not have.

    From jazzy on, ros2_control refuses the whole description. Earlier releases take the joint
    for one of the hardware's own: it has no limits, the state publisher knows no transform for it,
    and the joint that was meant does not move. Gazebo leaves it out with a warning.
    """

    code = "URD012"
    name = "unknown-control-joint"
    severity = Severity.ERROR
    remedy = """Name a joint of the robot, with its prefix.

    Signals of the hardware that are not joints, such as relays, belong in a `<gpio>`. Where the joint was
    removed, remove it from the block.
    """
    looks_at = (Ros2Control,)
    selects = ("urdf:robot/ros2_control",)
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

    @staticmethod
    def applies(control: Ros2Control) -> bool:
        return bool(control.unresolved)

    def check(self, control: Ros2Control) -> Iterator[Diagnostic]:
        for value in control.unresolved:
            message = f"{control.title} is for joint `{value.text}`, which does not exist"
            near = control.nearest(value.text, control.model.driven)
            yield self.diagnostic(value, message, meant=near, cause=control.model.fault_of(value.text))

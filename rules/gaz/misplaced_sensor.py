from collections.abc import Iterator

from sdfcheck import IN_MODEL, Bad, Diagnostic, Good, Joint, Link, Rule, Sensor, Severity

KIND = "force_torque"
ON_JOINT = (
    '<link name="b"/><joint name="j" type="fixed"><parent>base</parent><child>b</child>'
    '<sensor name="s" type="{}"/></joint>'
)


class MisplacedSensor(Rule):
    """A sensor of type `force_torque` is on a link, or one of another type on a joint.

    A `force_torque` sensor measures a joint: on a link, Gazebo logs that its parent has to be a joint, and does not
    make it. All others measure at a link: on a joint, Gazebo makes no camera or lidar, and an IMU does not move with
    the robot.
    """

    code = "GAZ035"
    name = "misplaced-sensor"
    severity = Severity.WARNING
    remedy = """Move a `force_torque` sensor into the joint whose force it is to measure, and others into a link.

    In URDF that is `<gazebo reference="NAME">`, about the joint or link. A fixed joint is merged away unless
    `<preserveFixedJoint>true</preserveFixedJoint>` is in a block about it. For the forces of contacts at a link take a
    sensor of type `contact`.
    """
    looks_at = (Sensor,)
    scaffold = IN_MODEL
    sources = (
        "https://github.com/gazebosim/gz-sim/blob/main/src/systems/force_torque/ForceTorque.cc",
        "https://github.com/gazebosim/gz-sim/blob/main/src/rendering/RenderUtil.cc",
    )

    bad = (
        Bad(
            '<link name="b"><sensor name="s" type="«force_torque»"/></link>',
            says="sensor `s` is on link `b`, and a `force_torque` sensor measures a joint",
        ),
        Bad(
            '<gazebo reference="base"><sensor name="s" type="«force_torque»"/></gazebo>',
            scaffold='<robot name="r"><link name="base"/>{}</robot>',
        ),
        Bad(
            ON_JOINT.format("«imu»"),
            says="sensor `s` is on joint `j`, and a sensor of type `imu` measures at a link",
        ),
    )
    good = (
        Good(ON_JOINT.format(KIND)),
        Good(ON_JOINT.format("custom"), why="a plugin measures what it likes"),
        Good('<link name="b"><sensor name="s" type="contact"/></link>'),
    )

    @staticmethod
    def applies(sensor: Sensor) -> bool:
        return (
            isinstance(sensor.owner, Link if sensor.type == "force_torque" else Joint)
            and sensor.type != "custom"
        )

    def check(self, sensor: Sensor) -> Iterator[Diagnostic]:
        assert sensor.owner is not None
        measures = "a `force_torque` sensor measures a joint"
        if sensor.type != KIND:
            measures = f"a sensor of type `{sensor.type}` measures at a link"
        yield self.diagnostic(
            sensor.type_value or sensor, f"{sensor.title} is on {sensor.owner.title}, and {measures}"
        )

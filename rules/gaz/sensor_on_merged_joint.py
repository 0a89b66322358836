from collections.abc import Iterator

from sdfcheck import Bad, Consumer, Diagnostic, GazeboBlock, Good, Rule, Severity

SENSOR = '<sensor name="ft" type="force_torque"/>'
MASS = '<inertial><mass value="1"/><inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial>'
ROBOT = (
    f'<robot name="r"><link name="a">{MASS}</link><link name="b">{MASS}</link>'
    '<joint name="j" type="fixed"><parent link="a"/><child link="b"/></joint>{}</robot>'
)


class SensorOnMergedJoint(Rule):
    """A sensor is on a fixed joint, which libsdformat merges away together with the sensor.

    When it converts URDF, libsdformat merges the links that fixed joints tie together. The
    content of a `gazebo` block for the child link moves to the link that is left; that of a
    block for the joint is lost in silence, and the sensor never publishes.
    """

    code = "GAZ011"
    name = "sensor-on-merged-joint"
    severity = Severity.ERROR
    remedy = """Keep the joint: `<preserveFixedJoint>true</preserveFixedJoint>` in its `gazebo` block.

    Force and torque sensors need it. Cameras, lidars and IMUs belong in a block for the child link:
    libsdformat moves them along when it merges it.
    """
    looks_at = (GazeboBlock,)
    scaffold = ROBOT

    bad = (
        Bad(
            f'<gazebo reference="j">{SENSOR.replace("sensor", "«sensor»", 1)}</gazebo>',
            says="sensor `ft` is lost: joint `j` is fixed, and libsdformat merges it away",
        ),
        Bad(
            '<gazebo reference="j"><preserveFixedJoint>false</preserveFixedJoint>'
            f"{SENSOR.replace('sensor', '«sensor»', 1)}</gazebo>",
        ),
    )
    good = (
        Good(f'<gazebo reference="j"><preserveFixedJoint>true</preserveFixedJoint>{SENSOR}</gazebo>'),
        Good(
            f'<gazebo reference="j">{SENSOR}</gazebo>'
            '<gazebo reference="j"><preserveFixedJoint>1</preserveFixedJoint></gazebo>',
            why="another block keeps the joint",
        ),
        Good(f'<gazebo reference="b">{SENSOR}</gazebo>', why="on a link it moves to the link that is left"),
        Good(
            f'<gazebo reference="j">{SENSOR}</gazebo>',
            scaffold=ROBOT.replace('"fixed"', '"continuous"'),
            why="the joint moves",
        ),
    )

    @staticmethod
    def applies(block: GazeboBlock) -> bool:
        return bool(block.sensors) and block in block.model.as_built_by(Consumer.GAZEBO).lost

    def check(self, block: GazeboBlock) -> Iterator[Diagnostic]:
        joint = block.model.as_built_by(Consumer.GAZEBO).lost[block]
        for sensor in block.sensors:
            yield self.diagnostic(
                sensor,
                f"{sensor.title} is lost: {joint.title} is fixed, and libsdformat merges it away",
                labels={joint.type_value or joint: "merged away"},
            )

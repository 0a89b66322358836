from collections.abc import Iterator

from sdfcheck import IN_MODEL, Bad, Diagnostic, Good, Link, Rule, Sensor, Severity

KIND = "force_torque"
JOINT = (
    '<link name="b"/><joint name="j" type="fixed"><parent>base</parent><child>b</child>'
    '<sensor name="s" type="force_torque"/></joint>'
)


class ForceTorqueOnLink(Rule):
    """A sensor of type `force_torque` is on a link, and measures joints.

    Gazebo logs that its parent has to be a joint, and does not make it: nothing is published on its topic.
    """

    code = "GAZ035"
    name = "force-torque-on-link"
    severity = Severity.WARNING
    remedy = """Move the sensor into the joint whose force it is to measure.

    In URDF that is `<gazebo reference="JOINT">`, about a joint that stays: a fixed one is merged away unless
    `<preserveFixedJoint>true</preserveFixedJoint>` is in a block about it. For the forces of contacts at a link take a
    sensor of type `contact`.
    """
    looks_at = (Sensor,)
    needs = (KIND,)
    scaffold = IN_MODEL
    sources = ("https://github.com/gazebosim/gz-sim/blob/main/src/systems/force_torque/ForceTorque.cc",)

    bad = (
        Bad(
            '<link name="b"><sensor name="s" type="«force_torque»"/></link>',
            says="sensor `s` is on link `b`, and a `force_torque` sensor measures a joint",
        ),
        Bad(
            '<gazebo reference="base"><sensor name="s" type="«force_torque»"/></gazebo>',
            scaffold='<robot name="r"><link name="base"/>{}</robot>',
        ),
    )
    good = (
        Good(JOINT),
        Good('<link name="b"><sensor name="s" type="contact"/></link>'),
    )

    @staticmethod
    def applies(sensor: Sensor) -> bool:
        return sensor.type == KIND and isinstance(sensor.owner, Link)

    def check(self, sensor: Sensor) -> Iterator[Diagnostic]:
        assert sensor.owner is not None
        message = f"{sensor.title} is on {sensor.owner.title}, and a `{KIND}` sensor measures a joint"
        yield self.diagnostic(sensor.type_value or sensor, message)

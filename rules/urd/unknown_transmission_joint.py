from collections.abc import Iterator

from sdfcheck import IN_URDF_JOINT, Bad, Diagnostic, Good, Rule, Severity, Transmission

LIMIT = '<limit lower="0" upper="1" effort="1" velocity="1"/></joint>'
TRANSMISSION = (
    '<transmission name="t"><type>transmission_interface/SimpleTransmission</type>'
    '<joint name="{}"><hardwareInterface>hardware_interface/EffortJointInterface</hardwareInterface></joint>'
    '<actuator name="m"/></transmission>'
)


class UnknownTransmissionJoint(Rule):
    """A transmission is for a joint that the robot does not have.

    Drake refuses the file. Controllers find no such joint when they start, mostly long
    after the robot was loaded.
    """

    code = "URD011"
    name = "unknown-transmission-joint"
    severity = Severity.ERROR
    remedy = """Name a joint of the robot in the transmission, with its prefix.

    Where the joint was removed, remove the transmission.
    """
    looks_at = (Transmission,)
    selects = ("urdf:robot/transmission",)
    scaffold = IN_URDF_JOINT.replace("{}</joint>", f"{LIMIT}{{}}").replace('name="j"', 'name="shoulder"')

    bad = (
        Bad(
            TRANSMISSION.replace("{}", "«sholder»"),
            fixed=TRANSMISSION.replace("{}", "shoulder"),
            unsafe=True,
            says="transmission `t` is for joint `sholder`, which does not exist; did you mean `shoulder`?",
        ),
    )
    good = (Good(TRANSMISSION.replace("{}", "shoulder")),)

    @staticmethod
    def applies(transmission: Transmission) -> bool:
        return bool(transmission.unresolved)

    def check(self, transmission: Transmission) -> Iterator[Diagnostic]:
        for value in transmission.unresolved:
            message = f"{transmission.title} is for joint `{value.text}`, which does not exist"
            near = transmission.nearest(value.text, transmission.model.driven)
            yield self.diagnostic(value, message, meant=near)

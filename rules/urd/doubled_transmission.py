from collections.abc import Iterator

from sdfcheck import IN_URDF_JOINT, Bad, Diagnostic, Good, Model, Rule, Severity, Transmission, Value

LIMIT = '<limit lower="0" upper="1" effort="1" velocity="1"/></joint>'
TRANSMISSION = (
    '<transmission name="{}"><type>transmission_interface/{}Transmission</type>'
    '<joint name="{}"><hardwareInterface>hardware_interface/EffortJointInterface</hardwareInterface></joint>'
    '<actuator name="m{}"/></transmission>'
)
FIRST = TRANSMISSION.format("a", "Simple", "shoulder", "1")


class DoubledTransmission(Rule):
    """Two simple transmissions drive one joint.

    ros_control replaces what the first one registered by the second. Mostly the second is a copy, and the joint that it
    was meant for has no transmission.
    """

    code = "URD030"
    name = "doubled-transmission"
    severity = Severity.WARNING
    remedy = """Name in each transmission the joint that its actuator moves, and remove the copy.

    If xacro writes both, one of the files is included, or one of the macros called, twice.
    """
    looks_at = (Model,)
    selects = ("urdf:robot",)
    needs = ("SimpleTransmission",)
    scaffold = IN_URDF_JOINT.replace("{}</joint>", f"{LIMIT}{{}}").replace('name="j"', 'name="shoulder"')

    bad = (
        Bad(
            FIRST + TRANSMISSION.format("b", "Simple", "«shoulder»", "2"),
            says="transmission `b` drives joint `shoulder`, as transmission `a` does",
        ),
        Bad(
            '<link name="p"/><joint name="plate" type="fixed"><parent link="base"/><child link="p"/></joint>'
            + TRANSMISSION.format("a", "Simple", "plate", "1")
            + TRANSMISSION.format("b", "Simple", "«plate»", "2"),
            says="transmission `b` drives joint `plate`, as transmission `a` does",
            also=("URD011",),
        ),
    )
    good = (
        Good(FIRST),
        Good(
            FIRST + TRANSMISSION.format("b", "Differential", "shoulder", "2"),
            why="a transmission of several joints is read by itself",
        ),
    )

    @staticmethod
    def applies(model: Model) -> bool:
        return bool(doubled(model))

    def check(self, model: Model) -> Iterator[Diagnostic]:
        for transmission, value, first in doubled(model):
            message = f"{transmission.title} drives joint `{value.text}`, as {first.title} does"
            yield self.diagnostic(value, message, labels={first: "the first one"})


def doubled(model: Model) -> list[tuple[Transmission, Value, Transmission]]:
    """The simple transmissions of joints that have one, with the joint's name, and that one."""
    firsts: dict[str, Transmission] = {}
    found = []
    for transmission in model.transmissions:
        kind = transmission.type_value
        if kind is None or kind.text.strip().rpartition("/")[2] != "SimpleTransmission":
            continue
        for value in transmission.joint_names:
            first = firsts.setdefault(value.text, transmission)
            if first is not transmission:
                found.append((transmission, value, first))
    return found

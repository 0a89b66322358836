from collections.abc import Iterator

from sdfcheck import Bad, Diagnostic, Element, Good, Ros2Control, Rule, Severity, Value
from sdfcheck_rules.r2c.scaffold import IN_BLOCK

TRANSMISSIONS = ("DifferentialTransmission", "FourBarLinkageTransmission")
"""Those of two joints and two actuators."""
JOINTS = '<joint name="lift"/><joint name="follower"/>'
ACTUATORS = '<actuator name="m1" role="actuator1"/><actuator name="m2" role="actuator2"/>'
FIRST, SECOND = '<joint name="lift" role="{}"/>', '<joint name="follower" role="{}"/>'
TRANSMISSION = (
    f'{JOINTS}<transmission name="t"><plugin>transmission_interface/{{}}</plugin>{ACTUATORS}'
    "{}</transmission>"
)


class UnorderedRoles(Rule):
    """The joints or actuators of a transmission are not in the order of their roles.

    ros2_control reads the roles and goes by the order: the first joint is taken for `joint1`, whatever its role says.
    With the two exchanged a differential turns where it should bend. In ROS 1 the roles decided.
    """

    code = "R2C038"
    name = "unordered-roles"
    severity = Severity.WARNING
    remedy = """Write `joint1` before `joint2`, and `actuator1` before `actuator2`."""
    looks_at = (Ros2Control,)
    needs = ("<transmission",)
    scaffold = IN_BLOCK

    bad = (
        Bad(
            TRANSMISSION.format(
                "DifferentialTransmission", FIRST.format("«joint2»") + SECOND.format("joint1")
            ),
            says="ros2_control takes joint `lift` for `joint1`, as it is the first one",
        ),
        Bad(
            TRANSMISSION.replace('"actuator1"', '"«actuator2»"', 1)
            .replace('="actuator2"', '="actuator1"', 1)
            .format("FourBarLinkageTransmission", FIRST.format("joint1") + SECOND.format("joint2")),
            says="ros2_control takes actuator `m1` for `actuator1`, as it is the first one",
        ),
    )
    good = (
        Good(
            TRANSMISSION.format("DifferentialTransmission", FIRST.format("joint1") + SECOND.format("joint2"))
        ),
        Good(
            TRANSMISSION.format("DifferentialTransmission", FIRST.format("left") + SECOND.format("joint2")),
            why="a role that says nothing of the order",
        ),
    )

    @staticmethod
    def applies(block: Ros2Control) -> bool:
        return next(unordered(block), None) is not None

    def check(self, block: Ros2Control) -> Iterator[Diagnostic]:
        for element, role, taken in unordered(block):
            name = element.attributes.get("name", "")
            message = f"ros2_control takes {element.name} `{name}` for `{taken}`, as it is the first one"
            yield self.diagnostic(role, message)


def unordered(block: Ros2Control) -> Iterator[tuple[Element, Value, str]]:
    """The first parts whose role is that of the second one, with the role, and the one that it is taken for."""
    for transmission in block.children("transmission"):
        plugin = transmission.find("plugin")
        if plugin is None or plugin.content.rpartition("/")[2] not in TRANSMISSIONS:
            continue
        for kind in ("joint", "actuator"):
            parts = list(transmission.children(kind))
            roles = [part.attributes.get("role", "").strip() for part in parts]
            role = parts[0].attribute("role") if parts else None
            if role is not None and roles == [f"{kind}2", f"{kind}1"]:
                yield parts[0], role, f"{kind}1"

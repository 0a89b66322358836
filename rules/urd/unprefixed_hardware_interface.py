from collections.abc import Iterator

from sdfcheck import (
    IN_ROBOT,
    Bad,
    Diagnostic,
    Document,
    Element,
    Good,
    Rule,
    Severity,
    TextEdit,
    Value,
    make_fix,
    used,
)
from sdfcheck_rules.urd.missing_hardware_interface import JOINT

PREFIX = "hardware_interface/"
BARE = frozenset(("EffortJointInterface", "PositionJointInterface", "VelocityJointInterface"))
"""The interfaces that the simulator takes without their prefix, and warns."""
OLD = "<hardwareInterface>EffortJointInterface</hardwareInterface>"
NEW = "<hardwareInterface>hardware_interface/EffortJointInterface</hardwareInterface>"
BOTH = (
    '<joint name="j">{0}</joint><actuator name="m">{0}<mechanicalReduction>1</mechanicalReduction></actuator>'
)


class UnprefixedHardwareInterface(Rule):
    """A transmission names the interface of its joint without `hardware_interface/`.

    The simulator of ros_control calls this deprecated and warns for each joint; the loader of transmissions for real
    robots looks for a plugin of the whole name and finds none.
    """

    code = "URD026"
    name = "unprefixed-hardware-interface"
    severity = Severity.WARNING
    remedy = "Write `hardware_interface/` before the name of the interface."
    looks_at = (Element,)
    selects = ("urdf:transmission",)
    needs = ("<hardwareInterface",)
    scaffold = IN_ROBOT
    sources = (
        "https://github.com/ros-simulation/gazebo_ros_pkgs/blob/noetic-devel/gazebo_ros_control/src/default_robot_hw_sim.cpp",
    )

    bad = (
        Bad(
            JOINT.format(BOTH.format(OLD).replace(">EffortJointInterface<", ">«EffortJointInterface»<", 1)),
            fixed=JOINT.format(BOTH.format(NEW)),
            says="`EffortJointInterface` of transmission `t` is called `hardware_interface/EffortJointInterface`",
        ),
        Bad(
            JOINT.format(f"<joint name='j'>{OLD}</joint>")
            .replace(">EffortJoint", ">«EffortJoint", 1)
            .replace("Interface</", "Interface»</", 1)
            + '<transmission name="u"><type>transmission_interface/SimpleTransmission</type>'
            f'<joint name="j">{OLD}</joint></transmission>',
            says="(used 2 times)",
            also=("URD030",),
        ),
    )
    good = (
        Good(JOINT.format(BOTH.format(NEW))),
        Good(
            JOINT.format(BOTH.format(NEW.replace("hardware_interface/EffortJoint", "franka_hw/FrankaState"))),
            why="of another package",
        ),
        Good(
            JOINT.format(BOTH.format(OLD.replace("EffortJointInterface", "${interface}"))),
            why="the prefix may be in the value",
        ),
    )

    @staticmethod
    def applies(transmission: Element) -> bool:
        is_old = any(map(is_bare, transmission.children("joint")))
        return is_old and transmission.document.view(bare_transmissions)[0] is transmission

    def check(self, transmission: Element) -> Iterator[Diagnostic]:
        found = transmission.document.view(bare_transmissions)
        values = [value for one in found for part in one.children() for value in bare_names(part)]
        text = values[0].text.strip()
        edits = tuple(TextEdit(value.span, PREFIX + value.text.strip()) for value in values)
        name = transmission.attributes.get("name", "")
        yield self.diagnostic(
            values[0],
            f"`{text}` of transmission `{name}` is called `{PREFIX}{text}`{used(len(found))}",
            fix=make_fix(f"write `{PREFIX}`", edits),
        )


def bare_transmissions(document: Document) -> list[Element]:
    """The transmissions of which a joint has an interface without the prefix."""
    transmissions = (element for element in document.elements if element.name == "transmission")
    return [each for each in transmissions if any(map(is_bare, each.children("joint")))]


def is_bare(part: Element) -> bool:
    """Has a joint or an actuator an interface of the simulator's, without the prefix?"""
    return any(bare_names(part))


def bare_names(part: Element) -> Iterator[Value]:
    """The interfaces of a joint or an actuator that lack the prefix."""
    for interface in part.children("hardwareInterface"):
        if interface.content.strip() in BARE:
            yield interface.own_value

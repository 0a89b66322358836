from collections.abc import Iterator

from sdfcheck import Bad, ControlInterface, Diagnostic, Good, Rule, Severity, suggest
from sdfcheck_rules.r2c.scaffold import IN_BLOCK, IN_LIFT

OF_JOINTS = frozenset(
    """
    acceleration current derivative effort feedforward force integral jerk position position_pid
    proportional temperature torque velocity velocity_pid
    """.split()
)
OF_SENSORS = frozenset(
    f"{what}.{axis}"
    for what, axes in (
        ("orientation", "xyzw"),
        ("angular_velocity", "xyz"),
        ("linear_acceleration", "xyz"),
        ("force", "xyz"),
        ("torque", "xyz"),
        ("magnetic_field", "xyz"),
    )
    for axis in axes
)
QUANTITIES = frozenset(each.partition(".")[0] for each in OF_SENSORS)
"""A sensor of somebody's own may give one number for each of them."""
SHORT = {"acc": "acceleration", "eff": "effort", "pos": "position", "vel": "velocity"}
IN_GAZEBO = {"angle": "position", "force": "effort", "speed": "velocity", "torque": "effort"}
"""Other words for what Gazebo's hardware reads and writes of a joint."""


def meant(interface: ControlInterface) -> str | None:
    """The known name that was meant; None for a name of its own."""
    name, what = interface.name, interface.component.what
    known = OF_JOINTS if what == "joint" else OF_SENSORS if what == "sensor" else frozenset[str]()
    if what == "joint" and name in IN_GAZEBO and interface.component.block.is_simulated:
        return IN_GAZEBO[name]
    if name in known or (what == "sensor" and name in QUANTITIES):
        return None
    if what == "joint" and name in SHORT:
        return SHORT[name]
    near = suggest(name.replace(".", "_"), {each.replace(".", "_"): each for each in known})
    if near is None or name.startswith((f"{near}_", f"{near}.", f"{near}1", f"{near}2")):
        return None
    return next(each for each in known if each.replace(".", "_") == near)


class MisspelledInterface(Rule):
    """The name of an interface is nearly one that controllers ask for.

    Names are free, and a controller and the hardware must agree on them letter by letter. Known ones are
    `position`, `velocity`, `acceleration`, `effort` and those of ros2_control's own sensors; a name that is
    nearly one of them is found when the controller does not start.
    """

    code = "R2C024"
    name = "misspelled-interface"
    severity = Severity.WARNING
    remedy = """Write the name that the controller and the hardware use: mostly `position`, `velocity` or `effort`.

    Sensors have names such as `orientation.x`, `angular_velocity.x`, `force.x`. For a name of your own that
    both sides know, ignore this.
    """
    looks_at = (ControlInterface,)
    scaffold = IN_LIFT

    bad = (
        Bad(
            '<command_interface name="«positon»"/>',
            fixed='<command_interface name="position"/>',
            unsafe=True,
            says="interface `positon` of joint `lift`; did you mean `position`?",
        ),
        Bad(
            '<state_interface name="«vel»"/>',
            fixed='<state_interface name="velocity"/>',
            unsafe=True,
            says="did you mean `velocity`?",
        ),
        Bad(
            '<sensor name="imu"><state_interface name="«orientation_x»"/></sensor>',
            fixed='<sensor name="imu"><state_interface name="orientation.x"/></sensor>',
            unsafe=True,
            scaffold=IN_BLOCK,
            says="did you mean `orientation.x`?",
        ),
        Bad(
            '<sensor name="imu"><state_interface name="«lin_acceleration.x»"/></sensor>',
            fixed='<sensor name="imu"><state_interface name="linear_acceleration.x"/></sensor>',
            unsafe=True,
            scaffold=IN_BLOCK,
            says="did you mean `linear_acceleration.x`?",
        ),
        Bad(
            '<command_interface name="«torque»"/>',
            fixed='<command_interface name="effort"/>',
            unsafe=True,
            scaffold=IN_LIFT.replace("mock_components/GenericSystem", "gz_ros2_control/GazeboSimSystem"),
            says="did you mean `effort`?",
            also=("R2C029",),
        ),
    )
    good = (
        Good('<command_interface name="stiffness"/>', why="names are free"),
        Good('<command_interface name="torque"/>', why="hardware of somebody's own may have it"),
        Good('<command_interface name="position_x"/>', why="made from a known name"),
        Good(
            '<sensor name="grip"><state_interface name="force"/></sensor>',
            scaffold=IN_BLOCK,
            why="one number for the whole",
        ),
    )

    @staticmethod
    def applies(interface: ControlInterface) -> bool:
        return interface.is_readable and meant(interface) is not None

    def check(self, interface: ControlInterface) -> Iterator[Diagnostic]:
        near, name = meant(interface), interface.name_value
        assert near is not None
        assert name is not None
        message = f"interface `{interface.name}` of {interface.component.title}"
        yield self.diagnostic(name, message, meant=near)

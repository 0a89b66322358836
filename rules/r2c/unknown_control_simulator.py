from collections.abc import Iterator

from sdfcheck import Bad, Diagnostic, Good, Plugin, Rule, Severity, suggest
from sdfcheck_rules.r2c.scaffold import IN_ROBOT

CLASSES: dict[str, tuple[str, ...]] = {
    "gz_ros2_control-system": (
        "gz_ros2_control::GazeboSimROS2ControlPlugin",
        "ign_ros2_control::IgnitionROS2ControlPlugin",
    ),
    "ign_ros2_control-system": ("ign_ros2_control::IgnitionROS2ControlPlugin",),
}
"""Library → the classes in it."""


SIMULATED = (
    '<gazebo><plugin filename="gz_ros2_control-system" name="gz_ros2_control::GazeboSimROS2ControlPlugin">'
    "<parameters>c.yaml</parameters></plugin></gazebo>"
)


class UnknownControlSimulator(Rule):
    """The name of Gazebo's plugin for `ros2_control` is nearly that of a known one.

    Gazebo does not find such a library or class, logs an error and simulates the robot without controllers.
    """

    code = "R2C028"
    name = "unknown-control-simulator"
    severity = Severity.WARNING
    remedy = """Write library and class as their package calls them.

    For Gazebo since Garden they are `gz_ros2_control-system` and
    `gz_ros2_control::GazeboSimROS2ControlPlugin`, for Fortress with Humble `ign_ros2_control-system` and
    `ign_ros2_control::IgnitionROS2ControlPlugin`, for Classic `libgazebo_ros2_control.so`.
    """
    looks_at = (Plugin,)
    scaffold = IN_ROBOT

    bad = (
        Bad(
            '<gazebo><plugin filename="«gz_ros2_contrl-system»" name="gz_ros2_control::GazeboSimROS2ControlPlugin">'
            "<parameters>c.yaml</parameters></plugin></gazebo>",
            fixed=SIMULATED,
            unsafe=True,
            says="no library `gz_ros2_contrl-system`; did you mean `gz_ros2_control-system`?",
        ),
        Bad(
            '<gazebo><plugin filename="«libignition_ros2_control-system.so»"'
            ' name="ign_ros2_control::IgnitionROS2ControlPlugin"><parameters>c.yaml</parameters></plugin></gazebo>',
            fixed='<gazebo><plugin filename="ign_ros2_control-system"'
            ' name="ign_ros2_control::IgnitionROS2ControlPlugin"><parameters>c.yaml</parameters></plugin></gazebo>',
            unsafe=True,
            says="no library `libignition_ros2_control-system.so`; did you mean `ign_ros2_control-system`?",
        ),
        Bad(
            SIMULATED.replace("gz_ros2_control-system", "«gz_ros2_control»"),
            fixed=SIMULATED,
            unsafe=True,
            says="no library `gz_ros2_control`; did you mean `gz_ros2_control-system`?",
        ),
        Bad(
            '<gazebo><plugin filename="gz_ros2_control-system" name="«gz_ros2_control::GazeboSimRos2Control»">'
            "<parameters>c.yaml</parameters></plugin></gazebo>",
            fixed=SIMULATED,
            unsafe=True,
            says="`gz_ros2_control-system` has no class `gz_ros2_control::GazeboSimRos2Control`",
            also=("R2C037",),
        ),
        Bad(
            '<gazebo><plugin filename="ign_ros2_control-system" name="«gz_ros2_control::GazeboSimROS2ControlPlugin»">'
            "<parameters>c.yaml</parameters></plugin></gazebo>",
            says="`ign_ros2_control-system` has no class `gz_ros2_control::GazeboSimROS2ControlPlugin`",
            also=("R2C037",),
            fixed='<gazebo><plugin filename="ign_ros2_control-system"'
            ' name="ign_ros2_control::IgnitionROS2ControlPlugin">'
            "<parameters>c.yaml</parameters></plugin></gazebo>",
            unsafe=True,
        ),
    )
    good = (
        Good(
            '<gazebo><plugin filename="libign_ros2_control-system.so"'
            ' name="ign_ros2_control::IgnitionROS2ControlPlugin">'
            "<parameters>c.yaml</parameters></plugin></gazebo>"
        ),
        Good(
            '<gazebo><plugin filename="libgazebo_ros2_control.so" name="any_name"/></gazebo>',
            why="in Gazebo Classic the name is free",
        ),
        Good(
            '<gazebo><plugin filename="franka_ign_ros2_control-system"'
            ' name="ign_ros2_control::IgnitionROS2ControlPlugin"><parameters>c.yaml</parameters></plugin></gazebo>',
            why="a library of somebody's own, with the class of the one that it was made from",
        ),
    )

    @staticmethod
    def applies(plugin: Plugin) -> bool:
        file = plugin.filename.removeprefix("lib").removesuffix(".so")
        if file in CLASSES:
            return bool(plugin.name) and plugin.name not in CLASSES[file]
        return meant_library(plugin) is not None

    def check(self, plugin: Plugin) -> Iterator[Diagnostic]:
        file = plugin.filename.removeprefix("lib").removesuffix(".so")
        if file in CLASSES:
            message = f"`{file}` has no class `{plugin.name}`"
            yield self.diagnostic(plugin.name_value or plugin, message, meant=CLASSES[file][0])
        else:
            message = f"there is no library `{plugin.filename}`"
            yield self.diagnostic(plugin.filename_value or plugin, message, meant=meant_library(plugin))


def meant_library(plugin: Plugin) -> str | None:
    """The library that was probably meant, by its name or by the last part of the class's."""
    file = plugin.filename.removeprefix("lib").removesuffix(".so")
    if any(file.endswith(f"_{library}") for library in CLASSES):
        return None  # somebody's own, made from that one
    if (near := suggest(file, CLASSES)) is not None or file == "gazebo_ros2_control":
        return near
    if not file.endswith("_ros2_control-system"):
        return next((library for library, classes in CLASSES.items() if plugin.name == classes[0]), None)
    last = plugin.name.rpartition("::")[2]
    owners = (library for library, classes in CLASSES.items() if classes[0].endswith(f"::{last}"))
    return next(owners, None) if last else None

import re
from collections.abc import Iterator

from sdfcheck import IN_MODEL, Bad, Diagnostic, Element, Good, Plugin, Rule, Severity, Value, named

MOTOR = (
    '<link name="w"/><joint name="j" type="revolute"><parent>base</parent><child>w</child>'
    "<axis><xyz>0 0 1</xyz></axis></joint>"
    '<plugin name="gz::sim::systems::MulticopterMotorModel" filename="gz-sim-multicopter-motor-model-system">'
    "<jointName>j</jointName><linkName>w</linkName><actuator_number>0</actuator_number>"
    "<turningDirection>{}</turningDirection></plugin>"
)
ODOMETRY = (
    '<plugin name="gz::sim::systems::OdometryPublisher" filename="gz-sim-odometry-publisher-system">'
    "<dimensions>{}</dimensions></plugin>"
)
BATTERY = (
    '<plugin name="gz::sim::systems::LinearBatteryPlugin" filename="gz-sim-linearbatteryplugin-system">'
    "<battery_name>b</battery_name><voltage>12</voltage><capacity>{}</capacity></plugin>"
)


CAR = (
    '<plugin name="gz::sim::systems::MecanumDrive" filename="gz-sim-mecanum-drive-system">'
    "<{0}_velocity>{1}</{0}_velocity></plugin>"
)
ENGINE = (
    '<sdf version="1.9"><world name="w"><plugin name="gz::sim::systems::Physics" filename="gz-sim-physics-system">'
    "<engine><filename>{}</filename></engine></plugin></world></sdf>"
)
DRIVES = frozenset(f"gz-sim-{kind}-system" for kind in ("ackermann-steering", "diff-drive", "mecanum-drive"))
ENGINES = ("bullet", "bullet-featherstone", "dartsim", "mujoco", "tpe")
NAME = re.compile(r"(?:lib)?(?:gz|ignition)-physics\d*-([\w-]+?)-plugin\d*(?:\.so)?")
"""The file of an engine of Gazebo itself; others have names of their own."""


class RefusedPluginValue(Rule):
    """A parameter of a plugin of Gazebo has a value that the plugin refuses, or elements for a value.

    It reports an error, and takes another value or stays off. Of a parameter that is text or a number it reads the text
    alone: with an element inside, as some parameters of the same plugin have it, that is blank.

    A drive limits its rate of turning by `min_velocity` and `max_velocity` as well, unless it has limits for that:
    with a least velocity of 0 it does not turn to the right.
    """

    code = "RES027"
    name = "refused-plugin-value"
    severity = Severity.WARNING
    remedy = """Write one of the values that the message names.

    They are those in the code of the plugin; the letters have to be the same, capital and small.
    """
    looks_at = (Plugin,)
    scaffold = IN_MODEL
    sources = ("https://github.com/gazebosim/gz-sim/tree/main/src/systems",)

    bad = (
        Bad(
            MOTOR.format("«CW»"),
            says="of plugin `gz::sim::systems::MulticopterMotorModel` is `CW`, and may be `cw` or `ccw`",
        ),
        Bad(ODOMETRY.format("«4»"), says="is `4`, and may be `2` or `3`"),
        Bad(BATTERY.format("«0»"), says="is `0`, and may be more than 0"),
        Bad(
            ODOMETRY.format("3").replace(
                "</plugin>", "<odom_frame><«name»>odom</name></odom_frame></plugin>"
            ),
            says="reads `odom_frame` as text, and there is element `name`",
        ),
        Bad(
            CAR.format("min", "«0»"),
            says="is `0`, and limits its rate of turning too, so that it does not turn right",
            also=("RES021",),
        ),
        Bad(
            ENGINE.format("«gz-physics-ode-plugin»"),
            scaffold="{}",
            says="engine `ode` is not one of Gazebo, which has `bullet`, `bullet-featherstone`, `dartsim`, ",
        ),
    )
    good = (
        Good(ENGINE.format("libgz-physics7-dartsim-plugin.so"), scaffold="{}"),
        Good(ENGINE.format("my-engine"), scaffold="{}", why="an engine of one's own"),
        Good(CAR.format("max", "2")),
        Good(MOTOR.format("ccw")),
        Good(ODOMETRY.format("3")),
        Good(BATTERY.format("1.5")),
        Good(
            '<plugin name="gz::sim::systems::ShaderParam" filename="gz-sim-shader-param-system"><param>'
            "<type>texture_cube</type></param></plugin>"
        ),
    )

    @staticmethod
    def applies(plugin: Plugin) -> bool:
        found = (plugin.refused_values, nested(plugin), onesided(plugin), unknown_engines(plugin))
        return any(True for each in found for _ in each)

    def check(self, plugin: Plugin) -> Iterator[Diagnostic]:
        for value, allowed in plugin.refused_values:
            name = value.attribute or value.element.name
            message = f"`{name}` of {plugin.title} is `{value.text.strip()}`, and may be {words(allowed)}"
            yield self.diagnostic(value, message)
        for value, side in onesided(plugin):
            message = (
                f"`{value.element.name}` of {plugin.title} is `{value.text.strip()}`, and limits its rate of"
            )
            yield self.diagnostic(value, f"{message} turning too, so that it does not turn {side}")
        for value, engine in unknown_engines(plugin):
            message = f"engine `{engine}` is not one of Gazebo, which has {named(ENGINES)}"
            yield self.diagnostic(value, message)
        for parameter, child in nested(plugin):
            message = f"{plugin.title} reads `{parameter.name}` as text, and there is element `{child.name}`"
            yield self.diagnostic(child, message, help=f"write the value into `{parameter.name}` itself")


def nested(plugin: Plugin) -> Iterator[tuple[Element, Element]]:
    """The parameters that are a single value and have elements, and the first of these."""
    facts = plugin.known
    plain = facts.parameters - facts.repeatable if facts is not None else frozenset[str]()
    for parameter in plugin.parameters if plain else ():
        child = next(iter(parameter.children()), None)
        if child is not None and parameter.name in plain:
            yield parameter, child


def onesided(plugin: Plugin) -> Iterator[tuple[Value, str]]:
    """The limits of a drive that leave it no rate of turning to one side, with that side."""
    if plugin.known is None or plugin.known.file not in DRIVES:
        return
    for end, side, sign in (("min", "right", 1), ("max", "left", -1)):
        limit = plugin.find(f"{end}_velocity")
        value = limit.own_value if limit is not None else None
        if value is not None and value.number * sign >= 0 and not plugin.find(f"{end}_angular_velocity"):
            yield value, side


def unknown_engines(plugin: Plugin) -> Iterator[tuple[Value, str]]:
    """The files with names like those of the engines of Gazebo, which has no such engine, and the engines."""
    if plugin.known is None or plugin.known.file != "gz-sim-physics-system":
        return
    for engine in plugin.children("engine"):
        file = engine.find("filename")
        value = file.own_value if file is not None else None
        match = NAME.fullmatch(value.text.strip()) if value is not None else None
        if value is not None and match is not None and match[1] not in ENGINES:
            yield value, match[1]


def words(allowed: str) -> str:
    """The values that are allowed, as the table has them, in words."""
    if allowed.startswith(">"):
        return "0 or more" if "=" in allowed else "more than 0"
    return allowed.replace("..", " to ") if ".." in allowed else named(allowed.split("|"), "or")

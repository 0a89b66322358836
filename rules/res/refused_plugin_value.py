from collections.abc import Iterator

from sdfcheck import IN_MODEL, Bad, Diagnostic, Element, Good, Plugin, Rule, Severity, named

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


class RefusedPluginValue(Rule):
    """A parameter of a plugin of Gazebo has a value that the plugin refuses, or elements for a value.

    It reports an error, and takes another value or stays off. Of a parameter that is text or a number it reads the text
    alone: with an element inside, as some parameters of the same plugin have it, that is blank.
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
    )
    good = (
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
        return any(True for _ in plugin.refused_values) or any(True for _ in nested(plugin))

    def check(self, plugin: Plugin) -> Iterator[Diagnostic]:
        for value, allowed in plugin.refused_values:
            name = value.attribute or value.element.name
            message = f"`{name}` of {plugin.title} is `{value.text.strip()}`, and may be {words(allowed)}"
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


def words(allowed: str) -> str:
    """The values that are allowed, as the table has them, in words."""
    if allowed.startswith(">"):
        return "0 or more" if "=" in allowed else "more than 0"
    return allowed.replace("..", " to ") if ".." in allowed else named(allowed.split("|"), "or")

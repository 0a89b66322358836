from collections.abc import Iterator

from sdfcheck import Bad, Diagnostic, Good, Plugin, Rule, Severity
from sdfcheck_rules.r2c.scaffold import IN_ROBOT

NEEDY = frozenset(
    f"{prefix}{name}{suffix}"
    for name in ("gz_ros2_control-system", "ign_ros2_control-system")
    for prefix, suffix in (("", ""), ("lib", ".so"), ("lib", ""), ("", ".so"))
)


FOUND = (
    '<gazebo><plugin filename="gz_ros2_control-system" name="gz_ros2_control::GazeboSimROS2ControlPlugin">'
    "<parameters>{}</parameters></plugin></gazebo>"
)
XACRO = IN_ROBOT.replace("<robot ", '<robot xmlns:xacro="http://www.ros.org/wiki/xacro" ', 1)
FILE = "arm/urdf/robot.urdf.xacro"
FILES = {
    "arm/package.xml": "<package><name>arm</name></package>",
    "arm/config/control.yaml": "controller_manager: {ros__parameters: {update_rate: 100}}\n",
}
INSTALLED = {
    "arm/package.xml": FILES["arm/package.xml"],
    "arm/bringup/config/control.yaml": FILES["arm/config/control.yaml"],
    "arm/CMakeLists.txt": "project(arm)\ninstall(DIRECTORY bringup/config DESTINATION share/arm)\n",
}


class ControlPluginWithoutParameters(Rule):
    """Gazebo's plugin for `ros2_control` has no file of parameters.

    `gz_ros2_control` and `ign_ros2_control` stop with an error if `<parameters>` is missing or empty: no
    controller manager, and no joint moves. With a file that is not there, Gazebo ends. Looked at are files of
    packages of the project (`$(find my_robot)/…`) that no build makes.
    """

    code = "R2C027"
    name = "control-plugin-without-parameters"
    severity = Severity.ERROR
    remedy = """Give the plugin `<parameters>` with the path of the YAML file of its controllers.

    In xacro: `<parameters>$(find my_robot)/config/controllers.yaml</parameters>`. The file has
    `controller_manager` at its top, with `ros__parameters` and one entry for each controller.
    """
    looks_at = (Plugin,)
    scaffold = IN_ROBOT

    bad = (
        Bad(
            '<gazebo><«plugin» filename="gz_ros2_control-system" name="gz_ros2_control::GazeboSimROS2ControlPlugin"/>'
            "</gazebo>",
            says="plugin `gz_ros2_control::GazeboSimROS2ControlPlugin` needs `<parameters>`",
            also=("R2C037",),
        ),
        Bad(
            FOUND.format("«$(find arm)/cofing/control.yaml»"),
            scaffold=XACRO,
            file=FILE,
            files=FILES,
            says="`cofing/control.yaml` is not in package `arm`; there is `config/control.yaml`",
            also=("R2C037",),
        ),
    )
    good = (
        Good(FOUND.format("$(find arm)/config/control.yaml"), scaffold=XACRO, file=FILE, files=FILES),
        Good(
            FOUND.format("$(find arm)/config/control.yaml"),
            scaffold=XACRO,
            file=FILE,
            files=INSTALLED,
            why="it is there once the package is installed",
        ),
        Good(
            '<gazebo><plugin filename="gz_ros2_control-system" name="gz_ros2_control::GazeboSimROS2ControlPlugin">'
            "<parameters>controllers.yaml</parameters></plugin></gazebo>"
        ),
        Good(
            '<xacro:arg name="file" default=""/><gazebo>'
            '<plugin filename="gz_ros2_control-system" name="gz_ros2_control::GazeboSimROS2ControlPlugin">'
            "<parameters>$(arg file)</parameters></plugin></gazebo>",
            scaffold=XACRO,
            file="robot.urdf.xacro",
            why="the launch file gives the argument",
        ),
    )

    @staticmethod
    def applies(plugin: Plugin) -> bool:
        if plugin.missing_parameters_file is not None:
            return True
        if plugin.filename not in NEEDY or plugin.is_template:
            return False
        if any(meant == "parameters" for _, meant in plugin.misspelled_parameters):
            return False
        # With an argument in it that is empty by default, the launch file gives the path.
        return not any(each.content or each.own_value.span.text for each in plugin.children("parameters"))

    def check(self, plugin: Plugin) -> Iterator[Diagnostic]:
        missing = plugin.missing_parameters_file
        if missing is not None:
            value, near = missing
            path = value.span.text.strip()
            package, _, inside = path.removeprefix("$(find ").partition(")/")
            message = f"`{inside}` is not in package `{package.strip()}`"
            yield self.diagnostic(value, f"{message}; there is `{near}`" if near else message)
            return
        yield self.diagnostic(plugin, f"{plugin.title} needs `<parameters>`, the file with its controllers")

from collections.abc import Iterator

from sdfcheck import Bad, Diagnostic, Good, Ros2Control, Rule, Severity
from sdfcheck_rules.r2c.scaffold import IN_ROBOT

STARTED = r"filename\s*=\s*.[^\"']*ros2_control"
"""Where a plugin that an argument of xacro may choose is written."""
BLOCK = '<ros2_control name="arm" type="system"><hardware><plugin>{}</plugin></hardware></ros2_control>'


class ControlWithoutSimulator(Rule):
    """A `ros2_control` block is for Gazebo, and the robot does not start Gazebo's controller manager.

    Its hardware is a joint of the simulator, which only the plugin of `gz_ros2_control`, `ign_ros2_control` or
    `gazebo_ros2_control` in a `gazebo` block makes. Without it no joint moves.
    """

    code = "R2C029"
    name = "control-without-simulator"
    severity = Severity.WARNING
    remedy = """Add a `<gazebo>` block with the plugin that starts the controller manager.

    ```xml
    <gazebo>
      <plugin filename="gz_ros2_control-system" name="gz_ros2_control::GazeboSimROS2ControlPlugin">
        <parameters>$(find my_robot)/config/controllers.yaml</parameters>
      </plugin>
    </gazebo>
    ```
    """
    looks_at = (Ros2Control,)
    scaffold = IN_ROBOT

    bad = (
        Bad(
            BLOCK.replace("{}", "«gz_ros2_control/GazeboSimSystem»"),
            says="no `<gazebo>` block of the robot starts",
        ),
    )
    good = (
        Good(
            BLOCK.replace("{}", "gz_ros2_control/GazeboSimSystem")
            + '<gazebo><plugin filename="gz_ros2_control-system" name="gz_ros2_control::GazeboSimROS2ControlPlugin">'
            "<parameters>c.yaml</parameters></plugin></gazebo>"
        ),
        Good(BLOCK.replace("{}", "mock_components/GenericSystem")),
    )

    @staticmethod
    def applies(block: Ros2Control) -> bool:
        if not block.is_simulated or any("ros2_control" in plugin.filename for plugin in block.model.plugins):
            return False
        return not block.document.may_write(STARTED)

    def check(self, block: Ros2Control) -> Iterator[Diagnostic]:
        plugin = block.plugin_value
        assert plugin is not None
        message = (
            f"{block.title} is for Gazebo, and no `<gazebo>` block of the robot starts its controller manager"
        )
        yield self.diagnostic(plugin, message)

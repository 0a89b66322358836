from collections.abc import Iterator

from sdfcheck import Bad, Diagnostic, Good, Root, Rule, Severity
from sdfcheck_rules.r2c.scaffold import IN_ROBOT

OTHER = r"<plugin>\s*(?!\s|(?:gz|ign|gazebo)_ros2_control/)"
"""Hardware that an argument of xacro may choose."""
BLOCK = '<ros2_control name="arm" type="system"><hardware><plugin>{}</plugin></hardware></ros2_control>'
PLUGIN = (
    '<gazebo><plugin filename="gz_ros2_control-system" name="gz_ros2_control::GazeboSimROS2ControlPlugin">'
    "<parameters>c.yaml</parameters></plugin></gazebo>"
)
SYSTEM = "gz_ros2_control/GazeboSimSystem"
GAZEBO = 'Node(package="ros_gz_sim", executable="create")\n'
MANAGER = 'Node(package="controller_manager", executable="ros2_control_node"{})\n'
NAMED = 'model = "robot.urdf"\n'


def launch(text: str) -> dict[str, str]:
    return {"sim.launch.py": NAMED + text}


class SurplusControlNode(Rule):
    """A launch file starts a controller manager beside the one of Gazebo, for a robot that Gazebo alone can move.

    The plugin of Gazebo has a controller manager of its own. The node `ros2_control_node` reads the same robot, does
    not find its hardware, which only Gazebo makes ("class … does not exist"), and ends, or takes the commands for
    controllers. Nothing is said where the launch file has a condition, and where xacro may choose other hardware.
    """

    code = "R2C048"
    name = "surplus-control-node"
    severity = Severity.WARNING
    remedy = """Remove `ros2_control_node` from the launch file of the simulation.

    The file of parameters belongs into the `<parameters>` of Gazebo's plugin. Or start the node on a condition, for the
    real robot, and choose its hardware by an argument of xacro.
    """
    looks_at = (Root,)
    needs = ("ros2_control",)
    scaffold = IN_ROBOT

    bad = (
        Bad(
            BLOCK.replace("{}", f"«{SYSTEM}»") + PLUGIN,
            files=launch(GAZEBO + MANAGER.format("")),
            file="robot.urdf",
            says="`sim.launch.py` starts a controller manager, to which the hardware of Gazebo does not exist",
        ),
        Bad(
            BLOCK.replace("{}", f"«{SYSTEM}»") + PLUGIN,
            files={
                "sim.launch.py": f'rsp = "rsp.launch.py"\n{GAZEBO}{MANAGER.format("")}',
                "rsp.launch.py": NAMED,
            },
            file="robot.urdf",
        ),
    )
    good = (
        Good(BLOCK.replace("{}", SYSTEM) + PLUGIN, files=launch(GAZEBO), file="robot.urdf"),
        Good(
            BLOCK.replace("{}", SYSTEM) + PLUGIN,
            files=launch(GAZEBO + MANAGER.format(", condition=UnlessCondition(sim)")),
            file="robot.urdf",
            why="it is for the real robot",
        ),
        Good(
            BLOCK.replace("{}", SYSTEM) + PLUGIN,
            files=launch(GAZEBO + MANAGER.format("")),
            file="other.urdf",
            why="for another robot",
        ),
    )

    @staticmethod
    def applies(root: Root) -> bool:
        return root.second_manager is not None and not root.document.may_write(OTHER)

    def check(self, root: Root) -> Iterator[Diagnostic]:
        span = root.second_manager
        assert span is not None
        block = next(each for model in root.models for each in model.ros2_control)
        file = span.source.path.name
        message = f"`{file}` starts a controller manager, to which the hardware of Gazebo does not exist"
        yield self.diagnostic(block.plugin_value or block, message, labels={span: "started here"})

from collections.abc import Iterator

from sdfcheck import IN_LINK, Bad, Diagnostic, Good, Plugin, Root, Rule, Severity

NODES = frozenset(("gazebo_ros2", "gazebo_ros2_control"))
CAMERA = (
    '<sensor name="{0}" type="camera"><camera/><plugin name="{1}" filename="libgazebo_ros_camera.so">'
    "<ros>{2}</ros><camera_name>{0}</camera_name></plugin></sensor>"
)
SPACE = "<namespace>{}</namespace>"


class DoubledNodeName(Rule):
    """Two plugins of Gazebo Classic make ROS 2 nodes of one name.

    A plugin of `gazebo_ros` calls its node by the name of the plugin, in the namespace of `<ros>`. Since Humble the
    second one of a name gets no node ("found multiple nodes with same name"), and Gazebo ends; before, both
    had one, and their parameters were mixed up.
    """

    code = "GAZ041"
    name = "doubled-node-name"
    severity = Severity.WARNING
    remedy = """Give each plugin a `name` of its own.

    Or a namespace of its own: `<ros><namespace>rear</namespace></ros>`. In a macro the name is made of its parameters.
    """
    looks_at = (Root,)
    needs = ("gazebo_ros",)
    scaffold = IN_LINK
    sources = ("https://github.com/ros-simulation/gazebo_ros_pkgs/blob/ros2/gazebo_ros/src/node.cpp",)

    bad = (
        Bad(
            CAMERA.format("front", "eye", "") + CAMERA.format("rear", "«eye»", ""),
            says="node `/eye` is made by plugin `eye` and by another one before it",
        ),
        Bad(
            CAMERA.format("front", "eye", SPACE.format("r"))
            + CAMERA.format("rear", "«eye»", SPACE.format("/r"))
        ),
    )
    good = (
        Good(
            CAMERA.format("front", "eye", "")
            + CAMERA.format("rear", "eye", "<remapping>__node:=rear_eye</remapping>")
        ),
        Good(CAMERA.format("front", "front_eye", "") + CAMERA.format("rear", "rear_eye", "")),
        Good(
            CAMERA.format("front", "eye", SPACE.format("front"))
            + CAMERA.format("rear", "eye", SPACE.format("rear"))
        ),
        Good(
            (CAMERA.format("front", "eye", "") + CAMERA.format("rear", "eye", ""))
            .replace("<ros></ros>", "")
            .replace("camera_name", "cameraName"),
            why="those of ROS 1 have one node",
        ),
    )

    @staticmethod
    def applies(root: Root) -> bool:
        return any(True for _ in doubled(root))

    def check(self, root: Root) -> Iterator[Diagnostic]:
        for node, (first, second, *others) in doubled(root):
            message = f"node `{node}` is made by {second.title} and by another one before it"
            labels = {first.value("name") or first: "the first one"}
            labels |= dict.fromkeys((each.value("name") or each for each in others), "the same")
            yield self.diagnostic(second.value("name") or second, message, labels=labels)


def doubled(root: Root) -> Iterator[tuple[str, list[Plugin]]]:
    """The names of nodes that several plugins make, with these."""
    makers: dict[str, list[Plugin]] = {}
    for plugin in root.each(Plugin):
        makers.setdefault(node_of(plugin), []).append(plugin)
    for node, plugins in makers.items():
        if node and len(plugins) > 1 and any(plugin.generation == "ros2" for plugin in plugins):
            yield node, plugins


def node_of(plugin: Plugin) -> str:
    """The name of its node with its namespace; empty where it has none, or where it is not known."""
    facts = plugin.known
    if facts is None or facts.generation not in NODES:
        return ""
    ros = plugin.find("ros")
    given = plugin if ros is None else ros
    if any("__" in each.content for name in ("argument", "remapping") for each in given.children(name)):
        return ""  # which renames it
    space = next((each.content for each in given.children("namespace")), "")
    name = f"/{space.strip().strip('/')}/{plugin.name}".replace("//", "/")
    return "" if not plugin.name or any(mark in name for mark in "${}") else name

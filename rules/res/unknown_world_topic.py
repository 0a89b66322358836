import re
from collections.abc import Iterator

from sdfcheck import SDF, Bad, Diagnostic, Good, Plugin, Root, Rule, Severity, Value, World

TOPIC = re.compile(r"/?world/([^/\s{}$]+)/\S*")
WORLD = (
    '<world name="yard"><gui><plugin filename="WorldControl" name="World control"><service>{}</service></plugin></gui>'
    "</world>"
)

ROBOT = '<{} name="r"><link name="a"/></robot>'
LAUNCH = (
    'Node(package="ros_gz_sim", executable="create", arguments=["-world", "{}", "-file", "robot.urdf"])\n'
    'gz = {{"gz_args": "-r yard.sdf"}}\n'
)


def files(name: str) -> dict[str, str]:
    return {"sim.launch.py": LAUNCH.format(name), "yard.sdf": '<sdf version="1.9"><world name="yard"/></sdf>'}


class UnknownWorldTopic(Rule):
    """A plugin of a world names a topic or service of another world, or a launch file such a world.

    Topics and services of a world of Gazebo begin with `/world/` and its name. Nobody publishes on those of a world
    that is not there: a button does nothing, a display stays empty, and `create` of `ros_gz_sim` waits for the service
    that creates the robot.
    """

    code = "RES023"
    name = "unknown-world-topic"
    severity = Severity.WARNING
    remedy = """Write the name of this world in the topic.

    A world that is renamed changes all its topics. A launch file that passes the name on, or a topic
    without `/world/NAME`, avoids the coupling.
    """
    looks_at = (Plugin, Root)
    scaffold = SDF

    bad = (
        Bad(
            WORLD.format("«/world/field/control»"),
            fixed=WORLD.format("/world/yard/control"),
            unsafe=True,
            says="`/world/field/control` is of world `field`, and this is world `yard`",
        ),
        Bad(
            ROBOT.format("«robot»"),
            scaffold="{}",
            file="robot.urdf",
            files=files("default"),
            says="`sim.launch.py` creates the robot in world `default`, and that of `yard.sdf` is called `yard`",
        ),
    )
    good = (
        Good(WORLD.format("/world/yard/control")),
        Good(WORLD.format("/clock"), why="of no world"),
        Good(ROBOT.format("robot"), scaffold="{}", file="robot.urdf", files=files("yard")),
    )

    @staticmethod
    def applies(part: Plugin | Root) -> bool:
        if isinstance(part, Plugin):
            return next(foreign(part), None) is not None
        found = part.launched_world
        return found is not None and found.wanted not in {"", found.name}

    def check(self, part: Plugin | Root) -> Iterator[Diagnostic]:
        if isinstance(part, Root):
            found = part.launched_world
            assert found is not None
            file = found.span.source.path.name
            words = f"in world `{found.wanted}`, and that of `{found.file}` is called `{found.name}`"
            yield self.diagnostic(
                part.element, f"`{file}` creates the robot {words}", labels={found.span: "created here"}
            )
            return
        plugin, world = part, part.within(World)
        assert world is not None
        for value, name in foreign(plugin):
            text = value.text.strip()
            message = f"`{text}` is of world `{name}`, and this is {world.title}"
            yield self.diagnostic(
                value, message, meant=text.replace(f"world/{name}/", f"world/{world.name}/", 1)
            )


def foreign(plugin: Plugin) -> Iterator[tuple[Value, str]]:
    """The parameters with a topic of a world that the file does not have, and the name of that world."""
    if plugin.within(World) is None:
        return
    worlds = {world.name for world in plugin.root.each(World)}
    for parameter in plugin.parameters:
        match = TOPIC.fullmatch(parameter.content) if not parameter.nodes else None
        if match is not None and match[1] not in worlds:
            yield parameter.own_value, match[1]

from collections.abc import Iterator

from sdfcheck import IN_WORLD, Bad, Diagnostic, Good, Plugin, Root, Rule, Severity, Span, World

MOST = 200
"""Plugins of a world that are looked at."""
PHYSICS = '<plugin filename="gz-sim-physics-system" name="gz::sim::systems::Physics"/>'
IMU = '<plugin filename="gz-sim-imu-system" name="gz::sim::systems::Imu"/>'
SENSORS = '<plugin filename="gz-sim-sensors-system" name="gz::sim::systems::Sensors"/>'
EYE = f'<model name="eye"><static>true</static><link name="l"/>{SENSORS}</model>'
LAUNCH = (
    'Node(package="ros_gz_sim", executable="create", arguments=["-file", "robot.urdf"])\n'
    'gz = {"gz_args": "-r yard.sdf"}\n'
)
STATES = (
    '<plugin filename="gz-sim-joint-state-publisher-system" name="gz::sim::systems::JointStatePublisher">'
)


class RepeatedSystem(Rule):
    """A system that may be there once is given again in the same world or model.

    Both run: sensors publish every message twice, physics moves everything twice, two controller
    managers drive the same joints, and of two systems for cameras and lidars each draws in a thread of its own, which
    crashes Gazebo. Systems of a world may not be in a model of it either, nor in a robot that a launch file creates
    there.
    """

    code = "RES017"
    name = "repeated-system"
    severity = Severity.WARNING
    remedy = """Remove one of the two plugins.

    Often a launch file or an included file brings the other one. Settings that differ have to be put
    together first.
    """
    looks_at = (Plugin,)
    scaffold = IN_WORLD

    bad = (
        Bad(
            f"{PHYSICS}{PHYSICS.replace('plugin ', '«plugin» ')}",
            says="plugin `gz::sim::systems::Physics` is given again in world `w`",
        ),
        Bad(
            f"{IMU}{IMU.replace('plugin ', '«plugin» ').replace('gz-sim-imu-system', 'libgz-sim-imu-system.so')}"
        ),
        Bad(
            SENSORS + EYE.replace("plugin ", "«plugin» "),
            says="plugin `gz::sim::systems::Sensors` is given again in model `eye`: world `w` has it",
        ),
        Bad(
            f'<robot name="r"><link name="base"/><gazebo>{SENSORS.replace("plugin ", "«plugin» ")}</gazebo></robot>',
            scaffold="{}",
            file="robot.urdf",
            files={
                "sim.launch.py": LAUNCH,
                "yard.sdf": f'<sdf version="1.9"><world name="yard">{SENSORS}</world></sdf>',
            },
            says="again in `gazebo`: world `yard` in `yard.sdf` has it, in which `sim.launch.py` creates it",
            also=("GAZ014",),
        ),
    )
    good = (
        Good(PHYSICS + IMU),
        Good(PHYSICS + EYE, why="the world leaves it to the model"),
        Good(
            '<gazebo><plugin name="a" filename="libgazebo_ros_control.so"><robotNamespace>/l</robotNamespace></plugin>'
            '<plugin name="b" filename="libgazebo_ros_control.so"><robotNamespace>/r</robotNamespace></plugin>'
            "</gazebo>",
            scaffold='<robot name="r"><link name="base"/>{}</robot>',
            why="one for each arm",
        ),
        Good(
            f'<model name="m"><link name="l"/>{STATES}</plugin>{STATES}<topic>steering</topic></plugin></model>',
            why="on topics of their own",
        ),
    )

    @staticmethod
    def applies(plugin: Plugin) -> bool:
        return (
            plugin.known is not None and plugin.known.once != "" and next(earlier(plugin), None) is not None
        )

    def check(self, plugin: Plugin) -> Iterator[Diagnostic]:
        assert plugin.holder is not None
        for other, words in earlier(plugin):
            message = f"{plugin.title} is given again in {plugin.holder.title}{words}"
            yield self.diagnostic(plugin, message, labels={other: "the first one"})
            return


def earlier(plugin: Plugin) -> Iterator[tuple[Plugin | Span, str]]:
    """The places of the same system beside it and in its world, each with more words about it."""
    beside, world, root = first(plugin), plugin.within(World), plugin.root
    created = root.launched_world if isinstance(root, Root) else None
    if plugin.holder is None or plugin.known is None:
        return
    if beside is not None:
        yield beside, ""
    if plugin.known.once != "world" or plugin.holder is world:
        return
    if world is not None:
        for other in world.plugins[:MOST]:
            if other.known == plugin.known:
                yield other, f": {world.title} has it"
    elif created is not None and plugin.known.file in map("gz-sim-{}-system".format, created.systems):
        where = f"world `{created.name}` in `{created.file}`"
        yield created.span, f": {where} has it, in which `{created.span.source.path.name}` creates it"


def first(plugin: Plugin) -> Plugin | None:
    """The first plugin of the same library beside it, with the same parameters that tell them apart."""
    for sibling in plugin.siblings:
        if sibling is plugin:
            return None
        if sibling.known == plugin.known and distinction(sibling) == distinction(plugin):
            return sibling
    return None


def distinction(plugin: Plugin) -> tuple[str | None, ...]:
    texts = (plugin.get("robotNamespace"), plugin.get("namespace"), plugin.get("controller_manager_name"))
    return (*texts, plugin.get("ros/namespace"), plugin.get("topic"))

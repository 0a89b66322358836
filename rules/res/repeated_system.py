from collections.abc import Iterator

from sdfcheck import IN_WORLD, Bad, Diagnostic, Good, Plugin, Rule, Severity

PHYSICS = '<plugin filename="gz-sim-physics-system" name="gz::sim::systems::Physics"/>'
IMU = '<plugin filename="gz-sim-imu-system" name="gz::sim::systems::Imu"/>'
STATES = (
    '<plugin filename="gz-sim-joint-state-publisher-system" name="gz::sim::systems::JointStatePublisher">'
)


class RepeatedSystem(Rule):
    """A system that may be there once is given again in the same world or model.

    Both run: sensors publish every message twice, physics moves everything twice, two controller
    managers drive the same joints.
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
    )
    good = (
        Good(PHYSICS + IMU),
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
        return plugin.known is not None and plugin.known.once != "" and first(plugin) is not None

    def check(self, plugin: Plugin) -> Iterator[Diagnostic]:
        earlier, holder = first(plugin), plugin.holder
        assert holder is not None
        if earlier is not None:
            message = f"{plugin.title} is given again in {holder.title}"
            yield self.diagnostic(plugin, message, labels={earlier: "the first one"})


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

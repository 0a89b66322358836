import re
from collections.abc import Iterator

from sdfcheck import SDF, Bad, Diagnostic, Good, Plugin, Rule, Severity, Value, World

TOPIC = re.compile(r"/?world/([^/\s{}$]+)/\S*")
WORLD = (
    '<world name="yard"><gui><plugin filename="WorldControl" name="World control"><service>{}</service></plugin></gui>'
    "</world>"
)


class UnknownWorldTopic(Rule):
    """A plugin of a world names a topic or service of another world.

    Topics and services of a world of Gazebo begin with `/world/` and its name. Nobody publishes on those of a world
    that is not there: a button does nothing, a display stays empty.
    """

    code = "RES023"
    name = "unknown-world-topic"
    severity = Severity.WARNING
    remedy = """Write the name of this world in the topic.

    A world that is renamed changes all its topics. A launch file that passes the name on, or a topic
    without `/world/NAME`, avoids the coupling.
    """
    looks_at = (Plugin,)
    needs = ("world/",)
    scaffold = SDF

    bad = (
        Bad(
            WORLD.format("«/world/field/control»"),
            fixed=WORLD.format("/world/yard/control"),
            unsafe=True,
            says="`/world/field/control` is of world `field`, and this is world `yard`",
        ),
    )
    good = (Good(WORLD.format("/world/yard/control")), Good(WORLD.format("/clock"), why="of no world"))

    @staticmethod
    def applies(plugin: Plugin) -> bool:
        return next(foreign(plugin), None) is not None

    def check(self, plugin: Plugin) -> Iterator[Diagnostic]:
        world = plugin.within(World)
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

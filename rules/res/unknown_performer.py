from collections.abc import Iterator

from sdfcheck import IN_WORLD, Bad, Diagnostic, Good, Plugin, Rule, Severity, Value, World

LEVELS = (
    '<plugin name="gz::sim" filename="dummy"><performer name="one"><ref>{}</ref>'
    "<geometry><box><size>1 1 1</size></box></geometry></performer></plugin>"
)
ROBOT = '<model name="robot"><link name="l"/></model>'


class UnknownPerformer(Rule):
    """A performer names a model or actor that its world does not have.

    Gazebo loads the levels of a world around performers. It reports an error for this one, and does not
    load levels around it.
    """

    code = "RES020"
    name = "unknown-performer"
    severity = Severity.WARNING
    remedy = """Name a model or actor of the world, as its `name` says.

    For a model that is included, that is the `<name>` of the include, if it has one.
    """
    preview = True
    looks_at = (Plugin,)
    needs = ("<performer",)
    scaffold = IN_WORLD
    sources = ("https://gazebosim.org/api/sim/8/levels.html",)

    bad = (
        Bad(
            ROBOT + LEVELS.format("«robbot»"),
            fixed=ROBOT + LEVELS.format("robot"),
            unsafe=True,
            says="performer `one` refers to `robbot`, which is not a model or actor of world `w`; "
            "did you mean `robot`?",
        ),
    )
    good = (
        Good(ROBOT + LEVELS.format("robot")),
        Good(
            LEVELS.format("robot") + "<include><uri>model://not_here</uri></include>",
            why="an include that could not be read may have it",
        ),
    )

    @staticmethod
    def applies(plugin: Plugin) -> bool:
        return any(True for _ in unknown(plugin))

    def check(self, plugin: Plugin) -> Iterator[Diagnostic]:
        for value, world in unknown(plugin):
            performer, name = value.element.parent, value.text.strip()
            assert performer is not None
            message = f"{performer.title} refers to `{name}`, which is not a model or actor of {world.title}"
            yield self.diagnostic(value, message, meant=world.guess(name, kind="model").meant)


def unknown(plugin: Plugin) -> Iterator[tuple[Value, World]]:
    """The references of performers to nothing, each with its world."""
    world = plugin.holder
    if not isinstance(world, World) or plugin.name not in {"gz::sim", "ignition::gazebo"}:
        return
    actors = {actor.name for actor in world.actors}
    for performer in plugin.children("performer"):
        reference = performer.find("ref")
        name = "" if reference is None else reference.content
        if reference is None or not name or "$" in name or name in actors:
            continue
        node = world.resolve(name)
        if (node is None or node.kind != "model") and not world.may_hold(name):
            yield reference.own_value, world

from collections.abc import Iterator

from sdfcheck import IN_WORLD, Bad, Diagnostic, Element, Good, Rule, Severity, World

SCENE, MANAGER, OLD = "MinimalScene", "GzSceneManager", "GzScene3D"
BROADCASTER = "scene-broadcaster"
GUI = '<gui>{}<plugin filename="WorldControl" name="c"><gz-gui/></plugin></gui>'
VIEW = f'<plugin filename="{SCENE}" name="v"/>'
MANAGED = f'{VIEW}<plugin filename="{MANAGER}" name="m"/>'
PHYSICS = '<plugin filename="gz-sim-physics-system" name="gz::sim::systems::Physics"/>'
SENDER = '<plugin filename="gz-sim-scene-broadcaster-system" name="gz::sim::systems::SceneBroadcaster"/>'


class EmptyWindow(Rule):
    """The window of Gazebo shows nothing of a world, by what the world lists.

    A `<gui>` with plugins has these alone before gz-sim 9: without `MinimalScene` there is no view, and without
    `GzSceneManager` nothing is in it. So it is with systems: the window gets what it shows from the scene broadcaster,
    which is missing where others are listed without it. `GzScene3D` has gone with Garden, which is a warning where the
    world is for Garden or newer.
    """

    code = "SCH042"
    name = "empty-window"
    severity = Severity.INFO
    remedy = """Add what is missing, or remove the list, so that Gazebo takes its own.

    A view is a plugin with the file name `MinimalScene`, and what is in it one with `GzSceneManager`; the broadcaster
    is `gz-sim-scene-broadcaster-system`. For a world that runs without window, ignore this finding.
    """
    looks_at = (World,)
    needs = ("<plugin",)
    scaffold = IN_WORLD
    sources = ("https://gazebosim.org/api/sim/8/gui_config.html",)

    bad = (
        Bad(
            GUI.format("").replace("gui>", "«gui»>", 1),
            says="the window lists its plugins without `MinimalScene`: before gz-sim 9 it has no view",
        ),
        Bad(
            GUI.format(VIEW.replace(SCENE, f"«{SCENE}»")),
            says="`MinimalScene` has no `GzSceneManager` beside it: before gz-sim 9 nothing is in the view",
        ),
        Bad(
            PHYSICS + SENDER + GUI.format(VIEW.replace(SCENE, f"«{OLD}»")),
            says="`GzScene3D` is not there from Garden on: use `MinimalScene` and `GzSceneManager`",
        ),
        Bad(
            PHYSICS.replace("plugin", "«plugin»", 1),
            says="systems are listed without the scene broadcaster: before gz-sim 9 the window stays empty",
        ),
    )
    good = (
        Good(PHYSICS + SENDER + GUI.format(MANAGED)),
        Good("<gui><camera name='c'/></gui>", why="Gazebo brings its own plugins"),
        Good('<gui><plugin filename="libclock.so" name="c"/></gui>', why="a plugin of Gazebo Classic"),
        Good(GUI.format(VIEW.replace(SCENE, OLD)), why="for Fortress, as far as one sees"),
    )

    @staticmethod
    def applies(world: World) -> bool:
        return next(gaps(world), None) is not None

    def check(self, world: World) -> Iterator[Diagnostic]:
        for element, value, message in gaps(world):
            place = element if value is None else (element.attribute(value) or element)
            severity = Severity.WARNING if OLD in message else None
            yield self.diagnostic(place, message, severity=severity)


def gaps(world: World) -> Iterator[tuple[Element, str | None, str]]:
    """The reasons for an empty window: the element, the attribute to point at, and the words."""
    systems = [
        plugin for plugin in world.plugins if "gz-sim" in plugin.filename or "ignition" in plugin.filename
    ]
    files = [plugin.filename for plugin in world.root.each(type(systems[0]))] if systems else []
    if any("physics" in file for file in files) and not any(BROADCASTER in file for file in files):
        words = "systems are listed without the scene broadcaster: before gz-sim 9 the window stays empty"
        yield systems[0].element, None, words
    gui = world.find("gui")
    plugins = {each.attributes.get("filename", ""): each for each in gui.children("plugin")} if gui else {}
    if gui is None or not any(each.has("gz-gui") or each.has("ignition-gui") for each in plugins.values()):
        return
    scenes = [file for file in plugins if SCENE in file or "Scene3D" in file]
    first = scenes[0] if scenes else ""
    if not scenes:
        yield gui, None, f"the window lists its plugins without `{SCENE}`: before gz-sim 9 it has no view"
    elif OLD in first and any("gz-sim" in plugin.filename for plugin in systems):
        words = f"`{OLD}` is not there from Garden on: use `{SCENE}` and `{MANAGER}`"
        yield plugins[first], "filename", words
    elif SCENE in first and not any(MANAGER in file for file in plugins):
        words = f"`{SCENE}` has no `{MANAGER}` beside it: before gz-sim 9 nothing is in the view"
        yield plugins[first], "filename", words

from collections.abc import Iterator

from sdfcheck import Bad, Diagnostic, Element, Good, Model, Part, Rule, Severity, Shape, World

DEEP = 0.01
"""m; contacts give way less, and settle."""
MOST = 200
"""Models of a world that are looked at; of more than that most are rows of one."""
PLANE = (
    '<model name="ground"><static>true</static><link name="l"><collision name="c"><geometry><plane><normal>0 0 1'
    "</normal></plane></geometry></collision></link></model>"
)
WATER = '<plugin filename="gz-sim-buoyancy-system" name="gz::sim::systems::Buoyancy"/>'
STATE = '<state world_name="w"><model name="drone"><pose>0 0 0.1 0 0 0</pose></model></state>'
DRONE = (
    '<model name="drone"><pose>0 0 {} 0 0 0</pose>{}<link name="l"><{} name="c"><geometry><box><size>0.4 0.4 0.2</size>'
    "</box></geometry></{}></link></model>"
)


def drone(z: str, tag: str = "collision", more: str = "") -> str:
    """A ground, and a drone of 0.2 m above it."""
    return f'<sdf version="1.9"><world name="w">{PLANE}{DRONE.format(z, more, tag, tag.strip("«»"))}</world></sdf>'


class SunkenModel(Rule):
    """A model starts partly below the ground of its world.

    At the first step the contacts push it out: it jumps, tips over, or stays caught. Its pose places the origin of
    the model, which often is in the middle of its body. Planes that do not move count as the ground, and plain shapes
    of collisions as its feet. Left out are models that a joint ties to the world, those whose place a recorded state
    says, and worlds in which things float.
    """

    code = "GEO025"
    name = "sunken-model"
    severity = Severity.WARNING
    remedy = """Move the model up by its pose, until its lowest collision is on the ground.

    A few millimeters above are fine: it drops onto its feet.
    """
    looks_at = (World,)
    scaffold = "{}"

    bad = (
        Bad(
            drone("0").replace("<pose>0 0 0 0 0 0<", "<pose>«0 0 0 0 0 0»<"),
            says="model `drone` starts 100 mm deep in the ground",
        ),
    )
    good = (
        Good(drone("0.1")),
        Good(drone("0.095"), why="5 mm"),
        Good(drone("0", more="<static>true</static>"), why="a foundation"),
        Good(drone("0", "visual"), why="nothing touches the ground"),
        Good(drone("0").replace(PLANE, WATER + PLANE), why="a boat"),
        Good(
            drone("0").replace(PLANE, STATE + PLANE),
            why="Gazebo Classic takes the pose of the recorded state",
        ),
    )

    @staticmethod
    def applies(world: World) -> bool:
        return next(sunken(world), None) is not None

    def check(self, world: World) -> Iterator[Diagnostic]:
        for model, shape, depth in sunken(world):
            start: Part | Element = model if model.include is None else model.include
            pose = start.find("pose")
            target = start if pose is None or not pose.content else pose.own_value
            deep = f"{depth:.3g} m" if depth >= 1 else f"{depth * 1000:.3g} mm"
            message = f"{model.title} starts {deep} deep in the ground"
            labels, cause = {shape: "its lowest collision"}, model.misnamed("pose")
            yield self.diagnostic(target, message, labels=labels, cause=cause)


def sunken(world: World) -> Iterator[tuple[Model, Shape, float]]:
    """The models that begin below the ground, their lowest shapes and how deep those are (m)."""
    has_water = any("buoyancy" in plugin.filename for plugin in world.plugins)
    floor = world.floor if len(world.models) < MOST and not has_water else None
    recorded = {
        each.get("name") for state in world.element.children("state") for each in state.children("model")
    }
    for model in world.models if floor is not None else ():
        is_held = model.may_be_static or any(joint.parent_name == "world" for joint in model.joints)
        lowest = None if is_held or model.name in recorded else model.lowest
        if floor is not None and lowest is not None and lowest[1] < floor - DEEP:
            yield model, lowest[0], floor - lowest[1]

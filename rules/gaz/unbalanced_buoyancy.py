from collections.abc import Iterator

from sdfcheck import IN_WORLD, Bad, Diagnostic, Element, Good, Model, Part, Plugin, Rule, Severity, World

BUOYANCY, HYDRODYNAMICS = "gz-sim-buoyancy-system", "gz-sim-hydrodynamics-system"
WATER = 1000.0
"""kg/m³, which Gazebo takes where no density is written."""
MOST = 1.25
"""Of the weight: real vehicles are trimmed to a few percent."""
SEA = (
    f'<plugin filename="{BUOYANCY}" name="gz::sim::systems::Buoyancy">'
    "<uniform_fluid_density>1000</uniform_fluid_density></plugin>"
)
SUBMARINE = (
    '<model name="auv"><pose>0 0 -5 0 0 0</pose><link name="hull"><inertial><mass>{}</mass><inertia>'
    "<ixx>0.09</ixx><iyy>1.5</iyy>"
    '<izz>1.55</izz></inertia></inertial><collision name="c"><geometry><box>'
    "<size>1 0.2 0.1</size></box></geometry></collision></link>"
    f'<plugin filename="{HYDRODYNAMICS}" name="gz::sim::systems::Hydrodynamics"><link_name>hull</link_name></plugin>'
    "</model>"
)


def submarine(mass: str) -> str:
    """A vehicle of 20 liters under water."""
    return SEA + SUBMARINE.format(mass)


class UnbalancedBuoyancy(Rule):
    """A vehicle under water is far heavier or lighter than the water that it displaces.

    Water of one density has no surface: what is lighter rises without end, and what is heavier sinks. Buoyancy goes by
    the volume of the collisions, so that a box around a hull lifts more than the hull. Looked at are models with
    hydrodynamics in a world of uniform density, whose collisions are plain shapes; of those that are too light the ones
    that start below a height of 0, for others may be boats.
    """

    code = "GAZ034"
    name = "unbalanced-buoyancy"
    severity = Severity.WARNING
    remedy = """Change the mass, or the size of the collisions, until both agree to a percent.

    The mass that floats is the volume of all collisions times the density: 1 liter is 1 kg of water. A collision that
    is there for the buoyancy alone may be anywhere in the link, best above the center of mass.
    """
    looks_at = (Plugin,)
    needs = ("hydrodynamics-system",)
    scaffold = IN_WORLD

    bad = (
        Bad(
            submarine("«5»"),
            says="model `auv` weighs 5 kg and displaces 20 kg of water: it rises without end",
        ),
        Bad(submarine("«40»"), says="model `auv` weighs 40 kg and displaces 20 kg of water: it sinks"),
    )
    good = (
        Good(submarine("20")),
        Good(
            submarine("5").replace("uniform_fluid_density", "graded_buoyancy"), why="it floats at the surface"
        ),
        Good(submarine("5").replace("0 0 -5", "0 0 0"), why="a boat"),
    )

    @staticmethod
    def applies(plugin: Plugin) -> bool:
        return balance(plugin) is not None

    def check(self, plugin: Plugin) -> Iterator[Diagnostic]:
        found, model = balance(plugin), plugin.within(Model)
        assert found is not None
        assert model is not None
        mass, displaced = found
        way = "it rises without end" if displaced > mass else "it sinks"
        heaviest = max(model.links, key=lambda link: link.inertial.mass.number)
        message = f"{model.title} weighs {mass:.4g} kg and displaces {displaced:.4g} kg of water: {way}"
        yield self.diagnostic(heaviest.inertial.mass, message, labels={plugin: "moves in water"})


def balance(plugin: Plugin) -> tuple[float, float] | None:
    """The masses of a vehicle and of the water that it displaces (kg), where these differ much; of the first plugin."""
    model, world = plugin.within(Model), plugin.within(World)
    if model is None or world is None or plugin.known is None or plugin.known.file != HYDRODYNAMICS:
        return None
    density = fluid(world)
    shapes = [shape for link in model.links for shape in link.collisions]
    volumes = [shape.geometry.solid.volume for shape in shapes if shape.geometry.solid is not None]
    is_known = len(volumes) == len(shapes) > 0 and not model.models and not model.may_be_static
    if not density or not is_known or any(each.name == plugin.name for each in earlier(plugin)):
        return None
    mass = sum(link.inertial.mass.number for link in model.links)
    displaced = density * sum(volumes)
    if not mass > 0 or mass / MOST <= displaced <= mass * MOST or (displaced > mass and not dives(model)):
        return None
    return mass, displaced


def dives(model: Model) -> bool:
    """Does it start below a height of 0?"""
    start: Part | Element = model if model.include is None else model.include
    pose = start.find("pose")
    heights = pose.content.split()[2:3] if pose is not None else []
    return any(height.startswith("-") for height in heights)


def earlier(plugin: Plugin) -> Iterator[Plugin]:
    """The plugins before it in its model."""
    for each in plugin.siblings:
        if each.element is plugin.element:
            return
        yield each


def fluid(world: World) -> float:
    """The density of the water of a world (kg/m³), 0 where it has none of one density everywhere."""
    for plugin in world.plugins:
        if (
            plugin.known is not None
            and plugin.known.file == BUOYANCY
            and plugin.find("graded_buoyancy") is None
        ):
            given = plugin.find("uniform_fluid_density")
            return WATER if given is None else given.own_value.number
    return 0.0

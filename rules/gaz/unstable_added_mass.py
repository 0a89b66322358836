from collections.abc import Iterator

from sdfcheck import IN_MODEL, Bad, Diagnostic, Element, Good, Link, Plugin, Rule, Severity

HYDRODYNAMICS = "gz-sim-hydrodynamics-system"
ALONG = ("xDotU", "yDotV", "zDotW")
DIAGONAL = (*ALONG, "kDotP", "mDotQ", "nDotR")
HULL = (
    '<link name="l"><inertial><mass>25</mass><inertia><ixx>1</ixx><iyy>1</iyy><izz>1</izz></inertia>'
    "{}</inertial></link>"
)
IN_WATER = (
    f'<plugin filename="{HYDRODYNAMICS}" name="gz::sim::systems::Hydrodynamics"><link_name>l</link_name>'
    "{}<xU>-2</xU></plugin>"
)
MOVED = "<fluid_added_mass><xx>9</xx><yy>9</yy><zz>26</zz></fluid_added_mass>"


class UnstableAddedMass(Rule):
    """The water that moves along with a vehicle weighs more than the vehicle, or is counted twice.

    The system for hydrodynamics applies added mass as a force, by the acceleration of the step before. Where that mass
    is greater than the one that is accelerated, the force grows with each step, until the vehicle is infinitely far
    away. `<fluid_added_mass>` of the link, which the physics solves with the other masses, is stable with any number;
    beside it the system adds the force once more, and Gazebo reports an error.
    """

    code = "GAZ043"
    name = "unstable-added-mass"
    severity = Severity.WARNING
    remedy = """Write added mass as `<fluid_added_mass>` in the `<inertial>` of the link, without the minus signs.

    `xx` is `-xDotU`, `yy` is `-yDotV`, `zz` is `-zDotW`, `pp` is `-kDotP`, `qq` is `-mDotQ` and `rr` is `-nDotR`. Take
    these out of the plugin, or set `<disable_added_mass>true</disable_added_mass>` there.
    """
    looks_at = (Plugin,)
    needs = ("hydrodynamics-system",)
    scaffold = IN_MODEL
    sources = ("https://github.com/gazebosim/gz-sim/tree/main/src/systems/hydrodynamics",)

    bad = (
        Bad(
            HULL.format("") + IN_WATER.format("<xDotU>-9</xDotU><zDotW>«-30»</zDotW>"),
            says="`zDotW` is -30 kg, and model `m` weighs 26 kg: the force of the added mass grows with each step",
        ),
        Bad(
            HULL.format(MOVED) + IN_WATER.format("<xDotU>«-9»</xDotU>"),
            says="`xDotU` is added to the `fluid_added_mass` of link `l`: the water is counted twice",
        ),
    )
    good = (
        Good(HULL.format("") + IN_WATER.format("<zDotW>-20</zDotW>")),
        Good(HULL.format(MOVED) + IN_WATER.format("<zDotW>0</zDotW>")),
        Good(
            HULL.format(MOVED)
            + IN_WATER.format("<zDotW>-26</zDotW><disable_added_mass>true</disable_added_mass>"),
            why="there it is off",
        ),
    )

    @staticmethod
    def applies(plugin: Plugin) -> bool:
        return added(plugin) is not None

    def check(self, plugin: Plugin) -> Iterator[Diagnostic]:
        found = added(plugin)
        assert found is not None
        parameter, link, mass = found
        value = parameter.own_value
        what, then = f"is added to the `fluid_added_mass` of {link.title}", "the water is counted twice"
        if mass:
            what = f"is {value.text.strip()} kg, and {link.model.title} weighs {mass:.4g} kg"
            then = "the force of the added mass grows with each step"
        message = f"`{parameter.name}` {what}: {then}"
        yield self.diagnostic(value, message)


def added(plugin: Plugin) -> tuple[Element, Link, float] | None:
    """The first added mass that is too much, its link, and the mass of its model (kg); 0 if counted twice."""
    if (
        plugin.known is None
        or plugin.known.file != HYDRODYNAMICS
        or (plugin.get("disable_added_mass") or "").strip() in {"true", "1"}
    ):
        return None
    link = next((each.node for each in plugin.references if isinstance(each.node, Link)), None)
    given = [each for name in DIAGONAL if (each := plugin.find(name)) is not None and each.own_value.number]
    if link is None or not given:
        return None
    if link.inertial.has("fluid_added_mass"):
        return given[0], link, 0.0
    mass = sum(each.inertial.mass.number for each in link.model.links)
    heavy = (each for each in given if each.name in ALONG and abs(each.own_value.number) > mass > 0)
    return next(((each, link, mass) for each in heavy if not link.model.models), None)

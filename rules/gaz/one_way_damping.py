from collections.abc import Iterator

from sdfcheck import IN_MODEL, Bad, Diagnostic, Element, Good, Plugin, Rule, Severity

HYDRODYNAMICS = "gz-sim-hydrodynamics-system"
OWN_AXES = {
    f"{force}{speed}{speed}": f"{force}{speed}abs{speed}"
    for force, speed in zip("xyzkmn", "UVWPQR", strict=True)
}
"""The name of the force along an axis by the square of the speed along it, and that by the speed times its amount."""
DAMPED = (
    f'<plugin filename="{HYDRODYNAMICS}" name="gz::sim::systems::Hydrodynamics"><link_name>l</link_name>'
    "<xU>-2</xU>{}</plugin>"
)
HULL = '<link name="l"/>'


class OneWayDamping(Rule):
    """The damping of a vehicle under water is the same in both directions, so that it pushes in one of them.

    `xUU` is multiplied by the square of the speed, which has no sign: a force of -6 u² brakes forward and pushes
    backward, ever faster. `xUabsU` is multiplied by the speed and its amount, and always brakes. Gazebo Fortress made
    no difference at first, and files of that time are still copied. Terms of other axes, such as the lift `zUU`, may be
    meant.
    """

    code = "GAZ037"
    name = "one-way-damping"
    severity = Severity.WARNING
    remedy = (
        """Rename the element: `xUabsU` for `xUU`, and likewise along and about each axis. The value stays."""
    )
    looks_at = (Plugin,)
    needs = ("hydrodynamics-system",)
    scaffold = IN_MODEL

    bad = (
        Bad(
            HULL + DAMPED.format("<«xUU»>-6</xUU>"),
            says="`xUU` pushes backward as much as it brakes forward; `xUabsU` brakes both",
        ),
        Bad(
            HULL + DAMPED.format("<«kPP»>-6</kPP><nRR>-3</nRR>"),
            says="`kPP` pushes backward as much as it brakes forward; `kPabsP` brakes both (and 1 more)",
        ),
    )
    good = (
        Good(HULL + DAMPED.format("<xUabsU>-6</xUabsU>")),
        Good(HULL + DAMPED.format("<xUU>0</xUU>")),
        Good(HULL + DAMPED.format("<xUU>-1</xUU><xUabsU>-6</xUabsU>"), why="a hull that differs at its ends"),
        Good(HULL + DAMPED.format("<zUU>-6</zUU>"), why="lift"),
    )

    @staticmethod
    def applies(plugin: Plugin) -> bool:
        return bool(one_way(plugin))

    def check(self, plugin: Plugin) -> Iterator[Diagnostic]:
        found = one_way(plugin)
        name = found[0].name
        more = f" (and {len(found) - 1} more)" * (len(found) > 1)
        message = (
            f"`{name}` pushes backward as much as it brakes forward; `{OWN_AXES[name]}` brakes both{more}"
        )
        yield self.diagnostic(found[0], message)


def one_way(plugin: Plugin) -> list[Element]:
    """The terms of its damping that are the same for both directions, without one that is not."""
    if plugin.known is None or plugin.known.file != HYDRODYNAMICS:
        return []
    return [
        each
        for name, always in OWN_AXES.items()
        if (each := plugin.find(name)) is not None
        and abs(each.own_value.number) > 0
        and plugin.find(always) is None
    ]

from collections.abc import Iterator
from math import inf

from sdfcheck import IN_WORLD, Bad, Diagnostic, Good, Physics, Rule, Severity, Value, World

MOST = 0.15
"""Of the factor that is written: a rate of 900 in the place of 1000 is meant."""
PHYSICS = (
    '<physics type="ode"><max_step_size>0.002</max_step_size><real_time_factor>{}</real_time_factor>'
    "<real_time_update_rate>{}</real_time_update_rate></physics>"
)


class UnreachedPace(Rule):
    """Physics may not take as many steps in a second as the pace of the world needs.

    Gazebo Classic takes `real_time_update_rate` steps of `max_step_size` in a second, and does not use
    `real_time_factor`: 250 steps of 0.002 s are half of real time. The new Gazebo goes by the factor.
    """

    code = "SCH036"
    name = "unreached-pace"
    severity = Severity.WARNING
    remedy = """Write a rate of `real_time_factor` divided by `max_step_size`.

    That is 1000 for steps of 0.001 s, 500 for 0.002 s and 250 for 0.004 s. If the other pace is meant, write it as
    `real_time_factor`.
    """
    looks_at = (Physics,)
    needs = ("real_time_update_rate",)
    scaffold = IN_WORLD

    bad = (
        Bad(
            PHYSICS.format("1", "«250»"),
            says="250 steps of 0.002 s in a second are 0.5 times real time, and `real_time_factor` is 1",
        ),
    )
    good = (
        Good(PHYSICS.format("1", "500")),
        Good(PHYSICS.format("0.5", "250"), why="slow motion"),
        Good(PHYSICS.format("1", "250"), file="slow.world", why="the file says it"),
        Good(PHYSICS.format("1", "450"), why="nearly real time"),
        Good(PHYSICS.format("1", "0"), why="as fast as it can"),
        Good(PHYSICS.format("1", "5000"), why="faster, if the computer can"),
        Good(
            '<plugin filename="gz-sim-physics-system" name="gz::sim::systems::Physics"/>'
            + PHYSICS.format("1", "250"),
            why="the new Gazebo goes by the factor",
        ),
    )

    @staticmethod
    def applies(physics: Physics) -> bool:
        return pace(physics) is not None

    def check(self, physics: Physics) -> Iterator[Diagnostic]:
        found = pace(physics)
        assert found is not None, "it was worked out"
        rate, times = found
        step, factor = physics.max_step_size.text, physics.real_time_factor
        message = f"{rate.text.strip()} steps of {step} s in a second are {times:.3g} times real time"
        yield self.diagnostic(
            rate, f"{message}, and `real_time_factor` is {factor.text}", labels={factor: "the factor"}
        )


def pace(physics: Physics) -> tuple[Value, float] | None:
    """The rate of steps, and the pace that comes of it, if that is less than the one that is written."""
    element, world = physics.find("real_time_update_rate"), physics.within(World)
    step, factor = physics.max_step_size, physics.real_time_factor
    if element is None or not step.is_given or not factor.is_given:
        return None
    if (
        "slow" in physics.document.path.stem
        or world is None
        or any(plugin.generation == "gz" for plugin in world.plugins)
    ):
        return None
    value = element.own_value
    times = step.number * value.number
    is_slow = 0 < times < (1 - MOST) * factor.number < inf
    return (value, times) if is_slow else None

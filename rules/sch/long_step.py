from collections.abc import Iterator
from math import inf

from sdfcheck import IN_WORLD, Bad, Diagnostic, Good, Physics, Rule, Sensor, Severity, World

MOST = 0.5
"""s: from here on nothing moves as in the world any more."""
ROUNDED = 1.001
IMU = (
    '<model name="m"><link name="l"><sensor name="i" type="imu"><update_rate>1000</update_rate></sensor></link>'
    "</model>"
)


class LongStep(Rule):
    """Physics takes steps of half a second or more, or longer ones than a sensor waits between two reports.

    `max_step_size` is in seconds, and 0.001 is usual. In half a second a thing falls more than a meter
    between two looks at what it touches. Such a number was most likely meant in milliseconds, or as a rate. A sensor
    reports once a step at most, whatever its `update_rate` says.
    """

    code = "SCH026"
    name = "long-step"
    severity = Severity.WARNING
    remedy = """Write the step in seconds: `0.001` is usual, `0.004` if speed counts.

    `real_time_update_rate` × step is how fast the simulation may run: 1000 × 0.001 is real time. Steps
    above 0.01 s make contacts and fast joints unstable.
    """
    looks_at = (Physics,)
    scaffold = IN_WORLD

    bad = (
        Bad(
            '<physics type="ode"><max_step_size>«1»</max_step_size></physics>',
            says="a step of 1 s is too long for physics",
        ),
        Bad(
            '<physics type="ode"><max_step_size>«0.02»</max_step_size></physics>' + IMU,
            says="with steps of 0.02 s no sensor reports 1000 times in a second",
        ),
    )
    good = (
        Good('<physics type="ode"><max_step_size>0.001</max_step_size></physics>' + IMU),
        Good('<physics type="ode"><max_step_size>0.004</max_step_size></physics>'),
    )

    @staticmethod
    def applies(physics: Physics) -> bool:
        return MOST <= physics.max_step_size.number < inf or hurried(physics) is not None

    def check(self, physics: Physics) -> Iterator[Diagnostic]:
        step, sensor = physics.max_step_size, hurried(physics)
        if sensor is None or step.number >= MOST:
            yield self.diagnostic(step, f"a step of {step.text} s is too long for physics")
            return
        text = f"with steps of {step.text} s no sensor reports {sensor.update_rate.text} times in a second"
        yield self.diagnostic(step, text, labels={sensor.update_rate: f"{sensor.title} is to"})


def hurried(physics: Physics) -> Sensor | None:
    """The first sensor of its world that is to report more often than physics steps."""
    step, world = physics.max_step_size, physics.within(World)
    if not step.is_given or not 0 < step.number < inf or world is None or len(world.physics) > 1:
        return None
    sensors = (
        each for each in physics.root.each(Sensor) if inf > each.update_rate.number * step.number > ROUNDED
    )
    return next((sensor for sensor in sensors if sensor.within(World) is world), None)

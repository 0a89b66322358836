from collections.abc import Iterator

from sdfcheck import IN_WORLD, Bad, Diagnostic, Good, Physics, Rule, Severity

MOST = 0.5
"""s: from here on nothing moves as in the world any more."""


class LongStep(Rule):
    """Physics takes steps of half a second or more.

    `max_step_size` is in seconds, and 0.001 is usual. In half a second a thing falls more than a meter
    between two looks at what it touches. Such a number was most likely meant in milliseconds, or as a rate.
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
    )
    good = (Good('<physics type="ode"><max_step_size>0.004</max_step_size></physics>'),)

    @staticmethod
    def applies(physics: Physics) -> bool:
        return physics.max_step_size.number >= MOST

    def check(self, physics: Physics) -> Iterator[Diagnostic]:
        step = physics.max_step_size
        yield self.diagnostic(step, f"a step of {step.text} s is too long for physics")

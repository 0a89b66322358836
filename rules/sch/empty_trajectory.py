from collections.abc import Iterator

from sdfcheck import IN_WORLD, Actor, Bad, Diagnostic, Element, Good, Rule, Severity

ACTOR = (
    '<actor name="walker"><skin><filename>https://example.org/walk.dae</filename></skin>'
    '<animation name="walk"><filename>https://example.org/walk.dae</filename></animation>'
    "<script>{}</script></actor>"
)


class EmptyTrajectory(Rule):
    """A trajectory of an actor has no waypoints.

    The actor stays where it is. An actor that is to play its animation on the spot needs no trajectory.
    """

    code = "SCH029"
    name = "empty-trajectory"
    severity = Severity.WARNING
    remedy = """Add waypoints, or remove the trajectory.

    Each has a `<time>` in seconds and a `<pose>`; at least two make a way.
    """
    preview = True
    looks_at = (Actor,)
    scaffold = IN_WORLD

    bad = (
        Bad(
            ACTOR.format('<«trajectory» id="0" type="walk"/>'),
            says="a trajectory of actor `walker` has no waypoints",
        ),
    )
    good = (Good(ACTOR.format("<loop>true</loop>"), why="on the spot"),)

    @staticmethod
    def applies(actor: Actor) -> bool:
        return any(map(is_empty, actor.trajectories))

    def check(self, actor: Actor) -> Iterator[Diagnostic]:
        for trajectory in filter(is_empty, actor.trajectories):
            yield self.diagnostic(trajectory, f"a trajectory of {actor.title} has no waypoints")


def is_empty(trajectory: Element) -> bool:
    return next(trajectory.children(), None) is None

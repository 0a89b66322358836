from collections.abc import Iterator
from itertools import pairwise

from sdfcheck import IN_WORLD, Actor, Bad, Diagnostic, Good, Rule, Severity, Value

ACTOR = (
    '<actor name="walker"><skin><filename>https://example.org/walk.dae</filename></skin>'
    '<animation name="walk"><filename>https://example.org/walk.dae</filename>'
    "<interpolate_x>true</interpolate_x></animation>"
    '<script><trajectory id="0" type="walk"><waypoint><time>{}</time><pose>0 0 0 0 0 0</pose></waypoint>'
    "<waypoint><time>{}</time><pose>2 0 0 0 0 0</pose></waypoint></trajectory></script></actor>"
)


class UnorderedWaypoints(Rule):
    """The time of a waypoint is not after that of the waypoint before it.

    Times count from the beginning of the trajectory, in seconds. Gazebo sorts the waypoints by them,
    and of two at one time one is lost, so that the actor takes another way.
    """

    code = "SCH028"
    name = "unordered-waypoints"
    severity = Severity.WARNING
    remedy = """Write the times in the order of the waypoints, each after the one before.

    They are seconds from the beginning of the trajectory, not durations. To wait somewhere, repeat the pose
    with a later time.
    """
    looks_at = (Actor,)
    scaffold = IN_WORLD

    bad = (
        Bad(ACTOR.format("3", "«2»"), says="time 2 is not after 3, that of the waypoint before"),
        Bad(ACTOR.format("2", "«2»"), says="time 2 is not after 2"),
    )
    good = (Good(ACTOR.format("0", "2.5")),)

    @staticmethod
    def applies(actor: Actor) -> bool:
        return any(disorder(actor))

    def check(self, actor: Actor) -> Iterator[Diagnostic]:
        for earlier, later in disorder(actor):
            message = (
                f"time {later.text.strip()} is not after {earlier.text.strip()}, that of the waypoint before"
            )
            yield self.diagnostic(later, message, labels={earlier: "the waypoint before"})


def disorder(actor: Actor) -> Iterator[tuple[Value, Value]]:
    """Times of successive waypoints that do not rise; of each trajectory the first."""
    for trajectory in actor.trajectories:
        written = (waypoint.value("time") for waypoint in trajectory.children("waypoint"))
        times = [value for value in written if value is not None]
        pairs = pairwise(times)
        found = next((pair for pair in pairs if pair[0].number >= pair[1].number), None)
        if found is not None:
            yield found

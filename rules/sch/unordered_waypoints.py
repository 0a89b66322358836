from collections.abc import Iterator
from itertools import pairwise
from math import dist
from operator import itemgetter

from sdfcheck import IN_WORLD, Actor, Bad, Diagnostic, Element, Good, Rule, Severity, Value

ACTOR = (
    '<actor name="walker"><skin><filename>https://example.org/walk.dae</filename></skin>'
    '<animation name="walk"><filename>https://example.org/walk.dae</filename>'
    "<interpolate_x>true</interpolate_x></animation>"
    '<script><trajectory id="0" type="walk"><waypoint><time>{}</time><pose>0 0 0 0 0 0</pose></waypoint>'
    "<waypoint><time>{}</time><pose>2 0 0 0 0 0</pose></waypoint></trajectory></script></actor>"
)
SAME = 1e-6
LATER = "".join(
    f"<waypoint><time>{time}</time><pose>{x} 0 0 0 0 0</pose></waypoint>"
    for time, x in ((2, 0.5), (6, 1.5), (4, 1.0))
)


class UnorderedWaypoints(Rule):
    """The time of a waypoint is not after that of the waypoint before it.

    Times count from the beginning of the trajectory, in seconds. Gazebo sorts the waypoints by them,
    and of two at one time one is lost, so that the actor takes another way. Waypoints that are written
    in another order and are one way when they are sorted, such as the way there and back together, are
    left alone.
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
    good = (
        Good(ACTOR.format("0", "2.5")),
        Good(
            ACTOR.replace("</waypoint></trajectory>", f"</waypoint>{LATER}</trajectory>").format("0", "8"),
            why="sorted, as Gazebo does, the steps are shorter: the order of the lines was not meant",
        ),
    )

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
        times = [time for time, _ in timed(trajectory)]
        falls = [pair for pair in pairwise(times) if pair[0].number >= pair[1].number]
        if falls and not (is_each_once(times) and is_one_way(trajectory, len(falls))):
            yield falls[0]


def timed(trajectory: Element) -> list[tuple[Value, Element]]:
    """The waypoints that have a time, with it."""
    waypoints = ((each.value("time"), each) for each in trajectory.children("waypoint"))
    return [(time, each) for time, each in waypoints if time is not None]


def is_each_once(times: list[Value]) -> bool:
    """Has each waypoint a time of its own? Gazebo counts milliseconds."""
    return len({round(time.number, 3) for time in times}) == len(times)


def is_one_way(trajectory: Element, falls: int) -> bool:
    """Is the longest step shorter once the waypoints are sorted, or as long where many are not in order?"""
    written = [(time.number, place(waypoint)) for time, waypoint in timed(trajectory)]
    if any(not where for _, where in written):
        return False
    there, then = (longest(each) for each in (written, sorted(written, key=itemgetter(0))))
    return then < there - SAME or (falls > 1 and then < there + SAME)


def longest(waypoints: list[tuple[float, tuple[float, ...]]]) -> float:
    """The longest way from a waypoint to the next, in meters."""
    return max((dist(one, other) for (_, one), (_, other) in pairwise(waypoints)), default=0.0)


def place(waypoint: Element) -> tuple[float, ...]:
    """Where it is; nothing if that is not three numbers."""
    pose = waypoint.value("pose")
    try:
        where = tuple(map(float, pose.text.split()[:3])) if pose is not None else ()
    except ValueError:
        return ()
    return where if len(where) == 3 else ()

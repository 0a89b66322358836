from collections.abc import Iterator
from itertools import pairwise
from math import dist
from operator import itemgetter

from sdfcheck import IN_WORLD, Actor, Bad, Diagnostic, Element, Good, Rule, Severity

ACTOR = (
    '<actor name="walker"><skin><filename>https://example.org/walk.dae</filename></skin>'
    '<{} name="walk"><filename>https://example.org/walk.dae</filename>{}</animation>'
    '<script><trajectory id="0" type="walk"><waypoint><time>0</time><pose>0 0 0 0 0 0</pose></waypoint>'
    "<waypoint><time>2</time><pose>{} 0 0 0 0 0</pose></waypoint></trajectory></script></actor>"
)


class SlidingActor(Rule):
    """An actor walks along a trajectory, and its steps are not fitted to the way.

    Without `interpolate_x` the animation plays at its own speed, however fast the trajectory carries the actor: its
    feet slide over the ground.
    """

    code = "SCH035"
    name = "sliding-actor"
    severity = Severity.WARNING
    remedy = """Add `<interpolate_x>true</interpolate_x>` to the animation.

    Gazebo then plays as much of it as the actor moves along its x axis. An animation that stays in its place, such as
    waving or sitting, needs a trajectory that stays there, too.
    """
    looks_at = (Actor,)
    scaffold = IN_WORLD

    bad = (
        Bad(
            ACTOR.format("«animation»", "", "2"),
            says="the steps of actor `walker` are not fitted to its way of 2 m",
        ),
    )
    good = (
        Good(ACTOR.format("animation", "<interpolate_x>true</interpolate_x>", "2")),
        Good(ACTOR.format("animation", "", "0"), why="it stays where it is"),
    )

    @staticmethod
    def applies(actor: Actor) -> bool:
        return any(True for _ in sliding(actor))

    def check(self, actor: Actor) -> Iterator[Diagnostic]:
        for animation, way in sliding(actor):
            yield self.diagnostic(
                animation, f"the steps of {actor.title} are not fitted to its way of {way:.3g} m"
            )


def sliding(actor: Actor) -> Iterator[tuple[Element, float]]:
    """The animations that play while a trajectory moves the actor, and how far it does."""
    for animation in actor.animations:
        name = animation.attributes.get("name", "").strip()
        flag = animation.value("interpolate_x")
        ways = [way(each) for each in actor.trajectories if each.attributes.get("type", "").strip() == name]
        if (
            name
            and (flag is None or flag.text.strip() not in {"1", "true"})
            and any(each > 0 for each in ways)
        ):
            yield animation, max(ways)


def way(trajectory: Element) -> float:
    """The length of a trajectory in the plane, in meters, in the order of the times; 0 where a pose is not numbers."""
    places = []
    for waypoint in trajectory.children("waypoint"):
        time, pose = waypoint.value("time"), waypoint.value("pose")
        words = pose.text.split() if pose is not None else []
        try:
            places.append((time.number if time is not None else 0.0, float(words[0]), float(words[1])))
        except (IndexError, ValueError):
            return 0.0
    places.sort(key=itemgetter(0))
    return sum(dist(one[1:], other[1:]) for one, other in pairwise(places))

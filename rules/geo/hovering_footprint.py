from collections.abc import Iterator
from math import dist

from sdfcheck import Bad, Diagnostic, Good, Joint, Link, Model, Rule, Severity
from sdfcheck_rules.geo.scaffolds import rover

FOOTPRINT = "base_footprint"
LEAST, SHARE = 0.005, 0.1
"""So far off (m, and of the radius of a wheel) does not count."""
TINY = 1e-6
LEVEL = 0.1
"""The z component of an axis that is level."""


def on_floor(z: str) -> str:
    """A robot with two wheels whose radius is 0.1 m, and its footprint."""
    joint = '<joint name="f" type="fixed"><parent link="base_footprint"/><child link="base"/>'
    joint += f'<origin xyz="0 0 {z}"/></joint>'
    return rover().replace('<link name="base"/>', f'<link name="base_footprint"/><link name="base"/>{joint}')


class HoveringFootprint(Rule):
    """The frame `base_footprint` of a robot on wheels is not on the floor.

    It is the projection of the robot onto the floor: navigation and filters of obstacles take its z = 0 for the
    ground, and a robot whose root it is hovers or sticks in the floor where it is put into a world. By its lowest
    wheels, which turn without end about level axes, the floor is elsewhere.
    """

    code = "GEO024"
    name = "hovering-footprint"
    severity = Severity.WARNING
    remedy = """Put `base_footprint` to where the wheels touch the floor.

    The origin of the joint between it and `base_link` is as high as the radius of a wheel, less the height of the axle
    in `base_link`.
    """
    looks_at = (Model,)
    needs = (FOOTPRINT,)
    scaffold = "{}"
    sources = ("https://www.ros.org/reps/rep-0120.html",)

    bad = (
        Bad(
            on_floor("0.125").replace('<link name="base_foot', '<«link» name="base_foot'),
            says="link `base_footprint` is 25 mm below the lowest points of the wheels",
        ),
    )
    good = (
        Good(on_floor("0.1")),
        Good(on_floor("0.105"), why="5 mm are within what wheels give way"),
        Good(
            on_floor("0").replace(
                '"base_footprint"/><child link="base"', '"base"/><child link="base_footprint"'
            ),
            why="another link is the root, and the robot is put into the world by that one",
        ),
    )

    @staticmethod
    def applies(model: Model) -> bool:
        return off_floor(model) is not None

    def check(self, model: Model) -> Iterator[Diagnostic]:
        found = off_floor(model)
        assert found is not None
        link, wheel, height = found
        where = "below" if height > 0 else "above"
        message = f"{link.title} is {abs(height) * 1000:.3g} mm {where} the lowest points of the wheels"
        yield self.diagnostic(link, message, labels={wheel: "turns one of them"})


def off_floor(model: Model) -> tuple[Link, Joint, float] | None:
    """The footprint of a robot, the joint of a wheel, and how far above the one the other ends (m), where not 0."""
    link = model.resolve(FOOTPRINT) if model.is_urdf else None
    if not isinstance(link, Link) or link.at_rest is None or link.shapes or link.parent_joints:
        return None
    floor = link.at_rest.position[2]
    ends = sorted(
        (joint.at_rest.position[2] - joint.wheel_radius - floor, number)
        for number, joint in enumerate(model.joints)
        if joint.at_rest is not None and rolls(joint)
    )
    low = [model.joints[number] for height, number in ends if height - ends[0][0] < LEAST]
    places = [joint.at_rest.position for joint in low if joint.at_rest is not None]
    if all(dist(places[0], place) < low[0].wheel_radius for place in places):
        return None
    height = min((height for height, _ in ends[: len(low)]), key=abs)
    least = max(LEAST, SHARE * low[0].wheel_radius)
    return (link, low[0], height) if abs(height) > least + TINY else None


def rolls(joint: Joint) -> bool:
    """Is it that of a wheel: does it turn something round without end about a level axis?"""
    if joint.type != "continuous" or joint.direction is None or not joint.wheel_radius > 0:
        return False
    return abs(joint.direction[2]) < LEVEL

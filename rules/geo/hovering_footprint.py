from collections.abc import Iterator
from math import isfinite

from sdfcheck import Bad, Diagnostic, Good, Link, Plugin, Rule, Severity
from sdfcheck_rules.geo.scaffolds import rover

FOOTPRINT = "base_footprint"
LEAST, SHARE = 0.005, 0.1
"""So far off (m, and of the radius of a wheel) does not count."""


def on_floor(z: str) -> str:
    """A robot with two wheels whose radius is 0.1 m, and its footprint."""
    joint = '<joint name="f" type="fixed"><parent link="base_footprint"/><child link="base"/>'
    joint += f'<origin xyz="0 0 {z}"/></joint>'
    return rover().replace('<link name="base"/>', f'<link name="base_footprint"/><link name="base"/>{joint}')


class HoveringFootprint(Rule):
    """The frame `base_footprint` of a robot on wheels is not on the floor.

    It is the projection of the robot onto the floor: navigation and filters of obstacles take its z = 0 for the
    ground, and a robot whose root it is hovers or sticks in the floor where it is put into a world. By the wheels of
    its drive the floor is elsewhere.
    """

    code = "GEO024"
    name = "hovering-footprint"
    severity = Severity.WARNING
    remedy = """Put `base_footprint` to where the wheels touch the floor.

    The origin of the joint between it and `base_link` is as high as the radius of a wheel, less the height of the axle
    in `base_link`.
    """
    looks_at = (Plugin,)
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
    def applies(plugin: Plugin) -> bool:
        return plugin.drive is not None and off_floor(plugin) is not None

    def check(self, plugin: Plugin) -> Iterator[Diagnostic]:
        found = off_floor(plugin)
        assert found is not None
        link, height = found
        where = "below" if height > 0 else "above"
        message = f"{link.title} is {abs(height) * 1000:.3g} mm {where} the lowest points of the wheels"
        yield self.diagnostic(link, message, labels={plugin: "this drive"})


def off_floor(plugin: Plugin) -> tuple[Link, float] | None:
    """The footprint of the robot of a drive, and how far above it the wheels end (m), where that is not 0."""
    drive = plugin.drive
    model = drive.left.joint.model if drive is not None else None
    link = model.resolve(FOOTPRINT) if model is not None else None
    if drive is None or not isinstance(link, Link) or link.at_rest is None or link.shapes:
        return None
    if not link.is_urdf or link.parent_joints:
        return None
    heights = [wheel.position[2] - wheel.radius - link.at_rest.position[2] for wheel in drive.wheels]
    if not all(map(isfinite, heights)) or max(heights) - min(heights) > LEAST:
        return None
    height = min(heights, key=abs)
    return (link, height) if abs(height) > max(LEAST, SHARE * drive.left.radius) else None

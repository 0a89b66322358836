from __future__ import annotations

import math
from collections.abc import Iterator
from typing import TYPE_CHECKING

from sdfcheck import Bad, Diagnostic, Good, Plugin, Rule, Severity
from sdfcheck_rules.geo.scaffolds import rover

if TYPE_CHECKING:
    from sdfcheck.robot.graph import Footing, Stance

MOST = math.radians(1.5)
"""Of 30 public robots that stand on wheels and casters of plain shapes, 17 stand level within 0.5°."""
MASS = (
    '<inertial>{}<mass value="{}"/><inertia ixx="{}" iyy="{}" izz="{}" ixy="0" ixz="0" iyz="0"/></inertial>'
)
BACK = '<origin xyz="-0.1 0 0"/>'
BODY = MASS.format(BACK, 5, 0.018, 0.105, 0.12)
BALL = '<{0}><geometry><sphere radius="{1}"/></geometry></{0}>'


def standing(shapes: str, z: str = "-0.05") -> str:
    """A robot with two wheels and a ball 0.3 m behind them."""
    body = f'<collision>{BACK}<geometry><box size="0.5 0.2 0.05"/></geometry></collision>'
    ball = (
        f'<link name="ball">{MASS.format("", 0.1, 0.0001, 0.0001, 0.0001)}{shapes}</link><joint name="k" type="fixed">'
        f'<origin xyz="-0.3 0 {z}"/><parent link="base"/><child link="ball"/></joint><gazebo>'
    )
    made = rover().replace('<link name="base"/>', f'<link name="root"/><link name="base">{BODY}{body}</link>')
    root = '<joint name="r" type="fixed"><parent link="root"/><child link="base"/></joint>'
    for side in ("left", "right"):
        wheel = f'<link name="{side}">'
        made = made.replace(wheel, wheel + MASS.format("", 0.5, 0.00132, 0.0025, 0.00132))
    return made.replace("<gazebo>", root + ball, 1)


class TiltedStand(Rule):
    """A robot on wheels does not stand level, or not on the wheels that drive it.

    A caster that is too high or too low tilts the robot: lidars scan the floor, and odometry is off. One without a
    collision sinks in until the body touches the floor. Two that are too low lift the drive, whose wheels spin in the
    air. Robots are looked at whose collisions near the floor are plain shapes, with all joints at zero; one that has
    nothing near the floor but its wheels balances on them, and is left out.
    """

    code = "GEO023"
    name = "tilted-stand"
    severity = Severity.WARNING
    remedy = """Move the caster until its lowest point is level with those of the wheels.

    A fixed sphere without friction stands for a caster: its center is as high above the floor as its radius. The
    collision counts, not the visual.
    """
    looks_at = (Plugin,)
    scaffold = "{}"

    bad = (
        Bad(
            standing(BALL.format("«collision»", "0.03").replace("</«collision»>", "</collision>")),
            says="the lowest point of link `ball` is 20 mm above those of the wheels: the robot stands tilted by 3.8°",
        ),
        Bad(
            standing(BALL.format("visual", "0.05")).replace('<link name="ball"', '<«link» name="ball"'),
            says="link `ball` has no collision: the robot stands tilted by",
        ),
    )
    good = (
        Good(standing(BALL.format("collision", "0.05"))),
        Good(standing(BALL.format("collision", "0.045")), why="5 mm are 1°"),
        Good(standing(""), why="it balances"),
    )

    @staticmethod
    def applies(plugin: Plugin) -> bool:
        return plugin.drive is not None and culprit(plugin) is not None

    def check(self, plugin: Plugin) -> Iterator[Diagnostic]:
        found = culprit(plugin)
        assert found is not None
        stance, part = found
        how = "its drive does not touch the floor"
        if stance.lift <= limit_of(plugin):
            how = f"the robot stands tilted by {math.degrees(stance.tilt):.1f}°"
        labels = {plugin: "this drive"}
        if not part.is_solid:
            yield self.diagnostic(part.link, f"{part.link.title} has no collision: {how}", labels=labels)
            return
        away = f"{abs(part.height) * 1000:.3g} mm {'above' if part.height > 0 else 'below'}"
        message = f"the lowest point of {part.link.title} is {away} those of the wheels: {how}"
        yield self.diagnostic(part.shape, message, labels=labels)


def limit_of(plugin: Plugin) -> float:
    """How far a drive may be above the floor (m)."""
    drive = plugin.drive
    return 0.02 * drive.left.radius if drive is not None else math.inf


def culprit(plugin: Plugin) -> tuple[Stance, Footing] | None:
    """How the robot of a drive stands, if that is not level on its wheels, and the part that is to blame."""
    drive = plugin.drive
    stance = drive.stance if drive is not None else None
    if stance is None or (stance.tilt < MOST and stance.lift <= limit_of(plugin)):
        return None
    supports = [
        each for each in stance.footings if each.is_solid and (each.height < 0 or may_be_caster(each, plugin))
    ]
    if not supports:
        hollow = (each for each in stance.footings if not each.is_solid and is_hollow_caster(each))
        found = next(hollow, None)
    else:
        found = max(supports, key=lambda each: abs(each.height))
        found = found if abs(found.height) > limit_of(plugin) else None
    return (stance, found) if found is not None else None


def is_hollow_caster(footing: Footing) -> bool:
    """Is it a wheel or a ball that is seen, and touches nothing?"""
    return not footing.link.collisions and footing.shape.geometry.shape in {"sphere", "cylinder"}


def may_be_caster(footing: Footing, plugin: Plugin) -> bool:
    """Is it meant to be on the floor? The body that carries the wheels is not, but for a ball in it."""
    drive = plugin.drive
    bodies = {wheel.joint.parent_link for wheel in drive.wheels} if drive is not None else set()
    return footing.link not in bodies or footing.shape.geometry.shape == "sphere"

import math
from collections.abc import Iterator

from sdfcheck import Bad, Diagnostic, Good, Link, Plugin, Rule, Severity, Shape
from sdfcheck_rules.geo.scaffolds import rover

MOST = math.radians(1.5)
"""Of 63 drives in public robots whose shapes near the floor are plain 51 are level within that."""
LIFTED, LEANING = 0.02, 0.25
"""Of the radius of a wheel; a robot that balances leans by less."""
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
    air. A robot with two wheels and no caster tips over, unless its center of mass is above the axle and it balances.
    Robots are looked at whose collisions near the floor are plain shapes, with all joints at zero.
    """

    code = "GEO023"
    name = "tilted-stand"
    severity = Severity.WARNING
    remedy = """Move the caster until its lowest point is level with those of the wheels.

    The center of a sphere that is used as a caster is as high above the floor as its radius. The collision counts, not
    the visual.
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
        Bad(
            standing("").replace('<link name="base">', '<«link» name="base">'),
            says="the robot has two wheels alone, and its center of mass is 86",
        ),
    )
    good = (
        Good(standing(BALL.format("collision", "0.05"))),
        Good(standing(BALL.format("collision", "0.045")), why="5 mm are 1°"),
        Good(standing("").replace(BACK, "").replace(BODY, BODY.replace(BACK, "")), why="it balances"),
    )

    @staticmethod
    def applies(plugin: Plugin) -> bool:
        return culprit(plugin) is not None or tipping(plugin) is not None

    def check(self, plugin: Plugin) -> Iterator[Diagnostic]:
        found, tips = culprit(plugin), tipping(plugin)
        if found is None:
            if tips is not None:
                body, lean = tips
                message = (
                    f"the robot has two wheels alone, and its center of mass is {lean * 1000:.3g} mm from"
                )
                yield self.diagnostic(
                    body,
                    f"{message} their axle: it tips over",
                    labels={plugin: "this drive"},
                    help="add a caster on the side to which it tips, or move the mass above the axle",
                )
            return
        link, shape, height, is_solid, how = found
        labels = {plugin: "this drive"}
        if not is_solid:
            yield self.diagnostic(link, f"{link.title} has no collision: {how}", labels=labels)
            return
        away = f"{abs(height) * 1000:.3g} mm {'above' if height > 0 else 'below'}"
        message = f"the lowest point of {link.title} is {away} those of the wheels: {how}"
        yield self.diagnostic(shape, message, labels=labels)


def culprit(plugin: Plugin) -> tuple[Link, Shape, float, bool, str] | None:
    """The part that keeps the robot of a drive from standing level on its wheels: link, shape, height (m).

    Then whether that is a collision, and how the robot stands.
    """
    drive, stance = plugin.drive, plugin.stance
    if drive is None or stance is None:
        return None
    least = LIFTED * drive.left.radius
    if stance.tilt < MOST and stance.lift <= least:
        return None
    how = f"the robot stands tilted by {math.degrees(stance.tilt):.1f}°"
    if stance.lift > least:
        how = "its drive does not touch the floor"
    bodies = {wheel.joint.parent_link for wheel in drive.wheels}
    # The body that carries the wheels is not meant to be on the floor, but for a ball in it.
    supports = [
        each
        for each in stance.footings
        if each.is_solid
        and (each.height < 0 or each.link not in bodies or each.shape.geometry.shape == "sphere")
    ]
    hollow = [each for each in stance.footings if is_hollow_caster(each.link, each.shape)]
    chosen = max(supports or hollow, key=lambda each: abs(each.height), default=None)
    if chosen is None or (supports and abs(chosen.height) <= least):
        return None
    return chosen.link, chosen.shape, chosen.height, chosen.is_solid, how


def tipping(plugin: Plugin) -> tuple[Link, float] | None:
    """The body of a robot that nothing carries but two wheels, and how far beside their axle it is heavy (m)."""
    drive = plugin.drive
    stance = plugin.stance if drive is not None and len(drive.wheels) == 2 else None
    body = drive.left.joint.parent_link if drive is not None else None
    if drive is None or stance is None or body is None or drive.steering or stance.tilt < MOST:
        return None
    if any(each.link is not body or each.shape.geometry.shape == "sphere" for each in stance.footings):
        return None
    return (body, stance.lean) if stance.lean > LEANING * drive.left.radius else None


def is_hollow_caster(link: Link, shape: Shape) -> bool:
    """Is it a wheel or a ball that is seen, and touches nothing?"""
    return not link.collisions and shape.geometry.shape in {"sphere", "cylinder"}

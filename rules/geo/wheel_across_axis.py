from collections.abc import Iterator
from math import acos, cos, degrees, dist, radians

from sdfcheck import Bad, Diagnostic, Element, Good, Joint, Link, Rule, Severity, Shape, Value

MOST = cos(radians(10))
"""Of 329 wheels in public robots four are turned farther, all of one robot, and by mistake."""
SMALLEST = 0.005
"""m."""
WHEEL = (
    '<robot name="r"><link name="base"/><link name="wheel"><collision><origin rpy="{}"/><geometry>'
    '<cylinder radius="0.1" length="{}"/></geometry></collision></link><joint name="j" type="continuous">'
    '<parent link="base"/><child link="wheel"/><axis xyz="{}"/></joint></robot>'
)
OLD_WHEEL = (
    '<sdf version="1.4"><model name="m"><link name="base"/><link name="wheel"><pose>0 0 0 1.5708 0 0</pose>'
    '<collision name="c"><geometry><cylinder><radius>0.1</radius><length>0.04</length></cylinder></geometry>'
    '</collision></link><joint name="j" type="revolute"><parent>base</parent><child>wheel</child>'
    "<axis><xyz>0 1 0</xyz></axis></joint></model></sdf>"
)


class WheelAcrossAxis(Rule):
    """The cylinder of a wheel lies across the axis that it turns about.

    A cylinder stands along z. As a wheel it has to be turned (`rpy="1.5708 0 0"` for an axis along y); as it
    is, it tumbles.
    """

    code = "GEO013"
    name = "wheel-across-axis"
    severity = Severity.WARNING
    remedy = """Turn the cylinder into the axis of its joint: `rpy="1.5708 0 0"` for an axis along y.

    The rotation belongs into the `<origin>` (URDF) or `<pose>` (SDFormat) of both the visual and the
    collision. For an axis along x it is `0 1.5708 0`. The moments of inertia turn with it: the axle has the
    moment m r² / 2.
    """
    looks_at = (Joint,)

    bad = (
        Bad(
            WHEEL.format("0 0 0", "0.04", "«0 1 0»"),
            says="wheel `wheel` is a cylinder that stands 90° off the axis of joint `j`",
        ),
        Bad(
            WHEEL.format("«0 0 0»", "0.04", "0 1 0").replace(
                "<collision>",
                '<visual><origin rpy="1.5708 0 0"/><geometry><cylinder radius="0.1" length="0.04"/></geometry>'
                "</visual><collision>",
            ),
            says="wheel `wheel` is a cylinder that stands 90° off the axis of joint `j`",
        ),
    )
    good = (
        Good(WHEEL.format("1.5708 0 0", "0.04", "0 1 0")),
        Good(WHEEL.format("0 0 0", "0.4", "0 1 0"), why="longer than wide: no wheel"),
        Good(
            WHEEL.format("0 0 0", "0.04", "0 1 0").replace(
                "</robot>",
                '<link name="hub"/><joint name="k" type="continuous"><parent link="wheel"/><child link="hub"/>'
                '<axis xyz="0 0 1"/></joint></robot>',
            ),
            why="a ring of a gimbal",
        ),
        Good(
            WHEEL.format("0 0 0", "0.04", "0 1 0")
            .replace('"wheel"', '"scan"')
            .replace(
                "</robot>", '<gazebo reference="scan"><sensor name="s" type="gpu_lidar"/></gazebo></robot>'
            ),
            why="a lidar that turns to see all around it",
        ),
        Good(OLD_WHEEL, why="up to 1.4 the axis is in the model's frame, and the wheel is turned in it"),
    )

    @staticmethod
    def applies(joint: Joint) -> bool:
        return 0 <= alignment(joint) < MOST and not joint.misnamed("axis")

    def check(self, joint: Joint) -> Iterator[Diagnostic]:
        link = joint.child_link
        if link is None:
            return
        off = degrees(acos(min(1.0, alignment(joint))))
        message = (
            f"{_noun(link)} `{link.name}` is a cylinder that stands {off:.0f}° off the axis of {joint.title}"
        )
        shape, axis = shapes_of(link)[0], joint.axis.xyz if joint.axis.xyz.is_given else joint
        if any(along(each, joint) >= MOST for each in link.visuals):
            place = turn_of(shape) or shape
            yield self.diagnostic(place, message, labels={axis: "the axis, along which the visual is"})
        else:
            yield self.diagnostic(axis, message, labels={shape: "the cylinder, which is along its z axis"})


def turn_of(shape: Shape) -> Value | Element | None:
    """The place where its rotation is written; None where there is none."""
    origin = shape.find("origin")
    return shape.find("pose") if origin is None else origin.attribute("rpy") or origin


def along(shape: Shape, joint: Joint) -> float:
    """The cosine of the angle between a cylinder in its child and the axis of a joint; -1 for other shapes."""
    way, axis, frame = shape.along, joint.direction, joint.at_rest
    if shape.geometry.shape != "cylinder" or way is None or axis is None or frame is None:
        return -1.0
    return abs(sum(one * other for one, other in zip(frame.turned(way), axis, strict=True)))


def alignment(joint: Joint) -> float:
    """The cosine of the angle between the axis of a joint and the wheel that it turns; -1 where there is no wheel."""
    if joint.axis.is_given and joint.axis.xyz.value is None:
        return -1.0
    link = joint.child_link if joint.type in {"continuous", "revolute"} else None
    shapes = shapes_of(link) if link is not None else ()
    if link is None or len(shapes) != 1 or shapes[0].geometry.shape != "cylinder":
        return -1.0
    if link.sensors and _noun(link) != "wheel":
        return -1.0  # a lidar that nods or rolls
    own = joint.find("pose")
    if not is_endless(joint) or (own is not None and own.content):
        return -1.0
    geometry, frame = shapes[0].geometry, joint.at_rest
    radius, length = float(geometry.radius), float(geometry.length)
    if geometry.solid is None or not radius >= SMALLEST or not length < 2 * radius:
        return -1.0
    place = shapes[0].position
    if place is None or dist(place, (0, 0, 0)) > 0.6 * radius or frame is None:
        return -1.0
    inner = (each.at_rest for each in link.child_joints if each.moves)
    if any(rest is not None and dist(rest.position, frame.position) < SMALLEST for rest in inner):
        return -1.0  # a ring of a gimbal
    return along(shapes[0], joint)


def shapes_of(link: Link) -> tuple[Shape, ...]:
    """The shapes that touch the ground; of what is a wheel by its name also those that only show it."""
    return link.collisions or (link.visuals if _noun(link) == "wheel" else ())


def _noun(link: Link) -> str:
    return "wheel" if "wheel" in link.name.lower() else "link"


def is_endless(joint: Joint) -> bool:
    """Does it turn without end?"""
    low, high = joint.axis.limit.range
    return joint.type == "continuous" or (low < -1e3 and high > 1e3)

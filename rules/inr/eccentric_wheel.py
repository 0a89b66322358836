from collections.abc import Iterator, Sequence
from math import hypot, inf, sqrt

from sdfcheck import Bad, Diagnostic, Good, Link, Rule, Severity
from sdfcheck_rules.inr.places import place_of

ROUND = frozenset(("cylinder", "sphere"))
PARALLEL = 0.99
"""The cosine between the axes of joint and cylinder."""
NEAR, FAR = 0.02, 0.15
"""Of the radius: a wheel whose shape is nearer than the first to the axis turns about its middle; a center of mass that
is farther than the second from the axis is not that of a wheel."""
INERTIAL = (
    '<inertial><origin xyz="{}"/><mass value="1"/><inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/>'
    "</inertial>"
)
WHEEL = (
    f'<robot name="r"><link name="base">{INERTIAL.format("0 0 0")}</link><link name="wheel">{INERTIAL}<collision>'
    '<origin rpy="1.5708 0 0"/><geometry><cylinder radius="0.1" length="0.05"/></geometry></collision></link>'
    '<joint name="j" type="continuous"><parent link="base"/><child link="wheel"/><axis xyz="0 1 0"/></joint></robot>'
)
LEG = (
    f'<link name="leg">{INERTIAL.format("0 0 -0.2")}</link><joint name="k" type="revolute"><parent link="wheel"/>'
    '<child link="leg"/><axis xyz="1 0 0"/><limit lower="-1" upper="1" effort="9" velocity="9"/></joint></robot>'
)


class EccentricWheel(Rule):
    """The center of mass of a wheel is beside the axis that it turns about.

    The shape of the wheel is round and in the middle of the axis, the mass is not: the robot rolls away by itself,
    and jerks with every turn. Often the center is that of the whole assembly, or in another frame.
    """

    code = "INR019"
    name = "eccentric-wheel"
    severity = Severity.WARNING
    remedy = """Write a center of mass on the axis: `<origin xyz="0 0 0"/>` if the joint is in the middle of it.

    If the part is meant to be out of balance, such as an eccentric or a motor for vibration, ignore this finding.
    """
    looks_at = (Link,)
    needs = ("continuous",)

    bad = (
        Bad(
            WHEEL.format("«0.02 0 0.03»"),
            says="the center of mass of link `wheel` is 36 mm from its axis, and its shape has a radius of 100 mm",
        ),
    )
    good = (
        Good(WHEEL.format("0.001 0 0.002")),
        Good(WHEEL.format("0 0.03 0"), why="along the axis"),
        Good(
            WHEEL.format("0.02 0 0.03").replace("</robot>", LEG),
            why="a hip, which carries the rest of a leg",
        ),
    )

    @staticmethod
    def applies(link: Link) -> bool:
        return link.inertial.is_given and eccentricity(link) is not None

    def check(self, link: Link) -> Iterator[Diagnostic]:
        found = eccentricity(link)
        assert found is not None, "it was measured"
        off, radius = (round(1000 * each) for each in found)
        message = (
            f"the center of mass of {link.title} is {off} mm from its axis, and its shape has a radius of"
        )
        yield self.diagnostic(place_of(link.inertial) or link.inertial, f"{message} {radius} mm")


def eccentricity(link: Link) -> tuple[float, float] | None:
    """How far the center of mass of a wheel is from its axis, and its radius (m); None where it is near or no wheel."""
    joint = link.parent_joints[0] if len(link.parent_joints) == 1 else None
    center, shapes = link.inertial.center, link.collisions or link.visuals
    if joint is None or not joint.is_urdf or joint.type != "continuous" or center is None or len(shapes) != 1:
        return None
    shape, axis = shapes[0], tuple(joint.axis.xyz)
    length = hypot(*axis)
    if shape.geometry.shape not in ROUND or shape.position is None or len(axis) != 3 or not 0 < length < inf:
        return None
    if any(each.moves for each in link.child_joints):
        return None  # a hip, not a wheel
    unit, radius = [each / length for each in axis], float(shape.geometry.radius)
    if shape.geometry.shape == "cylinder" and abs(along(shape.along or (0.0, 0.0, 0.0), unit)) < PARALLEL:
        return None
    off = aside(center, unit)
    return (
        (off, radius) if aside(shape.position, unit) < NEAR * radius < FAR * radius < off < radius else None
    )


def along(point: Sequence[float], unit: Sequence[float]) -> float:
    """How far a point is along an axis through the origin."""
    return sum(one * other for one, other in zip(point, unit, strict=True))


def aside(point: Sequence[float], unit: Sequence[float]) -> float:
    """How far a point is from an axis through the origin."""
    return sqrt(max(0.0, along(point, point) - along(point, unit) ** 2))

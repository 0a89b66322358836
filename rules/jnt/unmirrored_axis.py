from collections.abc import Iterator
from math import hypot, inf, isclose

from sdfcheck import Bad, Diagnostic, Good, Joint, Link, Model, Rule, Severity
from sdfcheck_rules.jnt.opposed_axis import is_opposed

NEAR = 0.02
"""m of the places, rad of the limits, and of the product of two directions."""
SLIGHT = 0.1
"""Of a bound: limits that differ less from their opposites say nothing about a side."""
LEAST = 2
"""Other pairs whose limits and axes agree, so that the robot is known to be symmetric."""
SPHERE, MESH = '<sphere radius="0.1"/>', '<mesh filename="package://arms/shoulder.stl"/>'
JOINT = (
    f'<link name="{{0}}_{{1}}"><visual><geometry>{SPHERE}</geometry></visual></link>'
    '<joint name="{0}_{1}_joint" type="revolute"><origin xyz="0 {2} {3}"/><parent link="base"/>'
    '<child link="{0}_{1}"/><axis xyz="{4}"/><limit lower="{5}" upper="{6}" effort="1" velocity="1"/></joint>'
)
LEGS = (
    '<robot name="r"><link name="base"/>'
    + "".join(
        JOINT.format("left", part, 0.1, height, axis, 0, 2)
        + JOINT.format("right", part, -0.1, height, mirrored, 0, 2)
        for part, height, axis, mirrored in (("knee", -1, "0 1 0", "0 1 0"), ("hip", 0, "1 0 0", "-1 0 0"))
    )
    + JOINT.format("left", "arm", 0.1, 1, "0 1 0", -1, 2)
    + "{}</robot>"
)


FINGER = (
    '<link name="{0}"><visual><origin xyz="0 {1} 0"/><geometry><box size="0.02 0.01 0.05"/></geometry></visual></link>'
    '<joint name="{0}_joint" type="prismatic"><origin xyz="0 {1} 0"/><parent link="palm"/><child link="{0}"/>'
    '<axis xyz="{2}"/><limit lower="0" upper="0.04" effort="1" velocity="1"/></joint>'
)
GRIPPER = f'<robot name="r"><link name="palm"/>{FINGER.format("one", 0.01, "0 1 0")}{{}}</robot>'


def arm(axis: str, lower: str, upper: str) -> str:
    """The counterpart of the arm."""
    return JOINT.format("right", "arm", -0.1, 1, axis, lower, upper)


class UnmirroredAxis(Rule):
    """A joint on one side turns the other way than the mirror image of its counterpart, and has the same limits.

    An axis and its limits say twice to which side a joint turns. Where a left knee bends from 0 to 2, the right
    one does so about the mirrored axis, or from -2 to 0 about the opposite one. Of 1,131 pairs of joints in public
    robots whose limits are not symmetric 1,120 agree; six of the others are hips and shoulders of a humanoid that
    reach into its body. Robots are looked at that have two other such pairs which agree. Of a part that is there twice,
    with the same mesh, axis and limits, nothing is mirrored. The two fingers of a gripper slide in opposite directions,
    as all of 60 public ones do: if both go the same way along one line, they never close.
    """

    code = "JNT024"
    name = "unmirrored-axis"
    severity = Severity.WARNING
    remedy = """Turn the axis around, or exchange and negate the limits.

    The mirror image of a turn about x or z is about the opposite axis, that of a turn about y about the same one.
    `sdfcheck view FILE` moves both joints: with the same position they should be each other's mirror image.
    """
    looks_at = (Model,)
    selects = ("urdf:robot",)
    scaffold = LEGS

    bad = (
        Bad(
            arm("«0 -1 0»", "-1", "2"),
            says="joint `right_arm_joint` turns from -1 to 2, and the mirror image of `left_arm_joint` from -2 to 1"
            " about this axis",
        ),
        Bad(arm("«0 1 0»", "-2", "1"), says="the mirror image of `left_arm_joint` from -1 to 2"),
        Bad(
            FINGER.format("two", -0.01, "«0 1 0»"),
            scaffold=GRIPPER,
            says="joint `two_joint` slides the same way as `one_joint`, along one line and as far",
        ),
    )
    good = (
        Good(arm("0 1 0", "-1", "2")),
        Good(arm("0 -1 0", "-2", "1"), why="axis and limits are the opposite"),
        Good(arm("0 -1 0", "-1", "1.5"), why="other limits"),
        Good(arm("0 -1 0", "-2", "2"), why="as far to both sides"),
        Good(
            arm("0 0 1", "-1", "2").replace(SPHERE, MESH),
            scaffold=LEGS.replace(SPHERE, MESH).replace(
                '"0 1 0"/><limit lower="-1"', '"0 0 1"/><limit lower="-1"'
            ),
            why="an arm that is there twice",
        ),
        Good(
            arm("0 -1 0", "-1", "2").replace(
                '<visual><geometry><sphere radius="0.1"/></geometry></visual>', ""
            ),
            why="it carries nothing that can be seen",
        ),
        Good(
            arm("0 -1 0", "-1.95", "2"),
            scaffold=LEGS.replace('"-1" upper="2"', '"-1.95" upper="2"'),
            why="it turns as far to both sides, nearly",
        ),
        Good(FINGER.format("two", -0.01, "0 -1 0"), scaffold=GRIPPER),
        Good(
            FINGER.format("two", 0.01, "0 1 0").replace('"0 0.01 0"/><geo', '"0 0 0.3"/><geo'),
            scaffold=GRIPPER,
            why="two drawers",
        ),
    )

    @staticmethod
    def applies(model: Model) -> bool:
        return bool(unmirrored(model) or parallel(model))

    def check(self, model: Model) -> Iterator[Diagnostic]:
        for joint, mirror in unmirrored(model):
            (low, high), (left, right) = joint.axis.limit.range, mirror.axis.limit.range
            if sense(joint, mirror) < 0:
                left, right = 0 - right, 0 - left
            yield self.diagnostic(
                joint.axis.xyz,
                f"{joint.title} turns from {low:.4g} to {high:.4g}, and the mirror image of `{mirror.name}` from"
                f" {left:.4g} to {right:.4g} about this axis",
                labels={mirror.axis.xyz: "the axis of its counterpart", joint.axis.limit: "its limits"},
            )
        for joint, other in parallel(model):
            yield self.diagnostic(
                joint.axis.xyz,
                f"{joint.title} slides the same way as `{other.name}`, along one line and as far: they never meet",
                labels={other.axis.xyz: "the axis of the other one", joint.axis.limit: "its limits"},
            )


def parallel(model: Model) -> list[tuple[Joint, Joint]]:
    """The pairs of joints, the later first, that are alone on their parent and slide the same way along one line."""
    on: dict[Link | None, list[Joint]] = {}
    for joint in model.joints:
        if joint.type == "prismatic":
            on.setdefault(joint.parent_link, []).append(joint)
    pairs = ((pair[1], pair[0]) for link, pair in on.items() if link is not None and len(pair) == 2)
    return [(later, first) for later, first in pairs if is_parallel(later, first)]


def is_parallel(joint: Joint, other: Joint) -> bool:
    """Does it slide along the line of another one, to where that slides? Their parts are in line as well."""
    along, line = joint.direction, other.direction
    part, opposite = joint.child_link, other.child_link
    if along is None or line is None or part is None or opposite is None or not joint.is_one_sided:
        return False
    cosine = sum(a * b for a, b in zip(along, line, strict=True))
    here, there = center(part), center(opposite)
    if abs(cosine) < 1 - NEAR or side(joint, other) * cosine <= 0 or here is None or there is None:
        return False
    offset = [a - b for a, b in zip(here, there, strict=True)]
    reach = sum(a * b for a, b in zip(offset, along, strict=True))
    return hypot(*offset) ** 2 - reach**2 <= reach**2


def center(link: Link) -> tuple[float, ...] | None:
    """The middle of its shapes in its robot, all joints at zero (m); None where that is not known."""
    if link.at_rest is None or link.extent is None:
        return None
    x, y, z = link.extent.center
    return link.at_rest.applied_to((x, y, z))


def unmirrored(model: Model) -> list[tuple[Joint, Joint]]:
    """The joints whose axis and limits do not fit those of their counterparts, each with it."""
    found, agreeing = [], 0
    for joint in model.joints:
        mirror = joint.mirror if joint.type == "revolute" else None
        if mirror is None or mirror.type != "revolute" or joint.element.index < mirror.element.index:
            continue
        ways = side(joint, mirror)
        if not ways:
            continue
        if sense(joint, mirror) == ways:
            agreeing += 1
        elif (
            sense(joint, mirror) == -ways
            and is_seen(joint)
            and not is_copy(joint, mirror)
            and not is_opposed(joint)
            and not is_opposed(mirror)
        ):
            found.append((joint, mirror))
    return found if agreeing >= max(LEAST, len(found)) else []


def is_seen(joint: Joint) -> bool:
    """Does it carry a shape? The hand of a robot may be a joint that turns nothing."""
    link = joint.child_link
    return link is not None and any(below.shapes for below in link.below())


def is_copy(joint: Joint, mirror: Joint) -> bool:
    """Is it the same joint of the same part, as of an arm that was bought twice? Nothing of such arms is mirrored."""
    link, other = joint.child_link, mirror.child_link
    if link is None or other is None or not link.look:
        return False
    return link.look == other.look and tuple(joint.axis.xyz) == tuple(mirror.axis.xyz)


def side(joint: Joint, mirror: Joint) -> int:
    """1 if two joints have the same limits, -1 if they have opposite ones; 0 if neither, or nearly both."""
    (low, high), (left, right) = joint.axis.limit.range, mirror.axis.limit.range
    if not -inf < low < high < inf or isclose(low, -high, rel_tol=SLIGHT):
        return 0
    is_same, is_opposite = (
        all(
            isclose(
                own, other, rel_tol=NEAR, abs_tol=NEAR if joint.type == "revolute" else NEAR * (high - low)
            )
            for own, other in zip((low, high), ends, strict=True)
        )
        for ends in ((left, right), (-right, -left))
    )
    return is_same - is_opposite


def sense(joint: Joint, mirror: Joint) -> int:
    """1 if a joint turns like the mirror image of another one, -1 if the opposite way; 0 if they are not mirrored."""
    own, other = joint.at_rest, mirror.at_rest
    first, second = joint.direction, mirror.direction
    if own is None or other is None or first is None or second is None:
        return 0
    for across in (1, 0):
        signs = [-1 if number == across else 1 for number in range(3)]
        pairs = zip(signs, own.position, other.position, strict=True)
        if abs(own.position[across]) < NEAR / 10 or any(abs(sign * b - a) > NEAR for sign, a, b in pairs):
            continue
        # The mirror image of a turn is about the mirrored axis, the other way.
        cosine = -sum(sign * a * b for sign, a, b in zip(signs, first, second, strict=True))
        return round(cosine) if abs(cosine) > 1 - NEAR else 0
    return 0

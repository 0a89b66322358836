from collections.abc import Iterator, Sequence
from math import dist, hypot

from sdfcheck import Bad, Diagnostic, Good, Joint, Link, Model, Rule, Severity

LEAST, SHARE = 0.005, 0.05
"""m, and of the distance: joints that are made by hand differ by less."""
TWINS, SPREAD = 2, 3.0
"""Joints between the same meshes that agree, and the times of what is between them: parts may have been measured."""
UNLIKE = 0.25
"""Of a length: parts that differ by more are no mirror images."""
MOST = 3
"""Pairs: a robot with more of them is not meant to be symmetric."""
JOINT = (
    '<joint name="{0}_wheel_joint" type="continuous"><origin xyz="{1}"/><parent link="base"/>'
    '<child link="{0}_wheel"/><axis xyz="0 1 0"/></joint>'
)
ARM = JOINT + (
    '<joint name="{0}_hand_joint" type="revolute"><origin xyz="{2}"/><parent link="{0}_wheel"/>'
    '<child link="{0}_hand"/><axis xyz="1 0 0"/>'
    '<limit lower="-1" upper="1" effort="1" velocity="1"/></joint>'
)
ROBOT = '<robot name="r"><link name="base"/><link name="left_wheel"/><link name="right_wheel"/>{}</robot>'
SMALL = '<link name="{}_wheel"><visual><geometry><sphere radius="{}"/></geometry></visual></link>'
BODY = (
    '<link name="base"><visual><origin xyz="0 0.025 0"/><geometry><box size="0.3 0.3 0.1"/></geometry></visual>'
    "</link>"
)


def fingers(*origins: str) -> str:
    """A hand whose fingers are made of two meshes each, with the origins of their second joints."""
    visual = '<visual><geometry><mesh filename="{}.stl"/></geometry></visual>'
    joint = (
        '<joint name="{0}_joint" type="continuous"><origin xyz="{2}"/><parent link="{1}"/>'
        '<child link="{0}"/></joint>'
    )
    text = "".join(
        f'<link name="{name}">{visual.format("finger")}</link><link name="{name}_tip">{visual.format("tip")}</link>'
        + joint.format(name, "palm", f"0 0.{number} 0")
        + joint.format(f"{name}_tip", name, origin)
        for number, (name, origin) in enumerate(zip("abc", origins, strict=True))
    )
    return f'<robot name="r"><link name="palm"/>{text}</robot>'


class AsymmetricJoint(Rule):
    """A joint on the right is not where the one of the same name is on the left.

    Machines are symmetric: apart from signs, the origins of two such joints are the same numbers. Of a thousand pairs
    in public robots two differ by more than 5 mm and 5 %, in one hand. A robot with more than three such pairs is
    not meant to be symmetric. Where three fingers or legs are made of the same meshes, their joints are at the same
    places in them: of 53 such groups in public robots none has one joint elsewhere.
    """

    code = "JNT020"
    name = "asymmetric-joint"
    severity = Severity.WARNING
    remedy = """Place the joint where its counterpart is, mirrored: the same numbers with y negated.

    That is so for a robot that looks along x. Check both against the drawing, for either may be the wrong
    one. A macro of xacro with a `reflect` of 1 and -1 writes both sides from one set of numbers.
    """
    looks_at = (Model,)
    selects = ("urdf:robot",)
    scaffold = ROBOT

    bad = (
        Bad(
            JOINT.format("left", "0.1 0.2 0") + JOINT.format("right", "«0.1 -0.15 0»"),
            says="joint `right_wheel_joint` is 0.05 m from where the mirrored origin of `left_wheel_joint` is",
        ),
        Bad(
            fingers("0 0 0.1", "«0.03 0 0.1»", "0 0 0.1"),
            scaffold="{}",
            says="joint `b_tip_joint` is 0.03 m from where its 2 counterparts are, in a part of the same meshes",
        ),
    )
    good = (
        Good(fingers("0 0 0.1", "0 0 0.1", "0 0 0.1"), scaffold="{}"),
        Good(
            JOINT.format("left", "0.1 0.2 0") + JOINT.format("right", "0.1 -0.202 0"), why="rounded by hand"
        ),
        Good(
            JOINT.format("left", "0.1 0.2 0") + JOINT.format("right", "-0.1 0.2 0"), why="the frame is turned"
        ),
        Good(
            ARM.format("left", "0.1 0.2 0", "0.3 0.02 0") + ARM.format("right", "0.1 -0.25 0", "0.3 0.03 0"),
            scaffold=ROBOT.replace("{}", "{}<link name='left_hand'/><link name='right_hand'/>"),
            why="the origin is elsewhere on the axis, and the next joint takes that back",
        ),
        Good(
            JOINT.format("left", "0.1 0.2 0") + JOINT.format("right", "0.1 -0.15 0"),
            scaffold=ROBOT.replace('<link name="base"/>', BODY),
            why="the frame of the body is not in its middle, where the joints are",
        ),
        Good(
            JOINT.format("left", "0.7 0.8 0.6") + JOINT.format("right", "0.7 0.7 0.55"),
            why="the frame is far from both, and may be turned",
        ),
        Good(
            JOINT.format("left", "0.1 0.2 0") + JOINT.format("right", "0.1 -0.1 0"),
            scaffold=ROBOT.replace('<link name="left_wheel"/>', SMALL.format("left", 0.1)).replace(
                '<link name="right_wheel"/>', SMALL.format("right", 0.05)
            ),
            why="one wheel is half as large as the other",
        ),
        Good(
            JOINT.format("l_r", "0.1 0.2 0") + JOINT.format("r_r", "0.1 -0.15 0"),
            scaffold='<robot name="r"><link name="base"/><link name="l_r_wheel"/><link name="r_r_wheel"/>{}</robot>',
            why="of two wheels on each side the right one, which is the left one of the mirror image",
        ),
        Good(JOINT.format("left", "0.1 0.2 0") + JOINT.format("third", "0 0 0"), why="no counterpart"),
    )

    @staticmethod
    def applies(model: Model) -> bool:
        return bool(displaced(model) or misplaced(model))

    def check(self, model: Model) -> Iterator[Diagnostic]:
        for joint, mirror in displaced(model):
            origin, other = joint.find("origin"), mirror.find("origin")
            value = None if origin is None else origin.attribute("xyz")
            yield self.diagnostic(
                value or joint,
                f"{joint.title} is {displacement(joint, mirror):.3g} m from where the mirrored origin of"
                f" `{mirror.name}` is",
                labels={mirror if other is None else other: "its counterpart"},
            )
        for joint, twins in misplaced(model):
            origin = joint.find("origin")
            value = None if origin is None else origin.attribute("xyz")
            yield self.diagnostic(
                value or joint,
                f"{joint.title} is {dist(origin_of(joint), origin_of(twins[0])):.3g} m from where its"
                f" {len(twins)} counterparts are, in a part of the same meshes",
                labels={twins[0]: "one of them"},
            )


def displaced(model: Model) -> list[tuple[Joint, Joint]]:
    """The joints that are not where their counterparts are, each with it; none where a robot is not symmetric."""
    pairs = [
        (joint, mirror) for joint in model.joints if joint.moves and (mirror := joint.mirror) is not None
    ]
    found = [
        (joint, mirror)
        for joint, mirror in pairs
        if mirror.moves
        and joint.element.index > mirror.element.index
        and displacement(joint, mirror) > 0
        and not is_mirrored(joint, mirror)
        and not is_slid(joint, mirror)
        and not is_aside(joint, mirror)
        and not is_unlike(joint, mirror)
    ]
    planes = [plane(*pair) for pair in found]
    found = [
        pair
        for pair, own in zip(found, planes, strict=True)
        if own is None
        or not is_middle(own, [each for each in planes if each is not None and each is not own])
    ]
    return found if len(found) <= MOST else []


def misplaced(model: Model) -> list[tuple[Joint, list[Joint]]]:
    """The joints that are elsewhere than two or more others between the same meshes, which agree; each with these."""
    found = []
    for joint in model.joints:
        look = joint.parent_link.look if joint.parent_link is not None else ()
        twins = [
            twin for twin in joint.twins if twin.parent_link is not None and twin.parent_link.look == look
        ]
        origins = [origin_of(each) for each in (joint, *twins)]
        if look and len(twins) >= TWINS and all(len(origin) == 3 for origin in origins):
            apart = [dist(origins[1], origin) for origin in origins]
            if apart[0] > max(LEAST, SPREAD * max(apart[1:])):
                found.append((joint, twins))
    return found


def origin_of(joint: Joint) -> list[float]:
    """The numbers of its origin (m); none where unreadable."""
    origin = joint.find("origin")
    try:
        return [
            float(word) for word in ("0 0 0" if origin is None else origin.text_of("xyz", "0 0 0")).split()
        ]
    except ValueError:
        return []


def displacement(joint: Joint, mirror: Joint) -> float:
    """How far a joint is off the place of its counterpart (m); 0 where that is little."""
    own, other = place(joint), place(mirror)
    if len(own) != 3 or len(other) != 3:
        return 0.0
    found = dist(own, other)
    return found if found > max(LEAST, SHARE * max(hypot(*own), hypot(*other))) else 0.0


def is_mirrored(joint: Joint, mirror: Joint) -> bool:
    """Are they mirror images in the robot, whatever their parents make of that?"""
    return any(hypot(*offset) <= LEAST for offset in offsets(joint, mirror))


def is_aside(joint: Joint, mirror: Joint) -> bool:
    """Do both hang on one link, on one side of each plane of its frame?"""
    own, other = origin_of(joint), origin_of(mirror)
    return joint.parent_link is mirror.parent_link and all(a * b > 0 for a, b in zip(own, other, strict=True))


def is_unlike(joint: Joint, mirror: Joint) -> bool:
    """Do they carry parts of different sizes?"""
    links = (joint.child_link, mirror.child_link)
    own, other = (link.extent if link is not None else None for link in links)
    if own is None or other is None:
        return False
    sizes = zip(sorted(own.size), sorted(other.size), strict=True)
    return any(abs(a - b) > UNLIKE * max(a, b) for a, b in sizes)


def plane(joint: Joint, mirror: Joint) -> tuple[Link, int, float] | None:
    """Of what they are mirror images in the link that carries both: the axis across the plane, and where it is (m)."""
    link, own, other = joint.parent_link, origin_of(joint), origin_of(mirror)
    if link is None or link is not mirror.parent_link:
        return None
    apart = [abs(a - b) > LEAST for a, b in zip(own, other, strict=True)]
    if sum(apart) != 1:
        return None
    across = apart.index(True)
    return link, across, (own[across] + other[across]) / 2


def is_middle(own: tuple[Link, int, float], others: list[tuple[Link, int, float]]) -> bool:
    """Do the shapes of the link, or other pairs on it, have the same plane, so that its frame is elsewhere?"""
    link, across, at = own
    known = [there for carrier, axis, there in others if (carrier, axis) == (link, across)]
    if link.extent is not None:
        known.append(link.extent.center[across])
    return any(abs(at - there) <= LEAST for there in known)


def is_slid(joint: Joint, mirror: Joint) -> bool:
    """Is it elsewhere on the axis of its counterpart's mirror image, and the next joint where it should be?

    Or the middle of its shapes, where it carries no joint.
    """
    along, link, counterpart = joint.direction, joint.child_link, mirror.child_link
    if along is None or link is None or counterpart is None:
        return False
    if all(hypot(*cross(offset, along)) > LEAST for offset in offsets(joint, mirror)):
        return False
    below = [each for each in link.model.joints if each.parent_link is link]
    if below:
        return any(each.mirror is not None and is_mirrored(each, each.mirror) for each in below)
    own, other = middle(link), middle(counterpart)
    return bool(own and other) and any(dist(own, image) <= LEAST for image in images(other))


def middle(link: Link) -> list[float]:
    """The middle of its shapes in the robot, all joints at zero; none where that is not known."""
    if link.at_rest is None or link.extent is None:
        return []
    x, y, z = link.extent.center
    return list(link.at_rest.applied_to((x, y, z)))


def images(point: Sequence[float]) -> Iterator[list[float]]:
    """The mirror images of a point, in the planes that robots are symmetric to."""
    for across in (1, 0):
        yield [-value if axis == across else value for axis, value in enumerate(point)]


def offsets(joint: Joint, mirror: Joint) -> Iterator[list[float]]:
    """From the mirror image of its counterpart to it (m), in the planes that robots are symmetric to."""
    own, other = joint.at_rest, mirror.at_rest
    if own is None or other is None:
        return
    for image in images(other.position):
        yield [a - b for a, b in zip(own.position, image, strict=True)]


def cross(a: Sequence[float], b: Sequence[float]) -> tuple[float, float, float]:
    return a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]


def place(joint: Joint) -> list[float]:
    """The coordinates of its origin without signs and order, for frames may be turned; none where unreadable."""
    return sorted(map(abs, origin_of(joint)))

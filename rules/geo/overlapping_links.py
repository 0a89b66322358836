from collections.abc import Iterator
from itertools import combinations

from sdfcheck import Bad, Diagnostic, Good, Link, Model, Rule, Severity

SHARE = 0.15
"""Of the surface of one of the two: covers and meshes touch, and points are few."""
MOST = 60
"""Links of a robot that are compared."""
MASS = (
    '<inertial><origin xyz="0 0 {}"/><mass value="1"/>'
    '<inertia ixx="0.01" iyy="0.01" izz="0.01" ixy="0" ixz="0" iyz="0"/></inertial>'
)
JOINT = (
    '<joint name="to_{1}" type="revolute"><parent link="{0}"/><child link="{1}"/><origin xyz="0 0 0.3"/>'
    '<axis xyz="0 1 0"/><limit lower="-1" upper="1" effort="9" velocity="1"/></joint>'
)


def arm(length: str, self_collide: str = "true", tag: str = "collision") -> str:
    """An arm of three links, the last of which may reach back into the first."""
    text = ""
    for name, z, size in (
        ("upper", 0.15, "0.09 0.09 0.25"),
        ("wrist", 0, "0.05 0.05 0.05"),
        ("tool", 0, length),
    ):
        box = f'<origin xyz="0 0 {z}"/><geometry><box size="{size}"/></geometry>'
        kind = tag if name == "tool" else "collision"
        text += f'<link name="{name}">{MASS.format(z)}<{kind}>{box}</{kind.strip("«»")}></link>'
        text += f'<gazebo reference="{name}"><selfCollide>{self_collide}</selfCollide></gazebo>'
    joints = JOINT.format("upper", "wrist") + JOINT.format("wrist", "tool").replace("0 0 0.3", "0 0 0.05")
    return f'<robot name="r">{text}{joints}</robot>'


class OverlappingLinks(Rule):
    """Two links of a robot that collides with itself are in each other.

    Gazebo pushes them apart at each step, and the joints between them together again: the robot shakes, or flies to
    pieces. Links that a joint connects do not collide, nor do those without `selfCollide`. It is looked at the robot
    with its joints at zero.
    """

    code = "GEO026"
    name = "overlapping-links"
    severity = Severity.WARNING
    remedy = """Make the collision of one of the links smaller, or turn `selfCollide` off for it.

    A collision that is only for the look of a link is not needed; a mesh that is simplified to its hull may fill the
    space between its arms.
    """
    looks_at = (Model,)
    selects = ("urdf:robot",)
    needs = ("elfCollide", "elf_collide")
    scaffold = "{}"

    bad = (
        Bad(
            arm("0.06 0.06 0.5", tag="«collision»"),
            says="link `tool` is in link `upper`, and both collide with other links of their robot",
        ),
    )
    good = (
        Good(arm("0.06 0.06 0.1")),
        Good(arm("0.06 0.06 0.5", "false"), why="it does not collide with itself"),
    )

    @staticmethod
    def applies(model: Model) -> bool:
        return next(overlapping(model), None) is not None

    def check(self, model: Model) -> Iterator[Diagnostic]:
        for link, other in overlapping(model):
            message = f"{link.title} is in {other.title}, and both collide with other links of their robot"
            target = link.collisions[0] if len(link.collisions) == 1 else link
            yield self.diagnostic(target, message, labels={other: "the other one"})


def overlapping(model: Model) -> Iterator[tuple[Link, Link]]:
    """Links that collide with each other at rest, though no joint connects them."""
    links = [link for link in model.links if link.collisions and collides(link) and rests(link)]
    for other, link in combinations(links[:MOST], 2):
        if not is_near(other, link) and not other.distance_to(link) and link.is_in(other, SHARE):
            yield link, other


def collides(link: Link) -> bool:
    """Is it to collide with links of its own robot?"""
    values = [
        value.text.strip().lower()
        for block in link.gazebo_blocks
        for name in ("selfCollide", "self_collide")
        for value in block.settings(name)
    ]
    return bool(values) and values[-1] in {"true", "1"}


def rests(link: Link) -> bool:
    """May its joint be at zero?"""
    joint = link.parent_joints[0] if link.parent_joints else None
    return joint is None or joint.axis.limit.range[0] <= 0 <= joint.axis.limit.range[1]


def is_near(one: Link, other: Link) -> bool:
    """Is it fixed to the other one, or connected with it by a joint?"""
    group = one.rigid_group
    joints = {joint for link in group for joint in (*link.parent_joints, *link.child_joints)}
    ends = {end for joint in joints for end in (joint.parent_link, joint.child_link)}
    return not {*group, *ends}.isdisjoint(other.rigid_group)

import re
from collections.abc import Iterator
from math import inf

from sdfcheck import Bad, Diagnostic, Good, Joint, Rule, Severity

SHARE, LOOSE = 0.005, 0.05
"""Of the range: less is how both were measured, and what followers of others may go beyond their leaders."""
SIDE = re.compile(r"(?i)left|right|(?<![a-z])[lr](?![a-z])")
JOINT = (
    '<link name="{0}_arm"/><joint name="{0}_elbow" type="revolute"><parent link="body"/><child link="{0}_arm"/>'
    '<axis xyz="0 1 0"/><{3} lower="{1}" upper="{2}" effort="9" velocity="1"/></joint>'
)
MESH = '<link name="{0}_arm"><visual><geometry><mesh filename="http://a.org/{1}/tip.stl"/></geometry></visual></link>'


def arms(left: tuple[str, str], right: tuple[str, str], tag: str = "limit") -> str:
    """A body with an elbow on each side."""
    text = JOINT.format("left", *left, "limit") + JOINT.format("right", *right, tag)
    return f'<robot name="r"><link name="body"/>{text}</robot>'


class UnequalRange(Rule):
    """A joint moves over another range than the same joint on the other side.

    Arms, legs and fingers are built alike on both sides, and their joints have the same range or the mirror image of
    it. Of 7,086 pairs in public robots 26 have not, in five robots: in one the limits of an arm belong to the joint
    before, in another a leg lacks 0.05 rad by a typo. A planner does not find the way that the other side takes.
    """

    code = "JNT034"
    name = "unequal-range"
    severity = Severity.WARNING
    remedy = """Give both joints the same limits, or those of the mirror image: exchanged, with the other signs.

    If the sides really differ, ignore this here.
    """
    looks_at = (Joint,)
    scaffold = "{}"

    bad = (
        Bad(
            arms(("-1", "1"), ("-1", "2"), "«limit»"),
            says="joint `right_elbow` moves over a range of 3 rad, and joint `left_elbow` over one of 2 rad",
        ),
        Bad(
            arms(("-1", "1"), ("-1", "0.98"), "«limit»"),
            says="joint `right_elbow` moves over a range of 1.98 rad, and joint `left_elbow` over one of 2 rad",
        ),
    )
    good = (
        Good(arms(("-0.5", "1"), ("-1", "0.5")), why="the mirror image"),
        Good(arms(("-1", "1"), ("-1.004", "1.004")), why="measured"),
        Good(arms(("0", "0"), ("-1", "1")), why="locked-joint speaks of that"),
        Good(
            arms(("-1", "1"), ("-1", "2"))
            .replace('<link name="left_arm"/>', MESH.format("left", "make_a"))
            .replace('<link name="right_arm"/>', MESH.format("right", "make_b")),
            why="grippers of two makers",
        ),
    )

    @staticmethod
    def applies(joint: Joint) -> bool:
        other = joint.mirror
        if other is None or other.name > joint.name or joint.type != other.type or not joint.moves:
            return False
        if is_of_other_make(joint, other):
            return False
        mine, its = width(joint), width(other)
        follows = any(each.axis_count and each.axis.mimic is not None for each in (joint, other))
        least = LOOSE if follows else SHARE
        return 0 < mine < inf and 0 < its < inf and abs(mine - its) > least * max(mine, its)

    def check(self, joint: Joint) -> Iterator[Diagnostic]:
        other = joint.mirror
        assert other is not None
        unit = "m" if joint.type == "prismatic" else "rad"
        message = (
            f"{joint.title} moves over a range of {width(joint):.4g} {unit}, and {other.title} over one of"
        )
        limit = joint.axis.limit
        yield self.diagnostic(
            limit, f"{message} {width(other):.4g} {unit}", labels={other.axis.limit: "its limits"}
        )


def width(joint: Joint) -> float:
    """How far it goes from one end to the other."""
    lower, upper = joint.axis.limit.range
    return upper - lower


def is_of_other_make(joint: Joint, other: Joint) -> bool:
    """Are the meshes of what they carry in different folders, not those of two sides: two hands of two makers?"""
    mine, its = folder(joint), folder(other)
    return bool(mine and its) and mine != its


def folder(joint: Joint) -> str:
    """The folder of the first mesh that it carries, without the words for sides."""
    shapes = joint.child_link.shapes if joint.child_link is not None else ()
    names = (shape.geometry.uri_value for shape in shapes)
    path = next((name.text.strip() for name in names if name is not None), "")
    return SIDE.sub("", path.rpartition("/")[0])

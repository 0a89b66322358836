from collections.abc import Iterator
from itertools import product
from math import acos, degrees

from sdfcheck import Bad, Diagnostic, Good, Joint, Model, Rule, Severity

LEAST = 1.0
"""Degrees: of 824 pairs in public robots seven differ by more than 0.1 and none by more than 0.5."""
MOST = 3
"""Pairs: a robot with more of them is not meant to be symmetric."""
MIRRORS = tuple(signs for signs in product((1, -1), repeat=3) if sum(signs) > 0)
"""The axes of one side, as they are and in a mirror across each direction."""
STEER = (
    '<link name="{0}_hub"/><joint name="{0}_steer" type="revolute"><parent link="base"/><child link="{0}_hub"/>'
    '<origin xyz="0.5 {1} 0" {2}/><axis xyz="{3}"/><limit lower="-1" upper="1" effort="9" velocity="1"/></joint>'
)
LEFT = STEER.format("left", 0.2, 'rpy="0 0 0"', "0 0 1")
TURNED = 'rpy="«-0.089 0 0»"'


class LeaningAxis(Rule):
    """The axis of a joint leans against that of its counterpart on the other side.

    Machines are symmetric: the axis on the right is that on the left in a mirror, or parallel to it. A car whose right
    kingpin leans pulls to one side, and a leg whose hip is turned by a few degrees puts its foot down aside. Looked at
    are joints that move, with all joints at 0; of joints that carry each other the first.
    """

    code = "JNT036"
    name = "leaning-axis"
    severity = Severity.WARNING
    remedy = """Give both joints the same `rpy` and `xyz`, but for the signs that the mirror turns.

    Across the plane of x and z the mirror turns the signs of roll and yaw, and of y. A macro of xacro with a `reflect`
    of 1 and -1 writes both sides from one set of numbers.
    """
    looks_at = (Model,)
    selects = ("urdf:robot",)
    scaffold = '<robot name="r"><link name="base"/>{}</robot>'

    bad = (
        Bad(
            LEFT + STEER.format("right", -0.2, TURNED, "0 0 1"),
            says="the axis of joint `right_steer` leans by 5.1° against that of its counterpart `left_steer`",
        ),
        Bad(LEFT + STEER.format("right", -0.2, "", "«0 0.1 1»")),
    )
    good = (
        Good(LEFT + STEER.format("right", -0.2, 'rpy="0 0 0"', "0 0 -1"), why="the sign is another matter"),
        Good(
            STEER.format("left", 0.2, 'rpy="0.1 0 0"', "0 0 1")
            + STEER.format("right", -0.2, 'rpy="-0.1 0 0"', "0 0 1"),
            why="both lean to the middle",
        ),
        Good(LEFT + STEER.format("right", -0.2, 'rpy="0.01 0 0"', "0 0 1"), why="rounded"),
    )

    @staticmethod
    def applies(model: Model) -> bool:
        return bool(leaning(model))

    def check(self, model: Model) -> Iterator[Diagnostic]:
        for joint, mirror in leaning(model):
            origin = joint.find("origin")
            axes = [[word.strip("-+") for word in each.axis.xyz.text.split()] for each in (joint, mirror)]
            rpy = origin.attribute("rpy") if origin is not None and axes[0] == axes[1] else None
            message = f"the axis of {joint.title} leans by {lean(joint, mirror):.1f}° against that of its counterpart"
            yield self.diagnostic(
                rpy or joint.axis.xyz, f"{message} `{mirror.name}`", labels={mirror: "its counterpart"}
            )


def leaning(model: Model) -> list[tuple[Joint, Joint]]:
    """The joints whose axes lean, each with its counterpart before it; none where a robot is not symmetric."""
    pairs = [
        (joint, mirror)
        for joint in model.joints
        if joint.moves
        and (mirror := joint.mirror) is not None
        and mirror.type == joint.type
        and joint.element.index > mirror.element.index
        and lean(joint, mirror) > LEAST
    ]
    links = {joint.child_name for joint, _ in pairs}
    above = {joint.child_name: joint.parent_name for joint in model.joints} if pairs else {}
    firsts = [pair for pair in pairs if not is_carried(pair[0].parent_name, links, above)]
    return firsts if len(firsts) <= MOST else []


def is_carried(link: str, links: set[str], above: dict[str, str]) -> bool:
    """Is a link one of some, or below one? ``above`` has the link above each."""
    seen = set()
    while link and link not in seen:
        if link in links:
            return True
        seen.add(link)
        link = above.get(link, "")
    return False


def lean(joint: Joint, mirror: Joint) -> float:
    """The angle (degrees) between two axes, of which one may be seen in a mirror; 0 where it is not known."""
    own, other = joint.direction, mirror.direction
    if own is None or other is None:
        return 0.0
    cosines = (
        abs(sum(one * sign * its for one, sign, its in zip(own, signs, other, strict=True)))
        for signs in MIRRORS
    )
    return degrees(acos(min(1.0, max(cosines))))

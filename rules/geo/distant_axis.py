from collections.abc import Iterator

from sdfcheck import IN_ROBOT, Bad, Diagnostic, Good, Joint, Rule, Severity
from sdfcheck_rules.geo.detached_link import detached, is_measured
from sdfcheck_rules.geo.scaffolds import wedge

LEAST = 0.02
"""m: smaller shapes only mark a link."""
TIMES = 1.5
"""Of the length of the part: of 2,763 joints in 545 public robots none turns a part that is farther than 0.8 times."""
SCHEMATIC = 10.0
"""The same in a robot without meshes, where the bob of a pendulum may be drawn without its rod."""
SPHERE = 'sphere radius="0.05"'
BALL = '<collision><origin xyz="0 0 {}"/><geometry><{}/></geometry></collision>'
WHEEL = (
    f'<link name="wheel">{BALL}</link><joint name="j" type="{{}}">{{}}<parent link="base"/><child link="wheel"/>'
    '<axis xyz="0 1 0"/><limit effort="1" velocity="1"/></joint>'
)


class DistantAxis(Rule):
    """A joint turns its part about an axis that passes far from the part.

    The axis goes through the origin of the joint, which is that of the child link, and the shapes of the child are
    farther from it than one and a half times their length, so that the part moves on a circle around nothing.
    In a robot without meshes it has to be ten times, for pendulums are drawn so. Looked at are robots in URDF, and
    links all of whose shapes have a known size.
    """

    code = "GEO020"
    name = "distant-axis"
    severity = Severity.WARNING
    remedy = """Move the joint to where the part turns, and the shapes of the child to the origin of its link.

    The `origin` of a joint is in the frame of its parent link, in meters; that of a visual or collision is in the
    frame of its own link, which begins at the joint. `sdfcheck view FILE` shows both.
    """
    looks_at = (Joint,)
    selects = ("urdf:joint",)
    scaffold = IN_ROBOT

    bad = (
        Bad(
            WHEEL.format("1.6", SPHERE, "continuous", '<origin xyz="«0 0.1 -1.6»"/>'),
            says="the axis of joint `j` passes 1.55 m from link `wheel`, which is 0.1 m long",
        ),
        Bad(
            WHEEL.format("0.6", 'mesh filename="part.obj"', "continuous", '<origin xyz="«0 0.1 -0.6»"/>'),
            files={"part.obj": wedge(0.1)},
            says="passes 0.6 m from link `wheel`",
        ),
    )
    good = (
        Good(WHEEL.format("0.6", SPHERE, "continuous", ""), why="a pendulum without its rod"),
        Good(
            WHEEL.format("0.1", 'mesh filename="part.obj"', "continuous", ""),
            files={"part.obj": wedge(0.1)},
            why="a crank",
        ),
        Good(
            f'<link name="cap">{BALL.format("0", SPHERE)}</link><joint name="k" type="fixed"><parent link="base"/>'
            '<child link="cap"/></joint>' + WHEEL.format("0.9", 'mesh filename="part.obj"', "continuous", ""),
            files={"part.obj": wedge(0.1)},
            why="detached-link says that it is far from all others",
        ),
        Good(WHEEL.format("1.6", SPHERE, "prismatic", ""), why="a slide may be anywhere beside its axis"),
    )

    @staticmethod
    def applies(joint: Joint) -> bool:
        if joint.type not in {"continuous", "revolute"} or joint.model is None or not gap(joint) > 0:
            return False
        return all(found is not joint for found, *_ in detached(joint.model))  # of which another rule speaks

    def check(self, joint: Joint) -> Iterator[Diagnostic]:
        link = joint.child_link
        assert link is not None
        assert link.fixed_extent is not None
        length = max(link.fixed_extent.size)
        origin = joint.find("origin")
        value = None if origin is None else origin.attribute("xyz")
        yield self.diagnostic(
            value or joint,
            f"the axis of {joint.title} passes {gap(joint):.3g} m from {link.title}, which is {length:.3g} m long",
            labels={link.shapes[0]: "the first of its shapes"},
        )


def gap(joint: Joint) -> float:
    """How far an axis passes from what it turns (m); 0 if that is near, or not known."""
    link, axis = joint.child_link, joint.axis.xyz
    if link is None or link.parent_joints[:1] != (joint,) or not link.shapes or not is_measured(link):
        return 0.0
    box, norm = link.fixed_extent, joint.axis.length
    if box is None or max(box.size) < LEAST or not norm > 0:
        return 0.0
    bound = (TIMES if link.model.has_mesh else SCHEMATIC) * max(box.size)
    if box.distance_to((0.0, 0.0, 0.0)) <= bound:
        return 0.0
    distance = box.distance_to_line((axis[0] / norm, axis[1] / norm, axis[2] / norm))
    return distance if distance > bound else 0.0

from collections.abc import Iterator
from contextlib import suppress
from functools import partial
from itertools import islice
from math import dist, inf

from sdfcheck import Bad, Diagnostic, Good, Joint, Link, Model, Rule, Severity
from sdfcheck_rules.geo.detached_collision import gap
from sdfcheck_rules.geo.oversized_shape import LARGEST
from sdfcheck_rules.geo.scaffolds import ARM, mesh, wedge
from sdfcheck_rules.geo.undersized_shapes import LEAST as SMALLEST

MOST = 0.35
"""Of the length of the link: of 5,000 links that joints carry, in public robots with meshes, none is farther off."""
SCHEMATIC = 10.0
"""Times the longest shape of a robot without meshes: boxes for the bobs of pendulums are up to nine times away."""
FAR = 1.0
"""m: joints that are nearer to their parents are the rule."""
LEAST = 0.01
"""m: what is nearer may be held by a part that is not drawn."""
CARRIED = 50
"""So many links that hang on one are asked for their length."""
NEAR, HIDDEN, HALF, SHARE = 0.005, 0.035, 0.5, 0.05
"""m, and of the length of the link: necks, wrists and ankles have joints inside that are not drawn. Of 441 parts that
joints carry in public robots, by their surfaces, three are farther from the rest of its robot."""
MARK = 0.001
"""m: a shape as small only shows where the robot is."""
EYE = (
    f'<link name="eye">{mesh("visual", "arm.obj")}</link><joint name="k" type="fixed"><parent link="base"/>'
    '<child link="eye"/></joint></robot>'
)


class DetachedLink(Rule):
    """A link that a joint carries touches no other link of its robot.

    Parts of a machine hang together. Where one floats, the origin of its joint, or that of its shapes, is not
    where it belongs, or is in another unit. Robots are looked at where the size of every shape is known; all joints are
    at zero. Without meshes, only what is very far away counts. On a floating joint a link is a thing of its own.
    """

    code = "GEO015"
    name = "detached-link"
    severity = Severity.WARNING
    remedy = """Move the joint to where the link meets its parent, or the shapes to the origin of the link.

    The `origin` of a joint is in the frame of its parent link, in meters; that of a visual or collision is in the
    frame of its own link. `sdfcheck view FILE` shows the gap.
    """
    looks_at = (Model,)
    selects = ("urdf:robot",)
    scaffold = ARM

    bad = (
        Bad(
            mesh("visual", "arm.obj"),
            scaffold=ARM.replace('"0 0 0.3"', '"«0 0 0.6»"'),
            files={"arm.obj": wedge(0.3)},
            says="link `arm` is 0.55 m away from all other links, and is 0.3 m long",
        ),
    )
    good = (
        Good(
            mesh("visual", "arm.obj"),
            scaffold=ARM.replace("0 0 0.3", "0 0 0.06"),
            files={"arm.obj": wedge(0.3)},
        ),
        Good(
            '<visual><geometry><box size="0.2 0.1 0.04"/></geometry></visual>',
            scaffold=ARM.replace("0 0 0.3", "0 0 -0.082").replace("</robot>", EYE),
            files={"arm.obj": wedge(0.3)},
            why="a plain shape may be smaller than its part",
        ),
        Good(
            mesh("visual", "arm.obj"),
            scaffold=ARM.replace("0.2 0.2 0.1", "1e-4 1e-4 1e-4"),
            files={"arm.obj": wedge(0.3)},
            why="the other link only shows where the robot is",
        ),
        Good(
            mesh("visual", "arm.obj") + mesh("visual", "missing.obj"),
            files={"arm.obj": wedge(0.3)},
            why="the size of the other mesh is not known",
        ),
        Good(
            '<joint name="j" type="continuous"><origin xyz="9 0 0"/></joint>',
            scaffold='<robot name="r">{}</robot>',
            why="nothing is there that could be far away",
        ),
        Good(
            mesh("visual", "arm.obj"),
            scaffold=ARM.replace("0 0 0.3", "0 0 0.6").replace("revolute", "floating"),
            files={"arm.obj": wedge(0.3)},
            why="a thing of its own",
        ),
        Good(
            mesh("visual", "missing.obj") + mesh("collision", "arm.obj"),
            scaffold=ARM.replace("0 0 0.3", "0 0 0.6"),
            files={"arm.obj": wedge(0.3)},
            why="the visual may reach farther",
        ),
    )

    @staticmethod
    def applies(model: Model) -> bool:
        return bool(detached(model))

    def check(self, model: Model) -> Iterator[Diagnostic]:
        for joint, link, distance in detached(model):
            origin = joint.find("origin")
            value = None if origin is None else origin.attribute("xyz")
            who = f"{link.title}, with what hangs on it," if link.child_joints else link.title
            yield self.diagnostic(
                value or joint,
                f"{who} is {distance:.3g} m away from all other links, and is {length(link):.3g} m long",
                labels={link: "the link", link.shapes[0]: "the first of its shapes"},
            )


def detached(model: Model) -> list[tuple[Joint, Link, float]]:
    """The links that touch none, each with the joint that carries it and its distance from the others (m)."""
    if not model.joints or not (model.has_mesh or is_spread(model)):
        return []
    drawn = [link for link in model.links if link.shapes]
    if len(drawn) < 2 or not all(map(is_measured, drawn)):
        return []
    least = LEAST if model.has_mesh else SCHEMATIC * max(map(length, drawn))
    found, touching = [], {}
    for joint in model.joints:
        link = joint.child_link
        if link is None or not holds(joint) or not link.shapes or link.parent_joints[:1] != (joint,):
            continue
        if not length(link) < LARGEST or (model.has_mesh and link.size_to_reach < SMALLEST) or gap(link):
            continue
        bound = max(least, MOST * length(link))
        others = [other for other in (joint.parent_link, *drawn) if other is not None and other is not link]
        if bound < (distance := nearest(link, others, bound)) < inf:
            found.append((joint, link, distance))
        elif link.has_mesh:
            long = max(map(length, islice(link.below(), CARRIED)))
            touching[joint] = max(NEAR, min(HIDDEN, HALF * long), SHARE * long)
    for joint, distance in model.gaps(touching).items():
        if distance and joint.child_link is not None:
            found.append((joint, joint.child_link, distance))
    return [each for each in found if has_company(each[1], drawn)]


def has_company(link: Link, drawn: list[Link]) -> bool:
    """Is there a body that does not hang on it, more than the mark of a place?"""
    parent = link.parent_joints[0].parent_link
    if parent is not None and parent.shapes and length(parent) > MARK:
        return True
    hanging = set(link.below())
    return any(length(other) > MARK for other in drawn if other not in hanging)


def is_measured(link: Link) -> bool:
    """Is the size of each of its shapes known?"""
    visual, collision = link.visual_box, link.collision_box
    return (visual is not None or not link.visuals) and (collision is not None or not link.collisions)


def holds(joint: Joint) -> bool:
    """Does a joint move, and keep its child at its parent?"""
    return joint.moves and joint.type != "floating"


def is_spread(model: Model) -> bool:
    """Is a joint so far from its parent that it is worth looking at a robot without meshes?"""
    origins = (joint.find("origin") for joint in model.joints if holds(joint))
    texts = ("" if origin is None else origin.text_of("xyz", "") for origin in origins)
    longest = 0.0
    for text in texts:
        with suppress(ValueError):
            longest = max(longest, *(abs(float(word)) for word in text.split() or ("0",)))
    return longest > FAR and longest > SCHEMATIC * max(map(length, model.links), default=0.0)


def nearest(link: Link, others: list[Link], bound: float) -> float:
    """How far the nearest link is (m); not more than the bound where one is within that, or at an unknown place."""
    shown = [other for other in others if other.shapes]
    least = link.distance_to(shown[0]) if shown else inf
    if not least > bound:  # to its parent, as mostly
        return least
    for other in sorted(shown[1:], key=partial(between_balls, link)):
        if between_balls(link, other) >= least:
            break
        least = min(least, link.distance_to(other))
    return least


def between_balls(link: Link, other: Link) -> float:
    """A distance (m) of which two links are not nearer to each other; 0 if not known."""
    own, theirs = link.ball, other.ball
    return dist(own[0], theirs[0]) - own[1] - theirs[1] if own and theirs else 0.0


def length(link: Link) -> float:
    """The greatest length of its shapes (m)."""
    return max(link.extent.size) if link.extent is not None else 0.0

from collections.abc import Iterable, Iterator
from math import dist

from sdfcheck import IN_LINK, Bad, Diagnostic, Good, Link, Rule, Severity, Shape
from sdfcheck_rules.geo.scaffolds import wedge

MOST = 0.45
"""Of the longer one: of 3,828 links in public robots three are farther apart, all of them by mistake."""
OFTEN = 0.25
"""Of the longer one: what is farther apart on one side of the robot only is a mistake as well."""
LEAST = 0.01
"""m: smaller shapes are marks."""
ALIKE, SHIFTED = 0.05, 0.15
"""Of the longest side: of 5,069 links in public robots whose collisions are as large as their visuals, 18 have them
more than that elsewhere, all of them by mistake."""
ACROSS = 0.3
"""Of the longest side: what has the sides of the other one in another order lies across it."""
TURNED = 0.01
"""Of the cosine. Of 2,667 links with one mesh for both, 13 have it elsewhere or turned, all by mistake."""
MESH = "<geometry><mesh><uri>a.obj</uri></mesh></geometry>"
VISUAL = f'<visual name="v">{MESH}</visual>'
COLLISION = f'<«collision» name="c"><pose>{{}}</pose>{MESH}</collision>'
BALL = "<geometry><sphere><radius>0.1</radius></sphere></geometry>"
FILES = {"a.obj": "v 0 0 0\nv 0.1 0.1 0.1\nv 0.1 0 0\nf 1 2 3\n"}


class DetachedCollision(Rule):
    """The collisions of a link are not where its visuals are.

    Both are the shape of one body, so they overlap, and are at one place if they are of one size. Where they are apart,
    the robot touches what it does not reach, and passes through what it does. Often the visual was moved and the
    collision not, or only one of them has the origin of its mesh corrected, or its direction. Meshes count that are on
    this computer, or the same one twice.
    """

    code = "GEO003"
    name = "detached-collision"
    severity = Severity.WARNING
    remedy = """Give the collision the pose of the visual, or the visual that of the collision.

    `sdfcheck view FILE` shows both. A mesh keeps the origin that it was exported with: where the visual has
    an offset that moves its mesh to the link, a collision from the same drawing needs the same, and a box
    around the part needs the middle of the part.
    """
    looks_at = (Link,)
    scaffold = IN_LINK

    bad = (
        Bad(
            VISUAL
            + '<«collision» name="c"><pose>0.3 0 0 0 0 0</pose><geometry><box><size>0.1 0.1 0.1</size></box>'
            "</geometry></collision>",
            files=FILES,
            says="the collision of link `base` is 0.15 m away from its visual",
        ),
        Bad(
            VISUAL + COLLISION.format("0.03 0 0 0 0 0"),
            files=FILES,
            says="the collision of link `base` is as large as its visual, and 0.03 m from where that would be",
        ),
        Bad(VISUAL + COLLISION.format("0 0 0 1.57 0 0"), says="has the mesh of its visual, turned"),
        Bad(
            f'<visual name="v">{BALL}</visual><«collision» name="c"><pose>0.08 0 0 0 0 0</pose>{BALL}</collision>',
            says="is as large as its visual, and 0.08 m from where that would be",
        ),
        Bad(
            VISUAL
            + '<«collision» name="c"><geometry><cylinder><radius>0.05</radius><length>0.6</length></cylinder>'
            "</geometry></collision>",
            files={"a.obj": wedge(0.6).replace("0.06", "0.1")},
            says="is as large as its visual, and has the longest side along another axis",
        ),
    )
    good = (
        Good(VISUAL + COLLISION.replace("«collision»", "collision").format("0.004 0 0 0 0 0"), files=FILES),
        Good(
            VISUAL
            + '<collision name="c"><pose>0.1 0 0 0 0 0</pose><geometry><box><size>0.1 0.1 0.2</size></box>'
            "</geometry></collision>",
            files=FILES,
            why="they touch",
        ),
        Good(
            '<visual name="v"><pose>0.3 0 0 0 0 0</pose><geometry><box><size>0.6 0.1 0.1</size></box></geometry>'
            f'</visual><collision name="c">{BALL}</collision>',
            why="a ball at the end of a rod",
        ),
    )

    @staticmethod
    def applies(link: Link) -> bool:
        return is_compared(link) and bool(gap(link) or shift(link) or lies_across(link) or is_turned(link))

    def check(self, link: Link) -> Iterator[Diagnostic]:
        plural = "s" if len(link.collisions) > 1 else ""
        visuals = "visuals" if len(link.visuals) > 1 else "visual"
        verb, has = ("are", "have") if plural else ("is", "has")
        text = f"{has} the mesh of its {visuals}, turned"
        if gap(link):
            text = f"{verb} {gap(link):.3g} m away from its {visuals}"
        elif shift(link):
            text = f"{verb} as large as its {visuals}, and {shift(link):.3g} m from where that would be"
        elif lies_across(link) and not has_one_mesh(link):
            text = f"{verb} as large as its {visuals}, and {has} the longest side along another axis"
        yield self.diagnostic(
            link.collisions[0],
            f"the collision{plural} of {link.title} {text}",
            labels={link.visuals[0]: "the visual"},
        )


def is_compared(link: Link) -> bool:
    """Has it both, at two places, or a mesh, whose place alone does not say where it is?"""
    if not link.has("visual") or not link.has("collision"):
        return False
    text = link.document.source
    if (text.contains("<mesh") or text.contains(":mesh")) and any(map(is_mesh, link.shapes)):
        return True
    return {shape.position for shape in link.visuals} != {shape.position for shape in link.collisions}


def is_mesh(shape: Shape) -> bool:
    return shape.geometry.shape == "mesh"


def gap(link: Link) -> float:
    """How far collisions and visuals are apart (m), where that is too much; else 0."""
    visuals, collisions = link.visual_box, link.collision_box
    if visuals is None or collisions is None:
        return 0.0
    longest = max(*visuals.size, *collisions.size)
    if min(max(visuals.size), max(collisions.size)) < LEAST:
        return 0.0
    found = visuals.distance_to(collisions)
    if found <= OFTEN * longest:
        return 0.0
    if found > MOST * longest or not any(is_apart(other) for other in link.counterparts):
        return found
    return 0.0


def is_apart(link: Link) -> bool:
    """Are visuals and collisions of this one apart as well, as if that were meant?"""
    visuals, collisions = link.visual_box, link.collision_box
    return visuals is not None and collisions is not None and visuals.distance_to(collisions) > 0


def shift(link: Link) -> float:
    """How far collisions are from visuals of the same kind and size (m), where that is too much; else 0."""
    if len(set(map(is_mesh, link.shapes))) > 1:
        return 0.0
    visuals, collisions = link.visual_box, link.collision_box
    if visuals is None or collisions is None:
        visual, collision = (shape.position for shape in (link.visuals[0], link.collisions[0]))
        found = dist(visual, collision) if has_one_mesh(link) and visual and collision else 0.0
        return found if found > LEAST else 0.0
    longest, found = max(visuals.size), dist(visuals.center, collisions.center)
    if longest < LEAST or found <= SHIFTED * longest:
        return 0.0
    return found if difference(visuals.size, collisions.size) <= ALIKE * longest else 0.0


def lies_across(link: Link) -> bool:
    """Have the boxes around its visuals and its collisions the same three sides, in another order?"""
    visuals, collisions = link.visual_box, link.collision_box
    if visuals is None or collisions is None or max(visuals.size) < LEAST:
        return False
    longest = max(visuals.size)
    if difference(sorted(visuals.size), sorted(collisions.size)) > ALIKE * longest:
        return False
    return difference(visuals.size, collisions.size) > ACROSS * longest


def difference(some: Iterable[float], others: Iterable[float]) -> float:
    """How far two lists of numbers are apart where they differ most."""
    return max(abs(one - other) for one, other in zip(some, others, strict=True))


def is_turned(link: Link) -> bool:
    """Is the mesh of its collision that of its visual, in another direction?"""
    if not has_one_mesh(link):
        return False
    visual, collision = link.visuals[0].along, link.collisions[0].along
    return (
        visual is not None
        and collision is not None
        and sum(a * b for a, b in zip(visual, collision, strict=True)) < 1 - TURNED
    )


def has_one_mesh(link: Link) -> bool:
    """Have its visual and its collision, one of each, the same mesh file?"""
    if len(link.visuals) != 1 or len(link.collisions) != 1:
        return False
    looks = [(shape.geometry.shape, shape.geometry.uri, tuple(shape.geometry.scale)) for shape in link.shapes]
    return looks[0] == looks[1] and looks[0][0] == "mesh"

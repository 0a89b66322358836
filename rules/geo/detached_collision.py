from collections.abc import Iterator

from sdfcheck import IN_LINK, Bad, Diagnostic, Good, Link, Rule, Severity

MOST = 0.45
"""Of the longer one: of 3,828 links in public robots three are farther apart, all of them by mistake."""
OFTEN = 0.25
"""Of the longer one: what is farther apart on one side of the robot only is a mistake as well."""
LEAST = 0.01
"""m: smaller shapes are marks."""
VISUAL = '<visual name="v"><geometry><mesh><uri>a.obj</uri></mesh></geometry></visual>'
FILES = {"a.obj": "v 0 0 0\nv 0.1 0.1 0.1\nv 0.1 0 0\nf 1 2 3\n"}


class DetachedCollision(Rule):
    """The collisions of a link are not where its visuals are.

    Both are the shape of one body, so they overlap. Where they are apart, the robot touches what it does not reach,
    and passes through what it does. Often the visual was moved and the collision not, or only one of them has the
    origin of its mesh corrected. Links are looked at that have a mesh which is on this computer.
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
    needs = ("<mesh", ":mesh")
    scaffold = IN_LINK

    bad = (
        Bad(
            VISUAL
            + '<«collision» name="c"><pose>0.3 0 0 0 0 0</pose><geometry><box><size>0.1 0.1 0.1</size></box>'
            "</geometry></collision>",
            files=FILES,
            says="the collision of link `base` is 0.15 m away from its visual",
        ),
    )
    good = (
        Good(
            VISUAL
            + '<collision name="c"><pose>0.1 0 0 0 0 0</pose><geometry><box><size>0.1 0.1 0.1</size></box>'
            "</geometry></collision>",
            files=FILES,
            why="they touch",
        ),
    )

    @staticmethod
    def applies(link: Link) -> bool:
        return gap(link) > 0

    def check(self, link: Link) -> Iterator[Diagnostic]:
        plural = "s" if len(link.collisions) > 1 else ""
        visuals = "visuals" if len(link.visuals) > 1 else "visual"
        verb = "are" if plural else "is"
        yield self.diagnostic(
            link.collisions[0],
            f"the collision{plural} of {link.title} {verb} {gap(link):.3g} m away from its {visuals}",
            labels={link.visuals[0]: "the visual"},
        )


def gap(link: Link) -> float:
    """How far collisions and visuals are apart (m), where that is too much; else 0."""
    if not link.has("visual") or not link.has("collision"):
        return 0.0
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

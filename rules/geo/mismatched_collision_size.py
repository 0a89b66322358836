from collections.abc import Iterator

from sdfcheck import IN_LINK, Bad, Diagnostic, Good, Link, Rule, Severity

MOST = 10.0
"""Of 3,828 links in public robots that have both, none that moves differs so much."""
REDUCED = 20.0
"""The same for plain shapes that collide for a part of the body: a rod in a hip."""
LEAST = 0.005
"""m: smaller shapes are marks of places."""
SHAPE = '<{0} name="{0}"><geometry><box><size>{1}</size></box></geometry></{0}>'
VISUAL = '<visual name="v"><geometry><mesh><uri>a.obj</uri></mesh></geometry></visual>'
FILES = {"a.obj": "v 0 0 0\nv 0.1 0.1 0.1\nv 0.1 0 0\nf 1 2 3\n"}


class MismatchedCollisionSize(Rule):
    """The collisions of a link are ten times as long as its visuals, or a tenth of them.

    Both are the shape of one body. One of them has a scale that the other lacks, or an exporter wrote
    millimeters, centimeters or inches for one. Links are looked at that have a mesh which is on this computer.
    A plain shape that collides for a part of its link may be a twentieth as long.
    """

    code = "GEO004"
    name = "mismatched-collision-size"
    severity = Severity.WARNING
    remedy = """Give the visual and the collision the same unit: compare their `scale` and sizes.

    The one that agrees with the distances between the joints (`sdfcheck graph poses FILE`) is right.
    Millimeters need a scale of 0.001, centimeters 0.01, inches 0.0254.
    """
    looks_at = (Link,)
    needs = ("<mesh", ":mesh")
    scaffold = IN_LINK

    bad = (
        Bad(
            VISUAL
            + '<«collision» name="c"><geometry><box><size>10 10 10</size></box></geometry></collision>',
            files=FILES,
            says="the collision of link `base` is 10 m long, and its visual 0.1 m",
        ),
    )
    good = (
        Good(
            VISUAL + SHAPE.format("collision", "0.5 0.5 0.5"),
            files=FILES,
            why="a safety distance",
        ),
        Good(
            VISUAL + SHAPE.format("collision", "0.007 0.007 0.007"),
            files=FILES,
            why="a plain shape for a part of the link",
        ),
        Good(
            VISUAL + SHAPE.format("collision", "0.001 0.001 0.001"),
            files=FILES,
            why="a mark, as good as no collision",
        ),
    )

    @staticmethod
    def applies(link: Link) -> bool:
        return differs(link)

    def check(self, link: Link) -> Iterator[Diagnostic]:
        visuals, collisions = link.visual_box, link.collision_box
        assert visuals is not None, "they were compared"
        assert collisions is not None, "they were compared"
        yield self.diagnostic(
            link.collisions[0],
            f"the collision of {link.title} is {max(collisions.size):.3g} m long, and its visual"
            f" {max(visuals.size):.3g} m",
            labels={link.visuals[0]: "the visual"},
        )


def differs(link: Link) -> bool:
    """Do visuals and collisions differ tenfold, and is each the shape of a body?"""
    if not link.has("visual") or not link.has("collision") or link.may_be_static or not link.has_mesh:
        return False
    if any(joint.is_fixed for joint in link.parent_joints):
        return False
    visuals, collisions = link.visual_box, link.collision_box
    if visuals is None or collisions is None or link.size_to_reach > 100:
        return False
    short, long = sorted((max(visuals.size), max(collisions.size)))
    is_plain = short < max(visuals.size) and all(shape.geometry.shape != "mesh" for shape in link.collisions)
    return short >= LEAST and long >= (REDUCED if is_plain else MOST) * short

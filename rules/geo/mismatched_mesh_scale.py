from collections.abc import Iterator

from sdfcheck import IN_LINK, IN_URDF_LINK, Bad, Diagnostic, Good, Link, Rule, Severity, Shape
from sdfcheck_rules.geo.scaffolds import mesh

MOST = 10.0
"""Of 18,970 uses of meshes in public files one pair differs so much, by mistake."""


class MismatchedMeshScale(Rule):
    """One mesh is used twice in a link, with scales that differ tenfold or more.

    A file in millimeters needs `scale="0.001 0.001 0.001"` each time it is named: in the collision as in the visual.
    """

    code = "GEO005"
    name = "mismatched-mesh-scale"
    severity = Severity.WARNING
    remedy = """Write the same `scale` each time that the link uses the mesh.

    The right one is that which makes the part as long as the real one: 0.001 for a file in millimeters, 1
    for one in meters. A property of xacro for the scale keeps both from drifting apart.
    """
    looks_at = (Link,)
    needs = ("<mesh", ":mesh")
    scaffold = IN_URDF_LINK

    bad = (
        Bad(
            mesh("visual", "arm.stl", ' scale="0.001 0.001 0.001"') + mesh("collision", "«arm.stl»"),
            says="`arm.stl` has no scale here, and 0.001 0.001 0.001 in the visual of the same link",
        ),
        Bad(
            '<visual name="v"><geometry><mesh><uri>a.stl</uri></mesh></geometry></visual>'
            '<collision name="c"><geometry><mesh><uri>a.stl</uri><scale>«0.01 0.01 0.01»</scale></mesh></geometry>'
            "</collision>",
            scaffold=IN_LINK,
            says="`a.stl` has a scale of 0.01 0.01 0.01 here, and none in the visual of the same link",
        ),
    )
    good = (
        Good(
            mesh("visual", "arm.stl", ' scale="0.001 0.001 0.001"')
            + mesh("collision", "arm.stl", ' scale="0.0011 -0.0011 0.0011"')
        ),
        Good(
            mesh("visual", "arm.stl", ' scale="0.001 0.001 0.001"') + mesh("collision", "arm_in_meters.stl"),
            why="two files",
        ),
        Good(
            mesh("visual", "cube.obj", ' scale="1.5 1 0.05"')
            + mesh("visual", "cube.obj", ' scale="0.1 0.1 0.58"'),
            why="a cube, stretched to the top and the leg of a table",
        ),
    )

    @staticmethod
    def applies(link: Link) -> bool:
        return pair(link) is not None

    def check(self, link: Link) -> Iterator[Diagnostic]:
        found = pair(link)
        if found is None:
            return
        other, shape = found
        own, their = shape.geometry.scale, other.geometry.scale
        what = f"a scale of {own.text}" if own.is_given else "no scale"
        theirs = their.text if their.is_given else "none"
        place = own.value if own.is_given else shape.geometry.uri_value
        yield self.diagnostic(
            place or shape,
            f"`{shape.geometry.uri}` has {what} here, and {theirs} in the {other.kind} of the same link",
            labels={other: "the other one"},
        )


def pair(link: Link) -> tuple[Shape, Shape] | None:
    """Two shapes of a link that use one file with scales that differ too much, the second one the faulty one's."""
    seen: dict[str, Shape] = {}
    for shape in link.shapes:
        geometry = shape.geometry
        scale = geometry.scale
        if geometry.shape != "mesh" or not geometry.uri or len(scale) != 3 or not all(scale):
            continue
        other = seen.setdefault(geometry.uri, shape)
        factors = [abs(own / their) for own, their in zip(scale, other.geometry.scale, strict=True)]
        if min(factors) >= MOST or max(factors) <= 1 / MOST:
            return other, shape
    return None

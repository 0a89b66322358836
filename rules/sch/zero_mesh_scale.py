from collections.abc import Iterator

from sdfcheck import (
    IN_URDF_LINK,
    IN_VISUAL,
    Bad,
    Consumer,
    Diagnostic,
    Geometry,
    Good,
    Rule,
    Severity,
    Vector,
    Visual,
    accepts,
)

MESH = "<geometry><mesh><uri>https://example.org/m.dae</uri><scale>{}</scale></mesh></geometry>"


class ZeroMeshScale(Rule):
    """A mesh is scaled by zero, so that nothing is left of it.

    One zero makes it flat, without volume; three make it a point. Drake refuses such a mesh, and MuJoCo
    one that is to collide.
    """

    code = "SCH023"
    name = "zero-mesh-scale"
    severity = Severity.WARNING
    remedy = """Write a scale other than 0 for each of the three axes: `1 1 1` if the mesh is in meters.

    A mesh in millimeters has `0.001 0.001 0.001`. For a flat thing, use a thin box or a plane.
    """
    looks_at = (Geometry,)
    needs = ("<mesh",)
    scaffold = IN_VISUAL

    bad = (
        Bad(MESH.format("«1 1 0»"), says="`scale` of the mesh has a zero: 1 1 0"),
        Bad(
            '<visual><geometry><mesh filename="package://arm/m.stl" scale="«0 0 0»"/></geometry></visual>',
            scaffold=IN_URDF_LINK,
        ),
    )
    good = (Good(MESH.format("1 -1 1"), why="mirrored"), Good(MESH.format("0.001 0.001 0.001")))

    @staticmethod
    def applies(geometry: Geometry) -> bool:
        return geometry.has("mesh") and 0 in scale(geometry)

    def check(self, geometry: Geometry) -> Iterator[Diagnostic]:
        factors = scale(geometry)
        is_seen_only = geometry.within(Visual) is not None
        affects = {Consumer.MUJOCO: accepts("does not read visuals")} if is_seen_only else {}
        yield self.diagnostic(factors, f"`scale` of the mesh has a zero: {factors.text}", affects=affects)


def scale(geometry: Geometry) -> Vector:
    """The factors of its mesh."""
    mesh = geometry.find("mesh")
    value = None if mesh is None else mesh.value("scale")
    return Vector.of(value, geometry.element, (1.0, 1.0, 1.0))

from collections.abc import Iterator

from sdfcheck import IN_URDF_LINK, Bad, Collision, Diagnostic, Good, Rule, Severity
from sdfcheck_rules.geo.scaffolds import mesh, triangles

MOST = 200_000
"""Triangles: MuJoCo takes no more for a mesh in STL."""


class DenseCollisionMesh(Rule):
    """A collision is a mesh of more than 200,000 triangles.

    Contacts are searched for triangle by triangle, at each step. The convex hull of the part, or a few boxes, are
    found a thousand times as fast, and seldom worse. The number is that of MuJoCo, which takes STL files up to it.
    """

    code = "GEO007"
    name = "dense-collision-mesh"
    severity = Severity.INFO
    remedy = """Replace the collision mesh by its convex hull, or by a few boxes, cylinders and spheres.

    A hull of 50 to 200 faces is enough for most links: MeshLab (Filters, Remeshing, Convex Hull and Quadric
    Edge Collapse Decimation) and Blender make one. A part that is not convex, such as a gripper, is split
    into several convex ones. The visual keeps its fine mesh.
    """
    looks_at = (Collision,)
    needs = ("<mesh", ":mesh")
    scaffold = IN_URDF_LINK

    bad = (
        Bad(
            mesh("collision", "«arm.dae»"),
            files={"arm.dae": triangles(250_000)},
            says="the mesh `arm.dae` has 250000 triangles",
        ),
    )
    good = (
        Good(
            mesh("visual", "arm.dae"),
            files={"arm.dae": triangles(250_000)},
            why="visuals cost little",
        ),
        Good(mesh("collision", "arm.dae"), files={"arm.dae": triangles(2_000)}),
    )

    @staticmethod
    def applies(collision: Collision) -> bool:
        read = collision.geometry.mesh if collision.geometry.shape == "mesh" else None
        return read is not None and read.triangles > MOST

    def check(self, collision: Collision) -> Iterator[Diagnostic]:
        geometry = collision.geometry
        assert geometry.mesh is not None, "it was counted"
        name = geometry.uri.rpartition("/")[2]
        message = f"the mesh `{name}` has {geometry.mesh.triangles} triangles, too many for a collision"
        yield self.diagnostic(geometry.uri_value or collision, message)

from collections.abc import Iterator
from pathlib import PurePosixPath

from sdfcheck import IN_URDF_LINK, Bad, Diagnostic, Good, Resource, Rule, Severity, listed

FORMATS = (".cdf", ".dae", ".obj", ".stl", ".vtk")
"""The endings that PyBullet 3.2.7 takes, in either case."""
MESH = '<visual><geometry><mesh filename="{}"/></geometry></visual>'


class UnreadMeshFormat(Rule):
    """A mesh of a URDF file has an ending that PyBullet does not know.

    PyBullet decides by the ending of the name, and refuses the robot for any other than `.obj`, `.stl`, `.dae`,
    `.vtk` and `.cdf`, whether the file is there or not: glTF, PLY and USD among them.
    """

    code = "GEO019"
    name = "unread-mesh-format"
    severity = Severity.ERROR
    remedy = """Convert the mesh to `.obj` or `.stl`, which all consumers read, and name that file.

    Blender, MeshLab and assimp (`assimp export arm.glb arm.obj`) do so.
    """
    default = False
    looks_at = (Resource,)
    scaffold = IN_URDF_LINK

    bad = (
        Bad(
            MESH.format("«https://example.org/arm.gltf»"),
            says="a mesh that ends with `.gltf` makes PyBullet refuse the file; it reads .cdf, .dae, .obj, .stl",
        ),
        Bad(MESH.format("«https://example.org/arm.PLY»").replace("visual>", "collision>")),
    )
    good = (
        Good(MESH.format("https://example.org/arm.OBJ")),
        Good("<visual><geometry><box size='1 1 1'/></geometry></visual>"),
    )

    @staticmethod
    def applies(resource: Resource) -> bool:
        if not resource.is_urdf or resource.is_extension or resource.what != "mesh":
            return False
        return PurePosixPath(resource.uri).suffix.lower() not in FORMATS and "${" not in resource.uri

    def check(self, resource: Resource) -> Iterator[Diagnostic]:
        suffix = PurePosixPath(resource.uri).suffix.lower()
        ending = f"ends with `{suffix}`" if suffix else "has no ending"
        message = f"a mesh that {ending} makes PyBullet refuse the file; it reads {listed(FORMATS)}"
        yield self.diagnostic(resource.uri_value, message)

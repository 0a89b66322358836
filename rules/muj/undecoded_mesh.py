from collections.abc import Iterator
from pathlib import PurePosixPath

from sdfcheck import IN_URDF_LINK, Bad, Diagnostic, Good, Model, Rule, Severity, Value, used
from sdfcheck_rules.muj.meshes import mesh_files

MESH = '<collision><geometry><mesh filename="{}"/></geometry></collision>'
DECODED = frozenset((".msh", ".obj", ".stl"))


class UndecodedMesh(Rule):
    """A collision mesh is of a format that MuJoCo does not decode.

    It reads `.stl`, `.obj` and its own `.msh`, in either case of the letters, and refuses the robot
    for any other, `.dae` above all.
    """

    code = "MUJ002"
    name = "undecoded-mesh"
    severity = Severity.ERROR
    remedy = """Convert the mesh to `.stl` or `.obj`, for the collision at least.

    Blender, MeshLab and assimp (`assimp export arm.dae arm.stl`) do so. Mind the unit and the upright axis
    that a COLLADA file declares: STL has neither.
    """
    default = False
    looks_at = (Model,)
    scaffold = IN_URDF_LINK

    bad = (Bad(MESH.format("«meshes/arm.dae»"), says="a `.dae` file cannot be a collision in MuJoCo"),)
    good = (
        Good(MESH.format("meshes/arm.STL")),
        Good(MESH.format("meshes/arm.dae").replace("collision", "visual"), why="visuals are not read"),
    )

    @staticmethod
    def applies(model: Model) -> bool:
        return bool(_by_suffix(model))

    def check(self, model: Model) -> Iterator[Diagnostic]:
        for suffix, values in sorted(_by_suffix(model).items()):
            what = f"a `{suffix}` file" if suffix else "a file without suffix"
            message = (
                f"{what} cannot be a collision in MuJoCo{used(len(values))}, which reads .stl, .obj and .msh"
            )
            yield self.diagnostic(values[0], message)


def _by_suffix(model: Model) -> dict[str, list[Value]]:
    """The meshes of a format that is not decoded."""
    found: dict[str, list[Value]] = {}
    for value in mesh_files(model) if model.is_urdf else ():
        suffix = PurePosixPath(value.text.strip()).suffix.lower()
        if suffix not in DECODED:
            found.setdefault(suffix, []).append(value)
    return found

from collections.abc import Iterator
from pathlib import PurePosixPath

from sdfcheck import IN_URDF_LINK, Bad, Diagnostic, Geometry, Good, Model, Rule, Severity, Value, used
from sdfcheck_rules.muj.meshes import meshes

MESH = '<collision><geometry><mesh filename="{}"/></geometry></collision>'
DECODED = frozenset((".msh", ".obj", ".stl"))
MOST = 200_000
"""Triangles of an STL file."""
TRIANGLE = "\0" * 80 + "\1\0\0\0" + "\0" * 50
FLAT, HULL, BOX = "a flat mesh", "which makes a convex hull of it", "write a thin `<box>` in its place"
READ = f"which reads binary .stl up to {MOST} triangles, .obj and .msh"
SQUARE = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3\nf 1 3 4\n"
TEXT = """solid a
facet normal 0 0 1
outer loop
vertex 0 0 0
vertex 1 0 0
vertex 0 1 0
endloop
endfacet
endsolid a
"""


class UndecodedMesh(Rule):
    """A collision mesh is in a form that MuJoCo does not decode.

    It reads `.stl`, `.obj` and its own `.msh`, in either case of the letters, and refuses the robot
    for any other, `.dae` above all. An STL file has to be binary, to have as many bytes as its header says, and at
    most 200,000 triangles. A mesh in one plane is refused in each form.
    """

    code = "MUJ002"
    name = "undecoded-mesh"
    severity = Severity.ERROR
    remedy = """Convert the mesh to a binary `.stl` or to `.obj`, for the collision at least.

    Blender, MeshLab and assimp (`assimp export arm.dae arm.stl`) do so. Mind the unit and the upright axis
    that a COLLADA file declares: STL has neither. A mesh with too many triangles is made smaller in MeshLab (Filters,
    Remeshing, Quadric Edge Collapse Decimation), or replaced by its convex hull. In place of a flat one write a thin
    `<box>`.
    """
    default = False
    looks_at = (Model,)
    scaffold = IN_URDF_LINK

    bad = (
        Bad(MESH.format("«meshes/arm.dae»"), says="a `.dae` file cannot be a collision in MuJoCo"),
        Bad(
            MESH.format("«arm.stl»"),
            files={"arm.stl": TEXT},
            says="an STL file that is a text, or longer than its header says, cannot be a collision in MuJoCo",
        ),
        Bad(MESH.format("«arm.stl»"), files={"arm.stl": TRIANGLE + "\0"}, says="longer than its header says"),
        Bad(
            MESH.format("«lid.obj»"),
            files={"lid.obj": SQUARE},
            says="a flat mesh cannot be a collision in MuJoCo",
        ),
    )
    good = (
        Good(MESH.format("meshes/arm.STL")),
        Good(MESH.format("arm.stl"), files={"arm.stl": TRIANGLE}),
        Good(
            MESH.format("lid.obj"),
            files={"lid.obj": SQUARE + "v 0 0 1\nf 1 2 5\n"},
            why="a point is above it",
        ),
        Good(MESH.format("meshes/arm.dae").replace("collision", "visual"), why="visuals are not read"),
    )

    @staticmethod
    def applies(model: Model) -> bool:
        return bool(undecoded(model))

    def check(self, model: Model) -> Iterator[Diagnostic]:
        for what, values in sorted(undecoded(model).items()):
            why, advice = (HULL, BOX) if what.startswith(FLAT) else (READ, None)
            yield self.diagnostic(values[0], f"{what}{used(len(values))}, {why}", help=advice)


def undecoded(model: Model) -> dict[str, list[Value]]:
    """The forms that cannot be a collision, in words → the meshes of that form."""
    found: dict[str, list[Value]] = {}
    for geometry in meshes(model) if model.is_urdf else ():
        if (value := geometry.uri_value) is not None and (what := form(geometry, value)):
            found.setdefault(f"{what} cannot be a collision in MuJoCo", []).append(value)
    return found


def form(geometry: Geometry, value: Value) -> str:
    """The form of a mesh that is not decoded; empty for one that is, or that is not here."""
    suffix = PurePosixPath(value.text.strip()).suffix.lower()
    if suffix not in DECODED:
        return f"a `{suffix}` file" if suffix else "a file without suffix"
    mesh = geometry.mesh
    if mesh is None or mesh.fault:
        return ""
    if suffix == ".stl" and mesh.format == "STL":
        if mesh.triangles > MOST:
            return f"an STL file of {mesh.triangles} triangles"
        if not mesh.is_exact:
            return "an STL file that is a text, or longer than its header says,"
    return FLAT if mesh.bounds is not None and mesh.bounds.size.count(0) == 1 else ""

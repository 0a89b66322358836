from collections.abc import Iterator

from sdfcheck import IN_URDF_LINK, REFUSES, Bad, Consumer, Diagnostic, Good, Rule, Severity, problems, used

MESH = '<collision><geometry><mesh filename="{}"/></geometry></collision>'


class UndecodedMesh(Rule):
    """A collision mesh is of a format that MuJoCo does not decode.

    It reads `.stl`, `.obj` and its own `.msh`, in either case of the letters, and refuses the robot
    for any other, `.dae` above all.
    """

    code = "MUJ002"
    name = "undecoded-mesh"
    severity = Severity.ERROR
    default = False
    affects = {Consumer.MUJOCO: REFUSES}
    explains = (problems.UndecodedMesh,)
    scaffold = IN_URDF_LINK

    bad = (Bad(MESH.format("«meshes/arm.dae»"), says="a `.dae` file cannot be a collision in MuJoCo"),)
    good = (
        Good(MESH.format("meshes/arm.STL")),
        Good(MESH.format("meshes/arm.dae").replace("collision", "visual"), why="visuals are not read"),
    )

    def check(self, problem: problems.UndecodedMesh) -> Iterator[Diagnostic]:
        what = f"a `{problem.suffix}` file" if problem.suffix else "a file without suffix"
        message = (
            f"{what} cannot be a collision in MuJoCo{used(problem.uses)}, which reads .stl, .obj and .msh"
        )
        yield self.diagnostic(problem.value, message)

from collections.abc import Iterator

from sdfcheck import IN_URDF_LINK, REFUSES, Bad, Consumer, Diagnostic, Good, Rule, Severity, problems, used

MESH = '<collision><geometry><mesh filename="{}"/></geometry></collision>'


class UnopenedMesh(Rule):
    """A collision mesh is named by a URI, which MuJoCo takes for a path.

    It looks for a folder `package:` beside the file, and refuses the robot. With
    `<mujoco><compiler strippath="true" meshdir="meshes"/></mujoco>` in the robot it takes the name of
    the file alone, and looks for it in one folder. Visuals are not read unless `discardvisual`
    is false.
    """

    code = "MUJ001"
    name = "unopened-mesh"
    severity = Severity.ERROR
    default = False
    affects = {Consumer.MUJOCO: REFUSES}
    explains = (problems.UnopenedMesh,)
    scaffold = IN_URDF_LINK

    bad = (
        Bad(
            MESH.format("«package://p/a.stl»") + MESH.format("package://p/b.stl"),
            says="`package:` is the name of a folder to MuJoCo (used 2 times)",
        ),
    )
    good = (
        Good(MESH.format("meshes/a.stl")),
        Good(MESH.format("package://p/a.stl").replace("collision", "visual"), why="visuals are not read"),
        Good(
            '<robot name="r"><mujoco><compiler strippath="true"/></mujoco><link name="a">'
            + MESH.format("package://p/a.stl")
            + "</link></robot>",
            scaffold="",
            why="the path is taken off",
        ),
    )

    def check(self, problem: problems.UnopenedMesh) -> Iterator[Diagnostic]:
        yield self.diagnostic(
            problem.value,
            f"`{problem.scheme}:` is the name of a folder to MuJoCo{used(problem.uses)}",
            help='give a path, or add <mujoco><compiler strippath="true" meshdir="…"/></mujoco> to the robot',
        )

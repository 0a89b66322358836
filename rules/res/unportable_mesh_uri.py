from collections.abc import Iterator

from sdfcheck import IN_URDF_LINK, Bad, Consumer, Diagnostic, Good, Rule, Severity, problems, used, warns

MESH = '<visual><geometry><mesh filename="{}"/></geometry></visual>'


class UnportableMeshUri(Rule):
    """The address of a mesh in a URDF is one that not all readers of URDF resolve.

    ROS programs such as RViz know `package://`, `file://` and web addresses; a relative
    path or `model://` shows no mesh there. Drake, MuJoCo and Gazebo do resolve relative
    paths. Told once for each kind of address.
    """

    code = "RES013"
    name = "unportable-mesh-uri"
    severity = Severity.INFO
    affects = {Consumer.URDFDOM: warns("hands the address on to programs that do not resolve it")}
    explains = (problems.UnportableUri,)
    scaffold = IN_URDF_LINK

    bad = (
        Bad(MESH.format("«meshes/arm.stl»"), says="relative path"),
        Bad(
            MESH.format("«model://arm/a.stl»") + MESH.format("model://arm/b.stl"),
            says="(used 2 times) is not resolved",
        ),
    )
    good = (Good(MESH.format("package://arm/meshes/arm.stl")), Good(MESH.format("file:///opt/arm.stl")))

    def check(self, problem: problems.UnportableUri) -> Iterator[Diagnostic]:
        what = f"`{problem.scheme}://`" if problem.scheme else "a relative path"
        message = f"{what}{used(len(problem.uses))} is not resolved by ROS programs"
        yield self.diagnostic(problem.value, message, help="`package://` is understood more widely")

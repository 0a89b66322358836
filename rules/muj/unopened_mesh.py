from collections.abc import Iterator

from sdfcheck import IN_URDF_LINK, Bad, Diagnostic, Good, Model, Rule, Severity, Value, used
from sdfcheck_rules.muj.meshes import compiler, mesh_files

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
    remedy = """Give a path relative to the file, or add `<compiler strippath="true" meshdir="…"/>` in `<mujoco>`.

    The block is a child of `<robot>`, and other consumers of URDF ignore it:
    `<mujoco><compiler strippath="true" meshdir="meshes"/></mujoco>`. With `strippath` all meshes have to be
    in that one folder and differ in name. `sdfcheck convert` writes addresses with `--uri-style relative`.
    """
    default = False
    looks_at = (Model,)
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
        Good(
            '<robot name="r"><mujoco><compiler meshdir="m"/></mujoco><link name="a">'
            + MESH.format("package://p/a.stl")
            + "</link></robot>",
            scaffold="",
            why="unstripped-path owns a folder that is not reached",
        ),
    )

    @staticmethod
    def applies(model: Model) -> bool:
        return bool(_by_scheme(model))

    def check(self, model: Model) -> Iterator[Diagnostic]:
        for scheme, values in sorted(_by_scheme(model).items()):
            yield self.diagnostic(
                values[0],
                f"`{scheme}:` is the name of a folder to MuJoCo{used(len(values))}",
            )


def _by_scheme(model: Model) -> dict[str, list[Value]]:
    """The meshes whose address has a scheme, unless MuJoCo is set to take the name of the file alone."""
    found: dict[str, list[Value]] = {}
    settings = compiler(model)
    if not model.is_urdf or settings.get("strippath") == "true" or "meshdir" in settings:
        return found
    for value in mesh_files(model):
        scheme, delimiter, _ = value.text.strip().partition(":/")
        if delimiter:
            found.setdefault(scheme, []).append(value)
    return found

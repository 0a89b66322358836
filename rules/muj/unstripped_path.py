from collections.abc import Iterator

from sdfcheck import IN_URDF_LINK, Bad, Diagnostic, Good, Model, Rule, Severity, Value, used
from sdfcheck_rules.muj.meshes import compiler, mesh_files

MESH = '<collision><geometry><mesh filename="{}"/></geometry></collision>'
ROBOT = '<robot name="r"><mujoco><compiler {}/></mujoco><link name="a">{}</link></robot>'


class UnstrippedPath(Rule):
    """A robot names the folder of its meshes for MuJoCo, and its meshes name theirs as well.

    MuJoCo 4.0 puts `meshdir` before the whole `filename`, so it looks for `meshes/meshes/arm.stl`, or for a
    folder `package:`, and refuses the robot (measured). Older releases took the path off the names of URDF by
    themselves; `strippath="true"` says so for all of them.
    """

    code = "MUJ008"
    name = "unstripped-path"
    severity = Severity.WARNING
    remedy = """Write `<compiler strippath="true" meshdir="…"/>`.

    All meshes then have to be in that folder, and differ in name. Or drop `meshdir`, and write paths from the
    folder of the robot.
    """
    looks_at = (Model,)
    needs = ("meshdir",)

    bad = (
        Bad(
            ROBOT.format('meshdir="«./meshes»"', MESH.format("meshes/a.stl") + MESH.format("meshes/b.stl")),
            says="`meshes/a.stl` (used 2 times) is not in `./meshes` for MuJoCo 4, which keeps the path of a mesh",
        ),
        Bad(
            ROBOT.format('meshdir="«../meshes/»"', MESH.format("package://p/meshes/a.stl")),
            says="`package://p/meshes/a.stl` is not in `../meshes/` for MuJoCo 4",
        ),
    )
    good = (
        Good(ROBOT.format('meshdir="meshes" strippath="true"', MESH.format("meshes/a.stl"))),
        Good(ROBOT.format('meshdir="meshes"', MESH.format("a.stl"))),
        Good(ROBOT.format('meshdir="../meshes"', MESH.format("../meshes/a.stl")), why="it leads there"),
        Good(
            ROBOT.format('meshdir="meshes"', MESH.format("meshes/a.stl").replace("collision", "visual")),
            why="visuals are not read",
        ),
        Good(MESH.format("meshes/a.stl"), scaffold=IN_URDF_LINK),
    )

    @staticmethod
    def applies(model: Model) -> bool:
        return bool(unreached(model))

    def check(self, model: Model) -> Iterator[Diagnostic]:
        folder, found = folder_of(model), unreached(model)
        assert folder is not None, "it was compared"
        message = f"`{found[0].text.strip()}`{used(len(found))} is not in `{folder.text}` for MuJoCo 4"
        labels = {found[0]: "the first of the meshes"}
        yield self.diagnostic(folder, f"{message}, which keeps the path of a mesh", labels=labels)


def folder_of(model: Model) -> Value | None:
    """The folder of the meshes, with its place."""
    blocks = (each for extension in model.children("mujoco") for each in extension.children("compiler"))
    return next((each.attribute("meshdir") for each in blocks if "meshdir" in each.attributes), None)


def unreached(model: Model) -> list[Value]:
    """The meshes whose name has a scheme, or begins with the folder that MuJoCo puts before it."""
    settings = compiler(model)
    folder = settings.get("meshdir", "").removeprefix("./").rstrip("/")
    if not model.is_urdf or not folder or settings.get("strippath") == "true":
        return []
    again = "/" if folder.startswith("..") else f"{folder}/"
    names = ((value, value.text.strip().removeprefix("./")) for value in mesh_files(model))
    return [value for value, name in names if ":/" in name or name.startswith(again)]

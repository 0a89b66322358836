from collections.abc import Iterator

from sdfcheck import IN_URDF_LINK, Bad, Diagnostic, Good, Model, Rule, Severity, Value
from sdfcheck_rules.muj.meshes import compiler, mesh_files

SETTING = '<mujoco><compiler strippath="true" meshdir="meshes"/></mujoco>'
MESH = '<collision><geometry><mesh filename="{}"/></geometry></collision>'
ROBOT = f'<robot name="r">{SETTING}<link name="a">{{}}</link></robot>'


class MergedMeshes(Rule):
    """Two meshes have the same name in different folders, and MuJoCo is set to take the name alone.

    With `strippath="true"` it drops the folders, and both links get the shape of one file, without a word
    (measured with MuJoCo 4.0). Other names, or `strippath="false"` and paths from the file, keep them apart.
    """

    code = "MUJ006"
    name = "merged-meshes"
    severity = Severity.ERROR
    remedy = """Give the files different names.

    Or set `strippath` to false, and write paths from the folder of the robot, without `package://`.
    """
    looks_at = (Model,)
    needs = ("strippath",)

    bad = (
        Bad(
            ROBOT.format(MESH.format("left/tip.stl") + MESH.format("«right/tip.stl»")),
            says="`right/tip.stl` and `left/tip.stl` are one file to MuJoCo, which drops their folders",
        ),
    )
    good = (
        Good(
            MESH.format("left/tip.stl") + MESH.format("right/tip.stl"),
            scaffold=IN_URDF_LINK,
            why="folders are kept",
        ),
        Good(ROBOT.format(MESH.format("left/tip.stl") * 2), why="one file"),
        Good(ROBOT.format(MESH.format("left/tip.stl") + MESH.format("left/base.stl"))),
    )

    @staticmethod
    def applies(model: Model) -> bool:
        return bool(merged(model))

    def check(self, model: Model) -> Iterator[Diagnostic]:
        for value, first in merged(model):
            yield self.diagnostic(
                value,
                f"`{value.text.strip()}` and `{first.text.strip()}` are one file to MuJoCo, which drops their folders",
                labels={first: "the other file"},
            )


def merged(model: Model) -> list[tuple[Value, Value]]:
    """The meshes whose name another one in another folder has, each path once, with that one."""
    if not model.is_urdf or compiler(model).get("strippath") != "true":
        return []
    first: dict[str, Value] = {}
    found: dict[str, tuple[Value, Value]] = {}
    for value in mesh_files(model):
        path = value.text.strip()
        earlier = first.setdefault(path.rpartition("/")[2], value)
        if earlier.text.strip() != path:
            found.setdefault(path, (value, earlier))
    return list(found.values())

from collections.abc import Iterator

from sdfcheck import Bad, Diagnostic, Good, Root, Rule, Severity

MODEL = '<model name="map"><link name="l"/></model>'
LIGHT = '<light name="sun" type="directional"/>'
WORLD = ".world"
PARTS = ("model", "light", "actor")


class MissingWorld(Rule):
    """A file that is named as a world holds a model, and no world.

    Gazebo Classic reads the worlds of such a file alone, and starts an empty one; the new Gazebo before Garden ends.
    Later releases put the model into a world of their own, without ground and sun. Programs that make a world of a map
    write such files.
    """

    code = "SCH043"
    name = "missing-world"
    severity = Severity.WARNING
    remedy = """Put the models into `<world name="…">`.

    With `<include><uri>model://ground_plane</uri></include>` and that of `model://sun`, if they are to stand and to be
    seen. A file of a model alone is called `model.sdf`.
    """
    looks_at = (Root,)
    scaffold = '<sdf version="1.6">{}</sdf>'

    bad = (
        Bad(
            f'<«sdf» version="1.6">{MODEL}</sdf>',
            scaffold="",
            file=f"map{WORLD}",
            says="`map.world` has no `<world>`, and Gazebo Classic starts an empty one",
        ),
    )
    good = (
        Good(f'<world name="w">{MODEL}</world>', file=f"map{WORLD}"),
        Good(MODEL, file="map.sdf", why="the file of a model"),
    )

    @staticmethod
    def applies(root: Root) -> bool:
        if root.is_urdf or root.document.path.suffix != WORLD or root.element.name != "sdf":
            return False
        return not root.has("world") and any(map(root.has, PARTS))

    def check(self, root: Root) -> Iterator[Diagnostic]:
        message = f"`{root.document.path.name}` has no `<world>`, and Gazebo Classic starts an empty one"
        yield self.diagnostic(root, message, help="put what it holds into a `<world>`")

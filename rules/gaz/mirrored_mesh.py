from collections.abc import Iterator

from sdfcheck import IN_WORLD, Bad, Diagnostic, Geometry, Good, Plugin, Root, Rule, Severity, used

PHYSICS = '<plugin filename="gz-sim-physics-system" name="gz::sim::systems::Physics"/>'
CUP = (
    '<model name="m"><static>true</static><link name="l"><collision name="c"><geometry><mesh>'
    "<uri>https://example.org/m.dae</uri><scale>{}</scale></mesh></geometry></collision></link></model>"
)


class MirroredMesh(Rule):
    """A mesh is mirrored by a negative scale, and is for the new Gazebo.

    The new Gazebo scales the corners of a mesh and leaves the order of those of each face: the mirrored mesh is turned
    inside out. As a visual it is seen through, and as a collision it is refused or pushes inwards. Gazebo Classic,
    RViz and MuJoCo turn the faces as well.
    """

    code = "GAZ027"
    name = "mirrored-mesh"
    severity = Severity.WARNING
    remedy = """Give the mirrored mesh a file of its own, and scale that by positive numbers.

    MeshLab (Filters, Transform: Scale with -1, then Invert Faces Orientation), Blender and `trimesh` write one.
    """
    looks_at = (Root,)
    needs = ("<scale", "scale=")
    scaffold = IN_WORLD

    bad = (Bad(PHYSICS + CUP.format("«1 1 -1»"), says="turns a mesh that is mirrored by `scale` inside out"),)
    good = (
        Good(PHYSICS + CUP.format("1 -1 -1"), why="twice mirrored is turned"),
        Good(CUP.format("1 1 -1"), why="nothing says that it is for the new Gazebo"),
    )

    @staticmethod
    def applies(root: Root) -> bool:
        return bool(mirrored(root))

    def check(self, root: Root) -> Iterator[Diagnostic]:
        first, *others = mirrored(root)
        message = f"the new Gazebo turns a mesh that is mirrored by `scale` inside out{used(1 + len(others))}"
        yield self.diagnostic(first.scale, message)


def mirrored(root: Root) -> list[Geometry]:
    """The meshes with an odd number of negative factors, in a file whose plugins are for the new Gazebo."""
    found = [each for each in root.each(Geometry) if each.shape == "mesh" and is_mirrored(each)]
    plugins = [plugin.generation for plugin in root.each(Plugin) if plugin.generation] if found else []
    return found if plugins and all(each == "gz" for each in plugins) else []


def is_mirrored(geometry: Geometry) -> bool:
    return sum(factor < 0 for factor in geometry.scale) % 2 == 1

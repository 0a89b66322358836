from collections.abc import Iterator

from sdfcheck import IN_WORLD, Actor, Bad, Diagnostic, Good, Resource, Rule, Severity
from sdfcheck_rules.drk.scaffolds import COLLISION, ROBOT_LINK

SCHEMES = ("http://", "https://", "fuel://")
MESH = "<geometry><mesh><uri>{}</uri></mesh></geometry>"


class RemoteMesh(Rule):
    """A mesh is on a server, from which Drake fetches nothing.

    Drake knows the schemes `file`, `model` and `package` alone and refuses the file for any
    other. Gazebo fetches meshes from Fuel by itself.
    """

    code = "DRK022"
    name = "remote-mesh"
    severity = Severity.ERROR
    remedy = """Download the mesh, and name the copy by a path or `package://`.

    `gz fuel download -u URL` fetches models of Fuel. Beside the file, a relative path is enough.
    """
    default = False
    looks_at = (Resource,)
    scaffold = COLLISION

    bad = (
        Bad(
            MESH.format("«https://example.org/arm.obj»"),
            says="no mesh is fetched from `https://`: Drake refuses the file",
        ),
        Bad(
            '<visual><geometry><mesh filename="«http://example.org/arm.obj»"/></geometry></visual>',
            says="no mesh is fetched from `http://`",
            scaffold=ROBOT_LINK,
        ),
    )
    good = (
        Good(MESH.format("package://arm/meshes/arm.obj"), why="found in the package map"),
        Good(MESH.format("model://arm/meshes/arm.obj"), why="means the same"),
        Good(
            '<actor name="a"><skin><filename>https://example.org/walk.dae</filename></skin></actor>',
            why="Drake ignores actors",
            scaffold=IN_WORLD,
        ),
    )

    @staticmethod
    def applies(resource: Resource) -> bool:
        if resource.is_extension or resource.within(Actor) is not None:
            return False
        return resource.what == "mesh" and resource.uri.startswith(SCHEMES)

    def check(self, resource: Resource) -> Iterator[Diagnostic]:
        scheme = resource.uri.partition("://")[0]
        message = f"no mesh is fetched from `{scheme}://`: Drake refuses the file"
        yield self.diagnostic(resource.uri_value, message)

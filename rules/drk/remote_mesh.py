import os
from collections.abc import Iterator

from sdfcheck import IN_WORLD, Actor, Bad, Diagnostic, Good, Include, Resource, Rule, Severity
from sdfcheck_rules.drk.scaffolds import COLLISION, ROBOT_LINK

SCHEMES = ("http://", "https://", "fuel://")
OBJ = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\nf 1 2 4\nf 1 3 4\nf 2 3 4\n"
MESH = "<geometry><mesh><uri>{}</uri></mesh></geometry>"


class RemoteMesh(Rule):
    """A mesh is on a server, from which Drake fetches nothing, or where Drake does not look for it.

    Drake knows the schemes `file`, `model` and `package` alone and refuses the file for any
    other. Gazebo fetches meshes from Fuel by itself. In `file://meshes/arm.obj` the server is `meshes`: Drake takes
    `file:///` with an absolute path alone, and Gazebo the rest as a path. A path without a scheme leads from the file
    for Drake, and for Gazebo also from each folder with models.
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
        Bad(
            MESH.format("«file://arm.obj»"),
            files={"arm.obj": OBJ},
            says="`file:` takes an absolute path behind three slashes: Drake refuses the file",
        ),
        Bad(
            MESH.format("«arm/arm.obj»"),
            files={"models/arm/arm.obj": OBJ},
            says="`arm/arm.obj` does not lead from the file to the mesh: Drake refuses the file",
        ),
    )
    good = (
        Good(MESH.format("arm/arm.obj"), files={"arm/arm.obj": OBJ}),
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
        is_odd = resource.uri.startswith(SCHEMES) or is_on_host(resource) or is_elsewhere(resource)
        return resource.what == "mesh" and is_odd

    def check(self, resource: Resource) -> Iterator[Diagnostic]:
        scheme = resource.uri.partition("://")[0]
        message = f"no mesh is fetched from `{scheme}://`: Drake refuses the file"
        advice = None
        if is_on_host(resource):
            message = "`file:` takes an absolute path behind three slashes: Drake refuses the file"
            advice = "name it by the path from the file, or by `package://`"
        elif is_elsewhere(resource):
            message = f"`{resource.uri}` does not lead from the file to the mesh: Drake refuses the file"
            advice = "name it by the path from the file, or by `package://`"
        yield self.diagnostic(resource.uri_value, message, help=advice)


def is_on_host(resource: Include | Resource) -> bool:
    """Is it a file that is there, by a `file:` that is followed by less than three slashes?"""
    if not resource.uri.startswith("file:") or resource.uri.startswith("file:///"):
        return False
    return resource.location is not None and resource.location.path is not None


def is_elsewhere(resource: Resource) -> bool:
    """Is it a path in SDFormat that leads to a file from another folder, as among the models?"""
    location = resource.location
    if resource.is_urdf or ":" in resource.uri or location is None or location.path is None:
        return False
    return not os.path.exists(os.path.join(resource.document.path.parent, resource.uri))

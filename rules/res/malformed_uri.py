import os
from collections.abc import Iterator

from sdfcheck import (
    IN_URDF_LINK,
    IN_VISUAL,
    IN_WORLD,
    REFUSES,
    Bad,
    Consumer,
    Diagnostic,
    Good,
    Include,
    Resource,
    Rule,
    Severity,
    UriFault,
    accepts,
    replace,
)
from sdfcheck_rules.res.places import needs_no_escape

MESH = "<geometry><mesh><uri>{}</uri></mesh></geometry>"
URDF_MESH = '<visual><geometry><mesh filename="{}"/></geometry></visual>'
# libsdformat cuts off a scheme, whichever it is, together with its slashes.
CUT_OFF = frozenset({UriFault.SLASHES, UriFault.ABSOLUTE, UriFault.SCHEME_CASE, UriFault.UNKNOWN_SCHEME})


class MalformedUri(Rule):
    """A URI is spelt so that consumers do not find what it names.

    A slash too few or too many, backslashes, capital letters in the scheme, a scheme
    that is not known, spaces. Consumers differ in what they forgive: Gazebo cuts any scheme
    off and looks for the rest in its resource paths, so that an unknown one is a warning in SDFormat;
    ROS hands the address to a web client that insists on it, and Drake refuses it.
    """

    code = "RES004"
    name = "malformed-uri"
    severity = Severity.ERROR
    remedy = """Write the URI as `scheme://folder/file`, with two slashes, in lower case and without spaces.

    For a mesh in a package of ROS it is `package://PACKAGE/meshes/arm.stl`, for a model of Gazebo
    `model://MODEL/meshes/arm.dae`, for an absolute path `file:///…` with three slashes. Paths on Windows
    take slashes as well.
    """
    looks_at = (Include, Resource)
    scaffold = IN_VISUAL

    bad = (
        Bad(
            URDF_MESH.format("«package:/arm/arm.stl»"),
            fixed=URDF_MESH.format("package://arm/arm.stl"),
            scaffold=IN_URDF_LINK,
            says="needs exactly two slashes after it",
        ),
        Bad(
            MESH.format("«model:\\\\arm\\arm.dae»"),
            fixed=MESH.format("model://arm/arm.dae"),
            says="backslashes",
        ),
        Bad(
            MESH.format("«Model://arm/arm.dae»"), fixed=MESH.format("model://arm/arm.dae"), says="lower case"
        ),
        Bad(
            "<include><uri>«modle://arm/»</uri></include>",
            fixed="<include><uri>model://arm/</uri></include>",
            scaffold=IN_WORLD,
            says="the scheme `modle` is not known",
        ),
        Bad(MESH.format("«model://»"), says="names no model"),
        Bad(
            "<include><uri>«https://fuel.gazebosim.org/1.0/me/model/Mine»</uri></include>",
            fixed="<include><uri>https://fuel.gazebosim.org/1.0/me/models/Mine</uri></include>",
            scaffold=IN_WORLD,
            says="the server Fuel has no such address",
        ),
        Bad(
            MESH.format("«https:/fuel.example.org/arm»"),
            fixed=MESH.format("https://fuel.example.org/arm"),
            says="needs exactly two slashes after it",
        ),
        Bad(
            URDF_MESH.format("« package://arm/arm.stl»"),
            fixed=URDF_MESH.format("package://arm/arm.stl"),
            scaffold=IN_URDF_LINK,
            says="space",
        ),
        Bad(
            '<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro"><link name="l">'
            f"{URDF_MESH.format('«package://$(find arm)/meshes/arm.stl»')}</link></robot>",
            scaffold="{}",
            file="urdf/arm.urdf.xacro",
            files={"package.xml": "<package><name>arm</name></package>"},
            says="`package:` takes a name, and an absolute path follows: `file:` takes one",
        ),
        Bad(
            URDF_MESH.format("«package:///meshes/arm.obj»"),
            fixed=URDF_MESH.format("meshes/arm.obj"),
            scaffold=IN_URDF_LINK,
            files={"meshes/arm.obj": "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"},
            says="did you mean `meshes/arm.obj`?",
        ),
    )
    good = (
        Good(
            "<include><uri>https://fuel.gazebosim.org/1.0/me/models/Mine</uri></include>", scaffold=IN_WORLD
        ),
        Good(MESH.format("model://Double pendulum/arm.dae"), why="names may have spaces"),
        Good(MESH.format("\n  meshes/arm.dae\n"), why="spaces around the text of an element do not count"),
    )

    @staticmethod
    def applies(named: Include | Resource) -> bool:
        return named.misspelling is not None

    def check(self, named: Include | Resource) -> Iterator[Diagnostic]:
        value, misspelling = named.uri_value, named.misspelling
        if value is None or misspelling is None:
            return
        text, (fault, meant) = value.text, misspelling
        if fault is UriFault.SLASHES:
            meant = beside(named) or meant
        affects, severity = {}, None
        if fault in CUT_OFF and "://" in text:
            # Gazebo looks for the rest in its resource paths, whatever the scheme.
            affects = {Consumer.GAZEBO: accepts("looks for what follows the scheme")}
            severity = None if named.is_urdf else Severity.WARNING
        elif named.kind == "include":
            affects = {Consumer.GAZEBO: REFUSES}
        if ":///" in text:
            affects[Consumer.PYBULLET] = accepts("looks for what follows the slashes")
        scheme = named.uri.partition(":")[0]
        message = {
            UriFault.BACKSLASH: f"backslashes in `{text}`, which takes slashes",
            UriFault.SLASHES: f"`{scheme}:` needs exactly two slashes after it in `{text}`",
            UriFault.ABSOLUTE: f"`{scheme}:` takes a name, and an absolute path follows: `file:` takes one",
            UriFault.SCHEME_CASE: f"the scheme `{scheme}` should be in lower case",
            UriFault.UNKNOWN_SCHEME: f"the scheme `{scheme}` is not known",
            UriFault.NO_NAME: f"`{text}` names no {scheme.lower()}",
            UriFault.BLANK: f"`{text}` has a space that does not belong to it",
            UriFault.FUEL_KIND: f"the server Fuel has no such address: `{text}`",
        }[fault]
        fix = replace(value, meant, f"write {meant}") if meant and needs_no_escape(meant) else None
        yield self.diagnostic(value, message, meant=meant, fix=fix, affects=affects, severity=severity)


def beside(named: Include | Resource) -> str:
    """The path from the file, if that is what follows the slashes of `package:///` and no package has its name."""
    scheme, _, path = named.uri.partition(":///")
    if scheme != "package" or path.startswith("/") or ".." in path.split("/"):
        return ""
    return path if os.path.isfile(os.path.join(named.document.path.parent, path)) else ""

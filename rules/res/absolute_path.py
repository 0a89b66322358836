import re
from collections.abc import Iterator

from sdfcheck import (
    IN_MODEL,
    IN_ROBOT,
    IN_URDF_LINK,
    IN_VISUAL,
    UNFOUND,
    Bad,
    Consumer,
    Diagnostic,
    Good,
    Include,
    Plugin,
    Resource,
    Rule,
    Severity,
    Value,
    accepts,
)
from sdfcheck_rules.res.absences import reactions

MESH = "<geometry><mesh><uri>{}</uri></mesh></geometry>"
HOME = re.compile(r"(?:file://)?/(?:home|Users)/[^/\s]+/\S+")


class AbsolutePath(Rule):
    """A path begins at the root of the file system, so it holds on one computer only.

    Everybody else gets a robot without that mesh, model or plugin. A path relative to the file,
    `model://` or `package://` goes with the files; a plugin is found by the name of its library.
    """

    code = "RES006"
    name = "absolute-path"
    severity = Severity.WARNING
    remedy = """Write it relative to the file, or as `package://PACKAGE/…` or `model://MODEL/…`.

    ROS programs want `package://`, Gazebo takes all three. The model has to be below a folder that
    `GZ_SIM_RESOURCE_PATH` lists, the package has to be installed with its meshes
    (`install(DIRECTORY meshes …)`). Of a plugin write the name of the library alone, and list its
    folder in `GZ_SIM_SYSTEM_PLUGIN_PATH`.
    """
    looks_at = (Include, Resource, Plugin)
    scaffold = IN_VISUAL

    bad = (
        Bad(MESH.format("«/home/ann/arm.dae»"), says="holds on one computer only"),
        Bad(
            '<visual><geometry><mesh filename="«file:///home/ann/arm.stl»"/></geometry></visual>',
            scaffold=IN_URDF_LINK,
        ),
        Bad(MESH.format("«C:/robots/arm.dae»")),
        Bad(
            '<gazebo reference="base"><visual><material><pbr><metal><albedo_map>«/home/ann/arm.png»</albedo_map>'
            "</metal></pbr></material></visual></gazebo>",
            scaffold=IN_ROBOT,
        ),
        Bad(
            '<plugin name="p" filename="libp.so"><table>«/home/ann/data.csv»</table></plugin>',
            scaffold=IN_MODEL,
        ),
        Bad(
            '<plugin name="p" filename="«/home/ann/ws/build/libp.so»"/>',
            scaffold=IN_MODEL,
            says="absolute path `/home/ann/ws/build/libp.so` holds on one computer only",
        ),
    )
    good = (
        Good(MESH.format("file://meshes/arm.dae"), why="relative anyway"),
        Good(MESH.format("model://arm/arm.dae")),
        Good(
            '<plugin name="p" filename="/usr/lib/libp.so"/>',
            scaffold=IN_MODEL,
            why="where packages are installed",
        ),
    )

    @staticmethod
    def applies(named: Include | Resource | Plugin) -> bool:
        if isinstance(named, Plugin):
            return next(of_somebody(named), None) is not None
        # An include that is not found is an error of its own.
        return named.is_absolute and named.misspelling is None and named.obstacle is None

    def check(self, named: Include | Resource | Plugin) -> Iterator[Diagnostic]:
        if isinstance(named, Plugin):
            for value in of_somebody(named):
                message = f"absolute path `{value.text.strip()}` holds on one computer only"
                yield self.diagnostic(value, message, affects={Consumer.DRAKE: accepts("ignores plugins")})
            return
        if named.uri_value is not None:
            affects = reactions([named], UNFOUND) if isinstance(named, Resource) else None
            message = f"absolute path `{named.uri}` holds on one computer only"
            yield self.diagnostic(named.uri_value, message, affects=affects)


def of_somebody(plugin: Plugin) -> Iterator[Value]:
    """The library and the parameters of a plugin that are files in somebody's home folder."""
    if plugin.filename_value is not None and HOME.match(plugin.filename):
        yield plugin.filename_value
    for parameter in plugin.parameters:
        if not parameter.nodes and HOME.match(parameter.content):
            yield parameter.own_value

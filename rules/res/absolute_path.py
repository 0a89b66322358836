import re
from collections.abc import Iterator

from sdfcheck import (
    IN_MODEL,
    IN_ROBOT,
    IN_URDF_LINK,
    IN_VISUAL,
    UNFOUND,
    Bad,
    Diagnostic,
    Good,
    Include,
    Plugin,
    Resource,
    Rule,
    Severity,
    Value,
)
from sdfcheck_rules.res.absences import reactions

MESH = "<geometry><mesh><uri>{}</uri></mesh></geometry>"
HOME = re.compile(r"(?:file://)?/(?:home|Users)/[^/\s]+/\S+")


class AbsolutePath(Rule):
    """A path begins at the root of the file system, so it holds on one computer only.

    Everybody else gets a robot without that mesh or model. A path relative to the file,
    `model://` or `package://` goes with the files.
    """

    code = "RES006"
    name = "absolute-path"
    severity = Severity.WARNING
    remedy = """Write it relative to the file, or as `package://PACKAGE/…` or `model://MODEL/…`.

    ROS programs want `package://`, Gazebo takes all three. The model has to be below a folder that
    `GZ_SIM_RESOURCE_PATH` lists, the package has to be installed with its meshes
    (`install(DIRECTORY meshes …)`).
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
    )
    good = (
        Good(MESH.format("file://meshes/arm.dae"), why="relative anyway"),
        Good(MESH.format("model://arm/arm.dae")),
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
                yield self.diagnostic(
                    value, f"absolute path `{value.text.strip()}` holds on one computer only"
                )
            return
        if named.uri_value is not None:
            affects = reactions([named], UNFOUND) if isinstance(named, Resource) else None
            message = f"absolute path `{named.uri}` holds on one computer only"
            yield self.diagnostic(named.uri_value, message, affects=affects)


def of_somebody(plugin: Plugin) -> Iterator[Value]:
    """The parameters of a plugin that name a file in somebody's home folder."""
    for parameter in plugin.parameters:
        if not parameter.nodes and HOME.match(parameter.content):
            yield parameter.own_value

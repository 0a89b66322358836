from collections.abc import Iterator

from sdfcheck import (
    IN_ROBOT,
    IN_URDF_LINK,
    IN_VISUAL,
    Bad,
    Consumer,
    Diagnostic,
    Good,
    Include,
    Resource,
    Rule,
    Severity,
    warns,
)

MESH = "<geometry><mesh><uri>{}</uri></mesh></geometry>"


class AbsolutePath(Rule):
    """A path begins at the root of the file system, so it holds on one computer only.

    Everybody else gets a robot without that mesh or model. A path relative to the file,
    `model://` or `package://` goes with the files.
    """

    code = "RES006"
    name = "absolute-path"
    severity = Severity.WARNING
    affects = {
        Consumer.GAZEBO: warns("does not find the file on another computer"),
        Consumer.DRAKE: warns("refuses the file on another computer"),
    }
    looks_at = (Include, Resource)
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
    )
    good = (
        Good(MESH.format("file://meshes/arm.dae"), why="relative anyway"),
        Good(MESH.format("model://arm/arm.dae")),
    )

    @staticmethod
    def applies(named: Include | Resource) -> bool:
        # An include that is not found is an error of its own.
        return named.is_absolute and named.misspelling is None and named.obstacle is None

    def check(self, named: Include | Resource) -> Iterator[Diagnostic]:
        if named.uri_value is not None:
            yield self.diagnostic(named.uri_value, f"absolute path `{named.uri}` holds on one computer only")

from collections.abc import Iterator

from sdfcheck import (
    IN_ROBOT,
    IN_URDF_LINK,
    IN_VISUAL,
    Bad,
    Consumer,
    Diagnostic,
    Good,
    Rule,
    Severity,
    problems,
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
    explains = (problems.AbsolutePath,)
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
        Good(MESH.format("file://meshes/arm.dae"), why="relative all the same"),
        Good(MESH.format("model://arm/arm.dae")),
    )

    def check(self, problem: problems.AbsolutePath) -> Iterator[Diagnostic]:
        message = f"absolute path `{problem.value.text.strip()}` holds on one computer only"
        yield self.diagnostic(problem.value, message)

from collections.abc import Iterator
from pathlib import PurePosixPath

from sdfcheck import REFUSES, Bad, Consumer, Diagnostic, Geometry, Good, Rule, Severity, Shape, listed, warns
from sdfcheck_rules.drk.effect import affects, does
from sdfcheck_rules.drk.scaffolds import BOX, COLLISION, LINK, ROBOT_LINK

VISUAL = "visual"
FORMATS = {
    VISUAL: (".gltf", ".obj"),
    "collision": (".gltf", ".obj", ".vtk"),
    "rigid hydroelastic collision": (".obj", ".vtk"),
    "deformable collision": (".vtk",),
}
"""The role of a mesh → the formats that Drake reads for it."""

NOT_SHOWN = {Consumer.DRAKE: warns("does not show it")}


class UnsupportedMeshFormat(Rule):
    """A mesh file is of a format that Drake does not read in this role.

    Collision geometries come from `.obj`, `.vtk` and `.gltf` files, rigid hydroelastic ones from
    `.obj` and `.vtk`, deformable ones from `.vtk`; anything else is refused where there is a
    SceneGraph. Drake's renderers show `.obj` and `.gltf`, and leave other visuals out in silence.
    """

    code = "DRK009"
    name = "unsupported-mesh-format"
    severity = Severity.ERROR
    remedy = """Convert the mesh to a format that Drake reads in this role: `.obj` serves collisions and visuals.

    Blender, MeshLab and assimp (`assimp export arm.dae arm.obj`) do so. Without a SceneGraph, for dynamics
    alone, Drake opens no meshes.
    """
    default = False
    looks_at = (Geometry,)
    selects = ("sdf:geometry", "urdf:robot/link/visual/geometry", "urdf:robot/link/collision/geometry")
    scaffold = COLLISION

    bad = (
        Bad(
            "<geometry><mesh><uri>«https://example.org/arm.STL»</uri></mesh></geometry>",
            says="a `.stl` file cannot be a collision: Drake refuses the file; it reads .gltf, .obj and .vtk",
        ),
        Bad(
            '<visual><geometry><mesh filename="«https://example.org/arm.dae»"/></geometry></visual>',
            says="a `.dae` file is not shown by Drake's renderers",
            scaffold=ROBOT_LINK,
        ),
        Bad(
            "<geometry><mesh><uri>«https://example.org/arm.gltf»</uri></mesh></geometry>"
            "<drake:proximity_properties><drake:rigid_hydroelastic/></drake:proximity_properties>",
            says="a rigid hydroelastic collision",
        ),
    )
    good = (
        Good("<geometry><mesh><uri>https://example.org/arm.OBJ</uri></mesh></geometry>"),
        Good("", scaffold=BOX),
        Good(
            '<visual name="v"><geometry><mesh><uri>https://example.org/arm.gltf</uri></mesh></geometry>'
            "</visual>",
            scaffold=LINK,
        ),
    )

    def check(self, geometry: Geometry) -> Iterator[Diagnostic]:
        value, shape = geometry.uri_value, geometry.holder
        if value is None or geometry.shape != "mesh" or not isinstance(shape, Shape) or "${" in value.text:
            return
        suffix, role = PurePosixPath(value.text.strip()).suffix.lower(), _role(shape)
        if not suffix or suffix in FORMATS[role]:
            return
        formats = listed(FORMATS[role])
        if role == VISUAL:
            message = f"a `{suffix}` file is not shown by Drake's renderers, which take {formats}"
            yield self.diagnostic(value, message, severity=Severity.INFO, affects=NOT_SHOWN)
            return
        message = f"a `{suffix}` file cannot be a {role}: {does(REFUSES)}; it reads {formats}"
        yield self.diagnostic(value, message, affects=affects(REFUSES))


def _role(shape: Shape) -> str:
    if shape.kind == VISUAL:
        return VISUAL
    properties = shape.find("drake:proximity_properties")
    if shape.link.has("drake:deformable_properties"):
        return "deformable collision"
    is_rigid = properties is not None and properties.has("drake:rigid_hydroelastic")
    return "rigid hydroelastic collision" if is_rigid else "collision"

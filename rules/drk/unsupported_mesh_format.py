from collections.abc import Iterator

from sdfcheck import Bad, Consumer, Diagnostic, Good, Rule, Severity, listed, problems, refuses, warns
from sdfcheck_rules.drk.effect import affects, consequence
from sdfcheck_rules.drk.scaffolds import BOX, COLLISION, LINK, ROBOT_LINK

NOT_SHOWN = {Consumer.DRAKE: warns("does not show it")}


class UnsupportedMeshFormat(Rule):
    """A mesh file is of a format that Drake does not read in this role.

    Collision geometries come from `.obj`, `.vtk` and `.gltf` files, rigid hydroelastic ones from
    `.obj` and `.vtk`, deformable ones from `.vtk`; anything else is refused where there is a
    SceneGraph. Drake's renderers show `.obj` and `.gltf`, and leave other visuals out without a word.
    """

    code = "DRK009"
    name = "unsupported-mesh-format"
    severity = Severity.ERROR
    default = False
    affects = {Consumer.DRAKE: refuses("refuses a collision mesh, does not show a visual one")}
    explains = (problems.UnsupportedMesh,)
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

    def check(self, problem: problems.UnsupportedMesh) -> Iterator[Diagnostic]:
        formats = listed(problem.formats)
        suffix = "." + problem.value.text.strip().rpartition(".")[2].lower()
        if problem.role == "visual":
            message = f"a `{suffix}` file is not shown by Drake's renderers, which take {formats}"
            yield self.diagnostic(problem.value, message, severity=Severity.INFO, affects=NOT_SHOWN)
            return
        yield self.diagnostic(
            problem.value,
            f"a `{suffix}` file cannot be a {problem.role}: {consequence(problem.effect)}; "
            f"it reads {formats}",
            affects=affects(problem.effect),
        )

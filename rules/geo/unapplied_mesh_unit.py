from collections.abc import Iterator

from sdfcheck import IN_URDF_LINK, Bad, Diagnostic, Geometry, Good, Rule, Severity
from sdfcheck_rules.geo.scaffolds import mesh, triangles


def unit(meter: str) -> dict[str, str]:
    """The files of a mesh in COLLADA with that unit of length."""
    text = triangles(1).replace("<COLLADA>", f'<COLLADA><asset><unit meter="{meter}"/></asset>')
    return {"arm.dae": text}


class UnappliedMeshUnit(Rule):
    """A COLLADA mesh of a URDF file is in another unit than the meter, which some consumers do not apply.

    RViz, Gazebo and PyBullet multiply its coordinates by the `meter` of its `<unit>`. Pinocchio 4.1, Isaac Sim's
    converter and yourdfpy take them as meters: the part is a thousand times as large, or 2.5 % of what it is.
    All of them take the axes as they are, whatever `<up_axis>` says (measured).
    """

    code = "GEO021"
    name = "unapplied-mesh-unit"
    severity = Severity.ERROR
    remedy = """Export the mesh in meters (`<unit name="meter" meter="1"/>`).

    In Blender, apply the scale of the object (Ctrl+A) and set the unit scale of the scene to 1. A `scale` of the
    `<mesh>` does not help: those who apply the unit would apply both.
    """
    default = False
    looks_at = (Geometry,)
    needs = ("<mesh", ":mesh")
    scaffold = IN_URDF_LINK

    bad = (
        Bad(
            mesh("visual", "«arm.dae»"),
            files=unit("0.001"),
            says="a unit of 0.001 m, and Pinocchio and Isaac Sim take its coordinates as meters",
        ),
        Bad(mesh("collision", "«arm.dae»"), files=unit("0.0254")),
    )
    good = (
        Good(mesh("visual", "arm.dae"), files=unit("1")),
        Good(mesh("visual", "arm.dae"), files=unit("1.000000"), why="the same"),
        Good(mesh("visual", "arm.dae"), files={"arm.dae": triangles(1)}, why="the unit is the meter"),
    )

    @staticmethod
    def applies(geometry: Geometry) -> bool:
        read = geometry.mesh if geometry.is_urdf and geometry.shape == "mesh" else None
        return read is not None and not read.fault and read.unit != 1

    def check(self, geometry: Geometry) -> Iterator[Diagnostic]:
        assert geometry.mesh is not None, "it was measured"
        name, meter = geometry.uri.rpartition("/")[2], geometry.mesh.unit
        yield self.diagnostic(
            geometry.uri_value or geometry,
            f"the mesh `{name}` has a unit of {meter:g} m, and Pinocchio and Isaac Sim take its coordinates as meters",
        )

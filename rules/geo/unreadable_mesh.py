from collections.abc import Iterator

from sdfcheck import IN_URDF_LINK, Bad, Diagnostic, Geometry, Good, Missing, MissingKind, Rule, Severity
from sdfcheck_rules.geo.scaffolds import mesh, wedge

READ = {"STL": ("stl",), "OBJ": ("obj",), "COLLADA": ("dae",), "glTF": ("gltf",), "GLB": ("glb",)}
"""Format → the endings of its files."""
DRAWINGS = frozenset("3dm blend catpart fcstd igs iges ipt prt sldasm sldprt skp step stp x_t".split())
"""Endings of files of CAD programs, which no consumer of robots reads."""


class UnreadableMesh(Rule):
    """The file of a mesh is empty, broken, a drawing of a CAD program, or of another format than its ending says.

    Consumers choose the program that reads a mesh by the ending of its name, and draw and
    touch nothing where that fails; MuJoCo and Drake refuse the robot.
    """

    code = "GEO006"
    name = "unreadable-mesh"
    severity = Severity.WARNING
    remedy = """Export the mesh again, or name it by the ending that its content has.

    Look at the beginning of the file: `version https://git-lfs` is a pointer for which `git lfs pull`
    fetches the mesh, `<html` the page of a download that failed, `solid` a text STL file, `v ` lines are an
    OBJ file. A file of another format can be renamed with its true ending, or converted in MeshLab or
    Blender.
    """
    looks_at = (Geometry,)
    needs = ("<mesh", ":mesh")
    scaffold = IN_URDF_LINK

    bad = (
        Bad(mesh("visual", "«arm.stl»"), files={"arm.stl": ""}, says="the mesh `arm.stl` is empty"),
        Bad(mesh("visual", "«arm.stl»"), files={"arm.stl": "<html/>"}, says="is not an STL file"),
        Bad(
            mesh("visual", "«arm.stl»"),
            files={"arm.stl": "version https://git-lfs.github.com/spec/v1\noid sha256:0\nsize 84\n"},
            says="the mesh `arm.stl` is a pointer of Git LFS",
        ),
        Bad(
            mesh("visual", "«arm.stl»"),
            files={"arm.stl": wedge(1)},
            says="the mesh `arm.stl` is an OBJ file, and consumers read it by its ending",
        ),
        Bad(
            mesh("visual", "«arm.dae»"),
            files={"arm.dae": "<COLLADA><asset>"},
            says="the mesh `arm.dae` is not well-formed XML",
        ),
        Bad(
            mesh("visual", "«arm.step»"),
            files={"arm.step": "ISO-10303-21;"},
            says="the mesh `arm.step` is a drawing of a CAD program, which no simulator reads",
        ),
    )
    good = (
        Good(mesh("visual", "arm.OBJ"), files={"arm.OBJ": wedge(1)}),
        Good(mesh("visual", "arm.fbx"), files={"arm.fbx": "Kaydara"}, why="a format that is not known here"),
    )

    @staticmethod
    def applies(geometry: Geometry) -> bool:
        return bool(fault(geometry))

    def check(self, geometry: Geometry) -> Iterator[Diagnostic]:
        name = geometry.uri.rpartition("/")[2]
        advice = "export it as STL, OBJ or COLLADA" if is_drawing(geometry) else None
        missing = None
        if geometry.mesh is not None and geometry.mesh.is_pointer:
            advice = "fetch the file with `git lfs pull`"
            missing = Missing(MissingKind.LFS, name)
        target = geometry.uri_value or geometry
        yield self.diagnostic(target, f"the mesh `{name}` {fault(geometry)}", help=advice, missing=missing)


def is_drawing(geometry: Geometry) -> bool:
    """Is its mesh the file of a CAD program, by its ending?"""
    return geometry.shape == "mesh" and ending_of(geometry) in DRAWINGS


def ending_of(geometry: Geometry) -> str:
    return geometry.uri.rpartition(".")[2].lower()


def fault(geometry: Geometry) -> str:
    """The reason why consumers cannot read the mesh; empty where they can, or nobody knows."""
    if geometry.shape != "mesh":
        return ""
    if is_drawing(geometry):
        return "is a drawing of a CAD program, which no simulator reads"
    read = geometry.mesh
    if read is None or read.fault:
        return read.fault if read is not None else ""
    promised = next((form for form, endings in READ.items() if ending_of(geometry) in endings), "")
    if not read.format or not promised or promised == read.format:
        return ""
    article = "an" if read.format[0] in "SO" else "a"
    return f"is {article} {read.format} file, and consumers read it by its ending"

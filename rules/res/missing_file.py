from collections.abc import Iterator

from sdfcheck import (
    IN_URDF_LINK,
    IN_VISUAL,
    REFUSES,
    UNFOUND,
    Bad,
    Diagnostic,
    Fix,
    Good,
    Missing,
    MissingKind,
    Pieces,
    Resource,
    Root,
    Rule,
    Severity,
    used,
    write_instead,
)
from sdfcheck_rules.res.absences import Absences, elsewhere, reactions
from sdfcheck_rules.res.places import looked_for, near_file, place

MESH = "<geometry><mesh><uri>{}</uri></mesh></geometry>"


class MissingFile(Rule):
    """A mesh, texture, heightmap, script or sound is not where its URI leads.

    Gazebo loads the rest: what has lost its mesh is invisible, and collides with nothing. Drake and PyBullet
    refuse a file of which a mesh is missing. A model or package that is nowhere on the search path is a warning,
    once for each, because another computer may have it: set `model-paths`, `package-paths` or
    `packages` in the configuration. So is a folder that is not there at all or holds no
    other file of the kind, because meshes are often kept elsewhere, or nothing at all, as that of a submodule
    that is not checked out.
    Nothing is ever fetched from the network.
    """

    code = "RES001"
    name = "missing-file"
    severity = Severity.ERROR
    remedy = """Put the file where the URI leads, correct the URI, or say in the configuration where its package is.

    The help line lists the places that were looked at. `package://NAME/…` wants a folder with a
    `package.xml` of that name, `model://NAME/…` a folder of that name on the search path: `package-paths`,
    `packages` and `model-paths` in `sdfcheck.toml`, or `--package NAME=PATH`. If a build makes the file or
    git-lfs fetches it, do that first.
    """
    looks_at = (Root, Pieces)
    scaffold = IN_VISUAL

    bad = (
        Bad(MESH.format("«arm.dae»"), files={}, says="mesh `arm.dae` does not exist"),
        Bad(MESH.format("«file://media/arm.dae»"), files={}, says="there is no folder `media`"),
        Bad(
            MESH.format("«model://robot/meshes/arn.dae»"),
            fixed=MESH.format("model://robot/meshes/arm.dae"),
            unsafe=True,
            files={"robot/meshes/arm.dae": ""},
            says="did you mean `arm.dae`?",
        ),
        Bad(
            MESH.format("«model://robot/meshes/link_1.dae»"),
            files={"robot/meshes/link_2.dae": ""},
            says="link_1.dae` does not exist",
        ),
        Bad(
            MESH.format("«meshes/arm.dae»") + "<material><pbr><metal><albedo_map>meshes/arm.png</albedo_map>"
            "</metal></pbr></material>",
            files={},
            says="there is no folder `meshes`, needed for 2 files",
        ),
        Bad(MESH.format("«model://lost/arm.dae»"), files={}, says="model `lost` is not on the search path"),
        Bad(
            '<visual><geometry><mesh filename="«package://lost/a.stl»"/></geometry></visual>'
            '<collision><geometry><mesh filename="package://lost/b.stl"/></geometry></collision>',
            scaffold=IN_URDF_LINK,
            files={},
            says="package `lost` is not on the search path, needed for 2 files",
        ),
        Bad(
            '<visual><geometry><mesh filename="«package://lost/meshes/a.stl»"/></geometry></visual>',
            scaffold=IN_URDF_LINK,
            files={"package.xml": "<package><name>arm_description</name></package>", "meshes/a.stl": ""},
            says="package `lost` is not on the search path, and `arm_description` has what is asked of it",
        ),
        Bad(
            '<visual><geometry><mesh filename="«package://arm.stl»"/></geometry></visual>',
            scaffold=IN_URDF_LINK,
            files={"meshes/arm.stl": ""},
            says="`package://arm.stl` names a file and no package",
        ),
    )
    good = (
        Good(MESH.format("meshes/arm.dae"), files={"meshes/arm.dae": ""}),
        Good(
            "<geometry><mesh><uri>https://fuel.gazebosim.org/1.0/a/models/b/1/files/m.dae</uri></mesh></geometry>",
            files={},
            why="files on the network are not read",
        ),
        Good(
            "<geometry><box><size>1 1 1</size></box></geometry><material><script>"
            "<uri>file://media/materials/scripts/gazebo.material</uri><name>Gazebo/Red</name></script></material>",
            files={},
            why="Gazebo Classic brings it along",
        ),
    )

    @staticmethod
    def applies(part: Root | Pieces) -> bool:
        return any(resource.is_missing for resource in part.resources)

    def check(self, part: Root | Pieces) -> Iterator[Diagnostic]:
        absences = Absences(resource for resource in part.resources if resource.is_missing)
        for uses in absences.files.values():
            yield self.file(uses)
        for uses in absences.owners.values():
            message, advice, missing = elsewhere(uses)
            yield self.together(uses, message, advice)._replace(missing=missing)
        for folder, uses in absences.submodules.items():
            name = place(part.document, folder)
            message = f"folder `{name}` is empty: it may be a submodule that is not checked out"
            advice = "; fetch it with `git submodule update --init`"
            yield self.together(uses, message, advice)._replace(
                missing=Missing(MissingKind.SUBMODULE, name, len(uses))
            )
        for uses in absences.ignored.values():
            uri = uses[0].uri
            message = f"git ignores {uses[0].what} `{uri}`, which is not there: a build may make it"
            yield self.together(uses, message)._replace(missing=Missing(MissingKind.IGNORED, uri, len(uses)))
        for folder, uses in absences.folders.items():
            yield self.together(uses, f"there is no folder `{place(part.document, folder)}`")

    def file(self, uses: list[Resource]) -> Diagnostic:
        resource = uses[0]
        near, has_siblings = near_file(resource)
        message = f"{resource.what} `{resource.uri}` does not exist{used(len(uses))}"
        if near is not None:
            message += f", did you mean `{near}`?"
        return self.diagnostic(
            resource.uri_value,
            message,
            fix=renamed(uses, near),
            severity=Severity.ERROR if has_siblings else Severity.WARNING,
            help=looked_for(resource),
            affects=reactions(uses, REFUSES if has_siblings else UNFOUND),
        )

    def together(self, uses: list[Resource], message: str, advice: str = "") -> Diagnostic:
        times = f", needed for {len(uses)} files" if len(uses) > 1 else ""
        return self.diagnostic(
            uses[0].uri_value,
            message + times,
            severity=Severity.WARNING,
            help=looked_for(uses[0]) + advice,
            affects=reactions(uses, UNFOUND),
        )


def renamed(uses: list[Resource], near: str | None) -> Fix | None:
    """The fix that names another file of the same folder, wherever the URI is used."""
    folder, slash, _ = uses[0].uri.rpartition("/")
    values = [use.uri_value for use in uses]
    is_literal = all(value.span.text == uses[0].uri for value in values)
    return write_instead(f"{folder}{slash}{near}", *values) if near is not None and is_literal else None

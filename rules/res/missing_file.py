from collections.abc import Iterator

from sdfcheck import (
    IN_URDF_LINK,
    IN_VISUAL,
    REFUSES,
    Bad,
    Consumer,
    Diagnostic,
    Element,
    Good,
    Reaction,
    Rule,
    Severity,
    Value,
    accepts,
    problems,
    used,
    warns,
)
from sdfcheck_rules.res.places import looked_for, place

MESH = "<geometry><mesh><uri>{}</uri></mesh></geometry>"


ELSEWHERE = warns("refuses the file where it is not found")


class MissingFile(Rule):
    """A mesh, texture, heightmap, script or sound is not where its URI leads.

    Simulators load the rest: what has lost its mesh is invisible, and collides with
    nothing. A model or package that is nowhere on the search path is a warning, once for
    each, because another computer may have it: set `model-paths`, `package-paths` or
    `packages` in the configuration. So is a folder that is not there at all or holds no
    other file of the kind, because meshes are often kept elsewhere.
    Nothing is ever fetched from the network.
    """

    code = "RES001"
    name = "missing-file"
    severity = Severity.ERROR
    affects = {
        Consumer.GAZEBO: warns("shows nothing in its place"),
        Consumer.DRAKE: REFUSES,
        Consumer.MUJOCO: REFUSES,
    }
    explains = (problems.MissingFile, problems.MissingFolder, problems.MissingOwner)
    scaffold = IN_VISUAL

    bad = (
        Bad(MESH.format("«arm.dae»"), files={}, says="mesh `arm.dae` does not exist"),
        Bad(
            MESH.format("«model://robot/meshes/arn.dae»"),
            files={"robot/meshes/arm.dae": ""},
            says="did you mean `arm.dae`?",
        ),
        Bad(
            MESH.format("«meshes/arm.dae»") + "<material><pbr><metal><albedo_map>meshes/arm.png</albedo_map>"
            "</metal></pbr></material>",
            files={},
            says="there is no folder `meshes`, needed for 2 files",
        ),
        Bad(
            MESH.format("«model://lost/arm.dae»"),
            files={},
            says="model `lost` is not on the search path",
        ),
        Bad(
            '<visual><geometry><mesh filename="«package://lost/a.stl»"/></geometry></visual>'
            '<collision><geometry><mesh filename="package://lost/b.stl"/></geometry></collision>',
            scaffold=IN_URDF_LINK,
            files={},
            says="package `lost` is not on the search path, needed for 2 files",
        ),
    )
    good = (
        Good(MESH.format("meshes/arm.dae"), files={"meshes/arm.dae": ""}),
        Good(
            "<geometry><mesh><uri>https://fuel.gazebosim.org/1.0/a/models/b/1/files/m.dae</uri></mesh></geometry>",
            files={},
            why="what is on the network is not looked at",
        ),
        Good(
            "<geometry><box><size>1 1 1</size></box></geometry><material><script>"
            "<uri>file://media/materials/scripts/gazebo.material</uri><name>Gazebo/Red</name></script></material>",
            files={},
            why="Gazebo Classic brings it along",
        ),
    )

    def check(
        self, problem: problems.MissingFile | problems.MissingFolder | problems.MissingOwner
    ) -> Iterator[Diagnostic]:
        value, location = problem.value, problem.location
        where = looked_for(value, location.tried)
        if isinstance(problem, problems.MissingFile):
            message = f"{problem.what} `{value.text.strip()}` does not exist{used(problem.count)}"
            if problem.suggestion is not None:
                message += f", did you mean `{problem.suggestion}`?"
            severity = Severity.ERROR if problem.has_kin else Severity.WARNING
            affects = reactions(value, REFUSES if problem.has_kin else ELSEWHERE)
            yield self.diagnostic(value, message, severity=severity, help=where, affects=affects)
            return
        times = f", needed for {len(problem.uses)} files" if len(problem.uses) > 1 else ""
        if isinstance(problem, problems.MissingFolder):
            message = f"there is no folder `{place(value.element.document, problem.folder)}`{times}"
        else:
            setting = "model-paths" if location.scheme == "model" else "package-paths"
            message = f"{location.scheme} `{location.name}` is not on the search path{times}"
            where += f"; set `{setting}` in the configuration if it is elsewhere"
        affects = reactions(value, ELSEWHERE)
        yield self.diagnostic(value, message, severity=Severity.WARNING, help=where, affects=affects)


def reactions(value: Value, missing: Reaction) -> dict[Consumer, Reaction]:
    """Drake looks for the meshes of links, MuJoCo for those of collisions that are paths."""
    roles = {each.name for each in value.element.iterancestors() if isinstance(each, Element)}
    is_mesh = (value.element.name == "mesh" or "mesh" in roles) and "gazebo" not in roles
    opened = is_mesh and "collision" in roles and ":/" not in value.text
    unread = accepts("does not look for it")
    return {
        Consumer.DRAKE: missing if is_mesh and roles & {"visual", "collision"} else unread,
        Consumer.MUJOCO: missing if opened else unread,
    }

from collections.abc import Iterator

from sdfcheck import IN_URDF_LINK, IN_VISUAL, Bad, Consumer, Diagnostic, Good, Rule, Severity, problems
from sdfcheck_rules.res.places import looked_for

MESH = "<geometry><mesh><uri>{}</uri></mesh></geometry>"


class MissingFile(Rule):
    """A mesh, texture, heightmap, script or sound is not where its URI leads.

    Simulators load the rest: what has lost its mesh is invisible, and collides with
    nothing. A model or package that is nowhere on the search path is a warning, once for
    each, because another computer may have it: set `model-paths`, `package-paths` or
    `packages` in the configuration. So is a file whose folder is not there either.
    Nothing is ever fetched from the network.
    """

    code = "RES001"
    name = "missing-file"
    severity = Severity.ERROR
    affects = {Consumer.GAZEBO: "shows nothing in its place", Consumer.DRAKE: "fails on the mesh"}
    explains = (problems.MissingFile, problems.MissingOwner)
    scaffold = IN_VISUAL

    bad = (
        Bad(MESH.format("«arm.dae»"), files={}, says="mesh `arm.dae` does not exist"),
        Bad(
            MESH.format("«model://robot/meshes/arn.dae»"),
            files={"robot/meshes/arm.dae": "", "robot/model.config": ""},
            says="did you mean `arm.dae`?",
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

    def check(self, problem: problems.MissingFile | problems.MissingOwner) -> Iterator[Diagnostic]:
        value, location = problem.value, problem.location
        where = looked_for(value, location.tried)
        if isinstance(problem, problems.MissingOwner):
            times = f", needed for {len(problem.uses)} files" if len(problem.uses) > 1 else ""
            setting = "model-paths" if location.scheme == "model" else "package-paths"
            yield self.diagnostic(
                value,
                f"{location.scheme} `{location.name}` is not on the search path{times}",
                severity=Severity.WARNING,
                help=f"{where}; set `{setting}` in the configuration if it is elsewhere",
            )
            return
        message = f"{problem.what} `{value.text.strip()}` does not exist"
        if problem.suggestion is not None:
            message += f", did you mean `{problem.suggestion}`?"
        severity = Severity.WARNING if problem.apart else Severity.ERROR
        yield self.diagnostic(value, message, severity=severity, help=where)

from collections.abc import Iterator

from sdfcheck import IN_WORLD, REFUSES, Bad, Consumer, Diagnostic, Good, Rule, Severity, problems
from sdfcheck_rules.res.places import looked_for

ARM = '<sdf version="1.12"><model name="arm"><link name="l"/></model></sdf>'


class UnresolvedInclude(Rule):
    """The uri of an include leads to no file.

    libsdformat refuses the document. A `model://`, or a bare name, that no folder near by nor any
    on the search path has is a warning, because another computer may have it: set `model-paths`
    in the configuration. Models on the network, such as those of Gazebo Fuel, are
    pointed out only; nothing is ever fetched. A folder needs a `model.config` that says
    which of its files is the model.
    """

    code = "RES002"
    name = "unresolved-include"
    severity = Severity.ERROR
    affects = {Consumer.GAZEBO: REFUSES, Consumer.DRAKE: REFUSES}
    explains = (problems.UnresolvedInclude, problems.FolderWithoutConfig)
    scaffold = IN_WORLD

    bad = (
        Bad("<include><uri>«arm.sdf»</uri></include>", files={}, says="`arm.sdf` leads to no file"),
        Bad(
            "<include><uri>«model://arm/arm.sdf»</uri></include>",
            files={"arm/model.sdf": ARM},
            says="there is no `arm.sdf` in model `arm`",
        ),
        Bad(
            "<include><uri>«model://arm»</uri></include>",
            files={},
            says="model `arm` is not on the search path",
        ),
        Bad("<include><uri>«arm»</uri></include>", files={}, says="model `arm` is not on the search path"),
        Bad(
            "<include><uri>«https://fuel.gazebosim.org/1.0/openrobotics/models/arm»</uri></include>",
            files={},
            says="is not fetched",
        ),
        Bad(
            "<include><uri>«model://arm»</uri><name>left</name></include>"
            "<include><uri>model://arm</uri><name>right</name></include>",
            files={},
            says="(2 includes)",
        ),
        Bad(
            "<include><uri>«arm»</uri></include>",
            files={"arm/model.sdf": ARM},
            says="a folder without `model.config`",
        ),
    )
    good = (
        Good("<include><uri>arm.sdf</uri></include>", files={"arm.sdf": ARM}),
        Good(
            "<include><uri>model://arm</uri></include>",
            files={
                "models/arm/model.config": '<model><name>arm</name><sdf version="1.12">arm.sdf</sdf></model>',
                "models/arm/arm.sdf": ARM,
            },
            why="a folder of models near by needs no setting",
        ),
    )

    def check(
        self, problem: problems.UnresolvedInclude | problems.FolderWithoutConfig
    ) -> Iterator[Diagnostic]:
        text = problem.uri.text
        if isinstance(problem, problems.FolderWithoutConfig):
            files = " or ".join(f"`{text.rstrip('/')}/{name}`" for name in problem.descriptions)
            advice = f"name the file: {files}" if files else None
            yield self.diagnostic(
                problem.uri, f"`{text}` leads to a folder without `model.config`", help=advice
            )
            return
        location = problem.location
        where = looked_for(problem.uri, location.tried)
        times = f" ({len(problem.uses)} includes)" if len(problem.uses) > 1 else ""
        if location.is_remote:
            message = f"`{text}` is not fetched, so what it brings is not known{times}"
            yield self.diagnostic(problem.uri, message, severity=Severity.INFO)
        elif not location.is_local:
            yield self.diagnostic(problem.uri, f"no reader knows the scheme `{location.scheme}`")
        elif location.owner is not None:
            missing = text.partition(f"{location.name}/")[2]
            message = f"there is no `{missing}` in {location.scheme} `{location.name}`"
            yield self.diagnostic(problem.uri, message, help=where)
        elif problem.is_searched_for:
            kind = location.scheme or "model"
            yield self.diagnostic(
                problem.uri,
                f"{kind} `{location.name or text}` is not on the search path{times}",
                severity=Severity.WARNING,
                help=f"{where}; set `{kind}-paths` in the configuration if it is elsewhere",
            )
        else:
            yield self.diagnostic(problem.uri, f"`{text}` leads to no file", help=where)

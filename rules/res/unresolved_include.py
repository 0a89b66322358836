from collections.abc import Iterator

from sdfcheck import (
    IN_WORLD,
    UNFOUND,
    Bad,
    Consumer,
    Diagnostic,
    Good,
    Include,
    Missing,
    MissingKind,
    Root,
    Rule,
    Severity,
)
from sdfcheck_rules.res.absent_models import Absence, elsewhere, of_submodule, unfetched
from sdfcheck_rules.res.places import descriptions, looked_for, write_model

ARM = '<sdf version="1.12"><model name="arm"><link name="l"/></model></sdf>'
ELSEWHERE = dict.fromkeys((Consumer.GAZEBO, Consumer.DRAKE), UNFOUND)


class UnresolvedInclude(Rule):
    """The uri of an include leads to no file.

    libsdformat refuses the document. A file of another computer is a warning: a `model://`, or a bare name,
    that no folder near by nor any on the search path has (set `model-paths` in the configuration), a path from
    the root of the file system, and one into `install`, which a build makes where Gazebo is started. So is a folder
    without content, as that of a submodule that is not checked out. Models on the network, such as those of Gazebo
    Fuel, are pointed out only; nothing is ever fetched. A folder needs a `model.config` that says which of its files
    is the model.
    """

    code = "RES002"
    name = "unresolved-include"
    severity = Severity.ERROR
    remedy = """Put the model where the uri leads, or name its folder in `model-paths` of the configuration.

    A folder needs a `model.config` that names the file; a uri may also name the file itself,
    `arm/model.sdf`. For a model on Fuel, `gz fuel download -u URL` fetches it into the cache; Gazebo does
    so by itself, Drake does not.
    """
    looks_at = (Root,)
    scaffold = IN_WORLD

    bad = (
        Bad("<include><uri>«arm.sdf»</uri></include>", files={}, says="`arm.sdf` leads to no file"),
        Bad("<include><uri>«/home/ann/arm.sdf»</uri></include>", files={}, says="leads to no file"),
        Bad(
            "<include><uri>«install/arm/share/arm/arm.sdf»</uri></include>", files={}, says="leads to no file"
        ),
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
        Bad(
            "<include><uri>«model://warehuose»</uri></include>",
            fixed="<include><uri>model://warehouse</uri></include>",
            unsafe=True,
            files={
                "warehouse/model.config": '<model><name>warehouse</name><sdf version="1.12">arm.sdf</sdf></model>',
                "warehouse/arm.sdf": ARM,
            },
            says="model `warehuose` is not on the search path; did you mean `warehouse`?",
        ),
        Bad(
            "<include><uri>«model://mode»</uri><name>a</name></include>"
            "<include><uri>model://mode</uri><name>b</name></include>",
            fixed="<include><uri>model://model</uri><name>a</name></include>"
            "<include><uri>model://model</uri><name>b</name></include>",
            unsafe=True,
            files={
                "model/model.config": '<model><name>model</name><sdf version="1.12">arm.sdf</sdf></model>',
                "model/arm.sdf": ARM,
            },
            says="(2 includes); did you mean `model`?",
        ),
        Bad(
            "<include><uri>«model://arm»</uri></include>",
            files={"arm/src/arm.cc": ""},
            says="model `arm` is not on the search path",
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

    @staticmethod
    def applies(root: Root) -> bool:
        return any(include.is_missing or include.needs_config for include in root.includes)

    def check(self, root: Root) -> Iterator[Diagnostic]:
        alike: dict[object, list[Include]] = {}
        empty: dict[str, list[Include]] = {}
        for include in root.includes:
            if folder := unfetched(include):
                empty.setdefault(folder, []).append(include)
            elif include.needs_config:
                yield from self.folder(include)
            elif include.is_missing:
                # A part that is missing for a reason outside of the file is reported once.
                is_outside = include.is_searched_for or (include.location and include.location.is_remote)
                alike.setdefault(include.uri if is_outside else include, []).append(include)
        for includes in alike.values():
            yield from self.missing(includes)
        for folder, includes in empty.items():
            yield self.together(includes, of_submodule(includes[0], folder))

    def folder(self, include: Include) -> Iterator[Diagnostic]:
        text, value, location = include.uri, include.uri_value, include.location
        if value is None or location is None or location.path is None:
            return
        base = text if text.endswith("/") else f"{text}/"
        files = " or ".join(f"`{base}{name}`" for name in descriptions(location.path))
        advice = f"name the file: {files}" if files else None
        yield self.diagnostic(value, f"`{text}` leads to a folder without `model.config`", help=advice)

    def missing(self, includes: list[Include]) -> Iterator[Diagnostic]:
        include = includes[0]
        value, location = include.uri_value, include.location
        if value is None or location is None:
            return
        if location.is_remote or (location.is_local and include.is_searched_for):
            yield self.together(includes, elsewhere(include))
        elif not location.is_local:
            advice = "write `model://`, `package://`, `file://` or a path"
            yield self.diagnostic(value, f"no consumer knows the scheme `{location.scheme}`", help=advice)
        else:
            _, _, inside = include.uri.partition(f"{location.name}/")
            lacked = f"there is no `{inside}` in {location.scheme} `{location.name}`"
            message = f"`{include.uri}` leads to no file" if location.owner is None else lacked
            is_outside = include.is_absolute or include.uri.startswith("install/")
            severity = Severity.WARNING if is_outside else self.severity
            yield self.diagnostic(value, message, help=looked_for(include), severity=severity)

    def together(self, includes: list[Include], absence: Absence) -> Diagnostic:
        """The finding about what several includes lack for a reason outside of the file."""
        count = len(includes)
        return self.diagnostic(
            includes[0].uri_value or includes[0],
            f"{absence.message} ({count} includes)" if count > 1 else absence.message,
            meant=absence.meant,
            fix=write_model(absence.meant, includes),
            severity=Severity.INFO if absence.kind is MissingKind.REMOTE else Severity.WARNING,
            help=absence.advice,
            affects=ELSEWHERE,
            missing=None if absence.meant else Missing(absence.kind, absence.name, count),
        )

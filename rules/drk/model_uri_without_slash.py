import re
from collections.abc import Iterator

from sdfcheck import IN_WORLD, Bad, Diagnostic, Good, Include, Rule, Severity, replace
from sdfcheck_rules.drk.remote_mesh import is_on_host

NAME_ONLY = re.compile(r"(?:model|package)://[^/\s]+")
ALONE = re.compile(r"[\w.-]+")
INCLUDE = "<include><uri>{}</uri></include>"


class ModelUriWithoutSlash(Rule):
    """An include names a model by a URI without a slash behind the name, which Drake does not take for one.

    Drake knows a URI by `scheme://package/path`. `model://turntable` without a path is looked for as a file, and the
    file is refused; `model://turntable/` is found. So is `turntable` alone, which Gazebo looks for among its models,
    only where a folder of that name is beside the file. `file:` takes an absolute path, after a third slash. Gazebo
    takes them all.
    """

    code = "DRK023"
    name = "model-uri-without-slash"
    severity = Severity.ERROR
    remedy = """Put a slash behind the name: `model://turntable/`.

    Drake looks for the name in its package map: add the folder with `package_map().Add("turntable", folder)`, or with
    `PopulateFromFolder` where it has a `package.xml`.
    """
    default = False
    looks_at = (Include,)
    scaffold = IN_WORLD

    bad = (
        Bad(
            INCLUDE.format("«model://turntable»"),
            fixed=INCLUDE.format("model://turntable/"),
            says="`model://turntable` ends with the name: Drake looks for no model there and refuses the file",
        ),
        Bad(INCLUDE.format("«package://turntable»"), fixed=INCLUDE.format("package://turntable/")),
        Bad(
            INCLUDE.format("«turntable»"),
            fixed=INCLUDE.format("model://turntable/"),
            files={
                "models/turntable/model.config": "<model><sdf>model.sdf</sdf></model>",
                "models/turntable/model.sdf": '<sdf version="1.9"><model name="t"><link name="l"/></model></sdf>',
            },
            says="`turntable` is the name of a model elsewhere",
        ),
        Bad(
            INCLUDE.format("«file://turntable/model.sdf»"),
            files={
                "turntable/model.sdf": '<sdf version="1.9"><model name="t"><link name="l"/></model></sdf>',
            },
            says="`file:` takes an absolute path behind three slashes: Drake refuses the file",
        ),
    )
    good = (
        Good(INCLUDE.format("model://turntable/")),
        Good(INCLUDE.format("model://turntable/model.sdf")),
        Good(
            INCLUDE.format("turntable"),
            files={"turntable/model.config": "<model><sdf>model.sdf</sdf></model>"},
            why="a folder beside the file",
        ),
    )

    @staticmethod
    def applies(include: Include) -> bool:
        is_named = NAME_ONLY.fullmatch(include.uri) is not None or is_name_of_model(include)
        return is_named or is_on_host(include)

    def check(self, include: Include) -> Iterator[Diagnostic]:
        value = include.uri_value
        if value is None:
            return
        if is_on_host(include):
            message = "`file:` takes an absolute path behind three slashes: Drake refuses the file"
            yield self.diagnostic(value, message, help="name it by the path from the file, or by `model://`")
            return
        if NAME_ONLY.fullmatch(include.uri):
            message = (
                f"`{include.uri}` ends with the name: Drake looks for no model there and refuses the file"
            )
            meant, title = f"{include.uri}/", "put a slash behind the name"
        else:
            message = f"`{include.uri}` is the name of a model elsewhere: Drake looks beside the file and refuses it"
            meant, title = f"model://{include.uri}/", "name it as a model"
        yield self.diagnostic(
            value, message, fix=replace(value, value.text.replace(include.uri, meant), title)
        )


def is_name_of_model(include: Include) -> bool:
    """Is it the name of a model elsewhere, without a scheme?"""
    location = include.location
    if location is None or location.path is None or not ALONE.fullmatch(include.uri):
        return False
    return location.path.absolute().parent != include.document.path.absolute().parent

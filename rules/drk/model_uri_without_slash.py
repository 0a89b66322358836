import re
from collections.abc import Iterator

from sdfcheck import IN_WORLD, Bad, Diagnostic, Good, Include, Rule, Severity, replace
from sdfcheck_rules.drk.remote_mesh import is_on_host

NAME_ONLY = re.compile(r"(?:model|package)://[^/\s]+")
INCLUDE = "<include><uri>{}</uri></include>"


class ModelUriWithoutSlash(Rule):
    """An include names a model by a URI without a slash behind the name, which Drake does not take for one.

    Drake knows a URI by `scheme://package/path`. `model://turntable` without a path is looked for as a file, and the
    file is refused; `model://turntable/` is found. `turntable` alone, which Gazebo looks for among its models, and a
    path such as `arms/arm.sdf`, which leads from the file for Gazebo, are looked for in the folder in which the program
    is started: Drake gives libsdformat `.` as the folder of includes. `file:` takes an absolute path, after a third
    slash. Gazebo takes them all.
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
            says="`turntable` leads from the folder in which Drake is started",
        ),
        Bad(
            INCLUDE.format("«arms/arm.sdf»"),
            files={"arms/arm.sdf": '<sdf version="1.9"><model name="a"><link name="l"/></model></sdf>'},
            says="`arms/arm.sdf` leads from the folder in which Drake is started, elsewhere it refuses the file",
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
    )

    @staticmethod
    def applies(include: Include) -> bool:
        is_named = NAME_ONLY.fullmatch(include.uri) is not None or is_relative(include)
        return is_named or is_on_host(include)

    def check(self, include: Include) -> Iterator[Diagnostic]:
        value, uri = include.uri_value, include.uri
        if value is None:
            return
        meant = "" if is_on_host(include) or set("/.") & set(uri) else f"model://{uri}/"
        if is_on_host(include):
            message = "`file:` takes an absolute path behind three slashes: Drake refuses the file"
        elif is_relative(include):
            message = (
                f"`{uri}` leads from the folder in which Drake is started, elsewhere it refuses the file"
            )
        else:
            message, meant = (
                f"`{uri}` ends with the name: Drake looks for no model there and refuses the file",
                f"{uri}/",
            )
        if not meant:
            yield self.diagnostic(value, message, help="name it by `model://` or `package://`")
            return
        fix = replace(value, value.text.replace(uri, meant), f"write {meant}")
        yield self.diagnostic(value, message, fix=fix)


def is_relative(include: Include) -> bool:
    """Is it a path without a scheme, or the name of a model, that leads to a file?"""
    is_found = include.location is not None and include.location.path is not None
    return is_found and ":" not in include.uri and not include.uri.startswith("/")

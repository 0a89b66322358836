import re
from collections.abc import Iterator

from sdfcheck import IN_WORLD, Bad, Diagnostic, Good, Include, Rule, Severity, replace

NAME_ONLY = re.compile(r"(?:model|package)://[^/\s]+")
INCLUDE = "<include><uri>{}</uri></include>"


class ModelUriWithoutSlash(Rule):
    """An include names a model by a URI without a slash behind the name, which Drake does not take for one.

    Drake knows a URI by `scheme://package/path`. `model://turntable` without a path is looked for as a file, and the
    file is refused; `model://turntable/` is found. Gazebo takes both.
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
    )
    good = (
        Good(INCLUDE.format("model://turntable/")),
        Good(INCLUDE.format("model://turntable/model.sdf")),
        Good(INCLUDE.format("turntable"), why="a folder beside the file"),
    )

    @staticmethod
    def applies(include: Include) -> bool:
        return NAME_ONLY.fullmatch(include.uri) is not None

    def check(self, include: Include) -> Iterator[Diagnostic]:
        value = include.uri_value
        if value is not None:
            yield self.diagnostic(
                value,
                f"`{include.uri}` ends with the name: Drake looks for no model there and refuses the file",
                fix=replace(
                    value, value.text.replace(include.uri, f"{include.uri}/"), "put a slash behind the name"
                ),
            )

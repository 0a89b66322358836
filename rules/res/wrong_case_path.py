from collections.abc import Iterator

from sdfcheck import (
    IN_VISUAL,
    IN_WORLD,
    Bad,
    Consumer,
    Diagnostic,
    Good,
    Include,
    Resource,
    Rule,
    Severity,
    refuses,
    replace,
)
from sdfcheck_rules.res.absences import reactions
from sdfcheck_rules.res.places import needs_no_escape, place

MESH = "<geometry><mesh><uri>{}</uri></mesh></geometry>"
ARM = '<sdf version="1.12"><model name="arm"><link name="l"/></model></sdf>'


UNFOUND = refuses("refuses the file where the case of letters counts")
ELSEWHERE = dict.fromkeys((Consumer.GAZEBO, Consumer.DRAKE), UNFOUND)


class WrongCasePath(Rule):
    """A path is right but for capital letters.

    Windows and macOS find the file anyway; on Linux it is missing. An include of
    it is an error, because the document is refused there.
    """

    code = "RES005"
    name = "wrong-case-path"
    severity = Severity.WARNING
    remedy = """Write the path as it is spelt on disk.

    Or rename the file; git on Windows and macOS needs `git mv` for a change of case alone. Lower case
    throughout avoids the question.
    """
    looks_at = (Include, Resource)
    scaffold = IN_VISUAL

    bad = (
        Bad(
            MESH.format("«meshes/Arm.DAE»"),
            fixed=MESH.format("meshes/arm.dae"),
            files={"meshes/arm.dae": ""},
            says="is spelt `meshes/arm.dae` on disk",
        ),
        Bad(
            "<include><uri>«model://Arm/arm.sdf»</uri></include>",
            fixed="<include><uri>model://arm/arm.sdf</uri></include>",
            scaffold=IN_WORLD,
            files={"arm/arm.sdf": ARM},
        ),
    )
    good = (Good(MESH.format("Meshes/arm.dae"), files={"Meshes/arm.dae": ""}),)

    @staticmethod
    def applies(named: Include | Resource) -> bool:
        return named.other_case is not None

    def check(self, named: Include | Resource) -> Iterator[Diagnostic]:
        value, found = named.uri_value, named.other_case
        if value is None or found is None:
            return
        meant = found.meant
        severity, affects = Severity.ERROR, ELSEWHERE
        if isinstance(named, Resource):
            severity, affects = self.severity, reactions((named,), UNFOUND)
        fix = replace(value, meant, f"write {meant}") if meant and needs_no_escape(meant) else None
        message = f"`{named.uri}` is spelt `{meant or place(named.document, found.path)}` on disk"
        yield self.diagnostic(value, message, severity=severity, fix=fix, affects=affects)

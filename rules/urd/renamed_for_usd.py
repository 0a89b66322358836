import re
from collections.abc import Iterator

from sdfcheck import Bad, Diagnostic, Good, Model, Rule, Severity, named

IDENTIFIER = re.compile(r"[A-Za-z_][A-Za-z0-9_]*")
ROBOT = (
    '<robot name="r"><link name="base"/><link name="{0}"/>'
    '<joint name="{1}" type="fixed"><parent link="base"/><child link="{0}"/></joint></robot>'
)


class RenamedForUsd(Rule):
    """Isaac Sim gives a link or joint another name, for USD does not take the one that it has.

    Names in USD are letters, digits and `_`, and begin with no digit. Of `1_thigh` the importer makes `tn__1_thigh_`,
    of `left-arm` something like `tn__leftarm_sA`. Programs and files of settings that look for the name find nothing.
    """

    code = "URD032"
    name = "renamed-for-usd"
    severity = Severity.WARNING
    remedy = """Write letters, digits and `_` alone, and begin with a letter: `thigh_1`, `left_arm`.

    The name that the part had is the `displayName` of its prim.
    """
    default = False
    looks_at = (Model,)
    scaffold = ROBOT
    sources = ("https://github.com/newton-physics/urdf-usd-converter",)

    bad = (
        Bad(
            ROBOT.format("«1_thigh»", "hip").replace('link="«1_thigh»"', 'link="1_thigh"'),
            scaffold="",
            says="name `1_thigh` is another one in USD",
        ),
        Bad(
            ROBOT.format("«left-arm»", "left.joint").replace('link="«left-arm»"', 'link="left-arm"'),
            scaffold="",
            says="names `left-arm` and `left.joint` are others in USD",
        ),
    )
    good = (Good(ROBOT.format("thigh_1", "_hip"), scaffold=""),)

    @staticmethod
    def applies(robot: Model) -> bool:
        return robot.is_urdf and any(
            not IDENTIFIER.fullmatch(part.name) for part in robot.links + robot.joints
        )

    def check(self, robot: Model) -> Iterator[Diagnostic]:
        parts = [
            part for part in robot.links + robot.joints if part.name and not IDENTIFIER.fullmatch(part.name)
        ]
        if not parts:
            return
        names = named((part.name for part in parts), most=3)
        message = (
            f"names {names} are others in USD" if len(parts) > 1 else f"name {names} is another one in USD"
        )
        first, *others = [part.value("name") or part for part in parts]
        yield self.diagnostic(first, message, labels=dict.fromkeys(others, "the same"))

from collections.abc import Iterator

from sdfcheck import Bad, Diagnostic, Good, Rule, Semantics, Severity
from sdfcheck_rules.srd.scaffold import FILE, ROBOT

ONE = '<robot name="{}"><group name="g"><joint name="{}"/></group></robot>'


class ForeignSemantics(Rule):
    """SRDF does not belong to the robot of its package.

    Either no name in it is a link or joint of the robot, or its own name is not that of the robot. MoveIt then says of
    each name that it is not known, or that the semantic description is not for the same robot.
    """

    code = "SRD007"
    name = "foreign-semantics"
    severity = Severity.ERROR
    remedy = """Put the SRDF beside the robot that it is for, or let its name be that of the robot.

    It is the `name` of `<robot>` in both files. For a copy of another robot's configuration, run the MoveIt
    Setup Assistant for this one.
    """
    looks_at = (Semantics,)

    bad = (
        Bad(
            ONE.format("arm", "panda_joint1").replace("robot", "«robot»", 1),
            file=FILE,
            files=ROBOT,
            says="no link or joint that this file names is in robot `arm` of arm.urdf",
        ),
        Bad(
            ONE.format("«leg»", "shoulder"),
            fixed=ONE.format("arm", "shoulder"),
            unsafe=True,
            file=FILE,
            files=ROBOT,
            says="the robot of arm.urdf is called `arm`, not `leg`",
        ),
    )
    good = (
        Good(ONE.format("arm", "shoulder"), file=FILE, files=ROBOT),
        Good(ONE.format("leg", "knee"), why="another robot, which is not here", file=FILE, files=ROBOT),
        Good(
            ONE.format("leg", "shoulder"),
            why="the robot has a file of its own",
            file="leg.srdf",
            files={**ROBOT, FILE: ONE.format("arm", "shoulder")},
        ),
    )

    @staticmethod
    def applies(semantics: Semantics) -> bool:
        return bool(semantics.strangers) or semantics.namesake is not None

    def check(self, semantics: Semantics) -> Iterator[Diagnostic]:
        if (robot := semantics.namesake) is not None:
            value = semantics.element.attribute("name")
            message = (
                f"the robot of {robot.document.path.name} is called `{robot.name}`, not `{semantics.name}`"
            )
            yield self.diagnostic(value or semantics, message, meant=robot.name, severity=Severity.WARNING)
            return
        robot = semantics.strangers[0]
        message = f"no link or joint that this file names is in {robot.title} of {robot.document.path.name}"
        yield self.diagnostic(semantics, message)

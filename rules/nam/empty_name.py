from collections.abc import Iterator

from sdfcheck import (
    IN_MODEL,
    REFUSES,
    Bad,
    Consumer,
    Diagnostic,
    Good,
    Rule,
    Severity,
    accepts,
    problems,
    refuses,
)

JOINT = '<joint {} type="fixed"><parent link="a"/><child link="b"/></joint>'
ROBOT = '<robot name="r"><link name="a"/><link name="b"/>{}</robot>'
IN_JOINTS = {
    Consumer.DRAKE: accepts("needs no name there"),
    Consumer.ISAAC: REFUSES,
    Consumer.PYBULLET: refuses("crashes"),
}


class EmptyName(Rule):
    """A name is empty or blank.

    libsdformat stops reading there: what has a name must have one that can be referred to.
    In URDF urdfdom and MuJoCo take it; Drake wants names of robots and links.
    """

    code = "NAM006"
    name = "empty-name"
    severity = Severity.ERROR
    remedy = """Give it a name that its siblings do not have.

    It may be short: `base`, `visual`, `camera`. Names of links become frames of tf2, names of joints those
    of controllers. In xacro, a property that is empty leaves such a name.
    """
    explains = (problems.EmptyName,)
    scaffold = IN_MODEL

    bad = (
        Bad('<link «name»=""/>', says="the name of `link` is empty"),
        Bad('<frame name="« »"/>', says="the name of `frame` is blank"),
        Bad(
            JOINT.format('«name»=""'),
            scaffold=ROBOT,
            says="the name of `joint` is empty",
        ),
    )
    good = (
        Good('<plugin name="" filename="p"/>', why="a plugin needs no name since 1.10"),
        Good(JOINT.format('name="j"'), scaffold=ROBOT),
    )

    def check(self, problem: problems.EmptyName) -> Iterator[Diagnostic]:
        value = problem.value
        what = "blank" if value.text else "empty"
        message = f"the name of `{value.element.name}` is {what}"
        if problem.until is None:
            parent = value.element.parent
            is_joint = value.element.name == "joint" and parent is not None and parent.name == "robot"
            affects = IN_JOINTS if is_joint else {}
            yield self.diagnostic(value, message, affects=affects)
            return
        message += f", and required up to version {problem.until}"
        yield self.diagnostic(value, message, severity=Severity.WARNING)

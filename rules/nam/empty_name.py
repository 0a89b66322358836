from collections.abc import Iterator, Mapping

from sdfcheck import (
    IN_MODEL,
    IN_URDF_LINK,
    REFUSES,
    Bad,
    Consumer,
    Diagnostic,
    Element,
    Good,
    Reaction,
    Rule,
    Severity,
    accepts,
    problems,
    refuses,
    used,
    warns,
)

JOINT = '<joint {} type="fixed"><parent link="a"/><child link="b"/></joint>'
SHAPE = '<{}><geometry><sphere radius="1"/></geometry></visual>'
ROBOT = '<robot name="r"><link name="a"/><link name="b"/>{}</robot>'
IN_JOINTS = {
    Consumer.DRAKE: accepts("needs no name there"),
    Consumer.ISAAC: REFUSES,
    Consumer.PYBULLET: refuses("crashes"),
}

IN_TREES = dict.fromkeys((Consumer.MUJOCO, Consumer.URDFDOM), refuses("finds two trees"))

IN_SHAPES = dict.fromkeys(
    (Consumer.GAZEBO, Consumer.ISAAC, Consumer.PYBULLET), accepts("needs no name there")
)


class EmptyName(Rule):
    """A name is empty or blank.

    libsdformat stops reading there: what has a name must have one that can be referred to.
    In URDF urdfdom and MuJoCo take it; Drake wants names of robots and links, and of shapes none or one that is not
    empty.
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
            '<link name="a"><visual «name»=""><geometry><box><size>1 1 1</size></box></geometry></visual></link>',
            says="the name of `visual` is empty",
        ),
        Bad(
            JOINT.format('«name»=""'),
            scaffold=ROBOT,
            says="the name of `joint` is empty",
        ),
        Bad(
            SHAPE.format('visual «name»=""') + SHAPE.format('visual name=" "'),
            scaffold=IN_URDF_LINK,
            says="the name of `visual` is empty (used 2 times): Drake refuses the robot",
        ),
    )
    good = (
        Good('<plugin name="" filename="p"/>', why="a plugin needs no name since 1.10"),
        Good(JOINT.format('name="j"'), scaffold=ROBOT),
        Good(SHAPE.format("visual"), scaffold=IN_URDF_LINK, why="without a name it gets one"),
    )

    def check(self, problem: problems.EmptyName) -> Iterator[Diagnostic]:
        value = problem.value
        what = "blank" if value.text else "empty"
        message = f"the name of `{value.element.name}` is {what}"
        if problem.shapes:
            message += f"{used(problem.shapes)}: Drake refuses the robot"
            advice = "leave the `name` out, or give it one that its siblings do not have"
            yield self.diagnostic(value, message, severity=Severity.WARNING, help=advice, affects=IN_SHAPES)
        elif problem.until is None:
            yield self.diagnostic(value, message, affects=in_robot(value.element))
        else:
            message += f", and required up to version {problem.until}"
            affects = dict.fromkeys(Consumer, warns("older releases refuse the file"))
            yield self.diagnostic(value, message, severity=Severity.WARNING, affects=affects)


def in_robot(element: Element) -> Mapping[Consumer, Reaction]:
    """The reactions of consumers of URDF that go by the part."""
    robot = element.parent
    if element.name == "robot":
        return {Consumer.PYBULLET: accepts("needs no name there")}
    if robot is None or robot.name != "robot":
        return {}
    if element.name == "material":
        return dict.fromkeys((Consumer.GAZEBO, Consumer.PYBULLET), accepts("needs no name there"))
    if element.name == "joint":
        return IN_JOINTS
    return IN_TREES if element.name == "link" and robot.has("joint") else {}

from collections.abc import Iterator

from sdfcheck import (
    IN_LINK,
    IN_MODEL,
    IN_ROBOT,
    IN_WORLD,
    Bad,
    Consumer,
    Diagnostic,
    Good,
    Rule,
    Severity,
    Value,
    listed,
    problems,
    unreadable,
    warns,
)

MANY = 8
"""More choices than this are not listed next to a good guess."""


NOISY = (
    '<sensor name="s" type="gpu_lidar"><lidar><scan><horizontal><samples>9</samples>'
    "<min_angle>-1</min_angle><max_angle>1</max_angle></horizontal></scan><range><min>1</min><max>2</max>"
    "</range><noise><type>{}</type></noise></lidar></sensor>"
)


class UnknownChoice(Rule):
    """A value is not one of those that its place knows.

    libsdformat refuses unknown types of joints, sensors, lights and noise, unknown image
    formats and the like; case counts in most of them. Some values it keeps as they are, such as
    the name of a physics engine or a lens; these are warnings: the program that reads them
    later does not know them.
    """

    code = "SCH015"
    name = "unknown-choice"
    severity = Severity.ERROR
    remedy = """Write one of the values that the format knows, letter by letter.

    `sdfcheck describe joint/@type` and the like list them. Case counts. For an engine or a lens of your
    own, ignore this.
    """
    explains = (problems.UnknownChoice,)
    scaffold = IN_LINK

    bad = (
        Bad(
            '<sensor name="s" type="«camra»"/>',
            fixed='<sensor name="s" type="camera"/>',
            unsafe=True,
            says="unknown `type` of sensor `s`: `camra`; did you mean `camera`?",
        ),
        Bad(
            '<light name="l" type="«Point»"/>',
            fixed='<light name="l" type="point"/>',
            unsafe=True,
            says="`point` differs in case only",
        ),
        Bad(
            '<joint name="j" type="«hinge»"><parent>world</parent><child>base</child></joint>',
            scaffold=IN_MODEL,
            says="unknown `type` of joint `j`: `hinge`",
        ),
        Bad(
            '<physics type="«odee»"/>',
            fixed='<physics type="ode"/>',
            unsafe=True,
            scaffold=IN_WORLD,
            says="did you mean `ode`?",
        ),
        Bad(
            NOISY.format("«guassian»"),
            fixed=NOISY.format("gaussian"),
            unsafe=True,
            scaffold=IN_LINK,
            says="did you mean `gaussian`?",
        ),
        Bad('<pose rotation_format="«quaternion»">0 0 0 0 0 0</pose>', says="unknown `rotation_format`"),
        Bad(
            '<link name="arm"/><joint name="j" type="«hinge»"><parent link="base"/><child link="arm"/></joint>',
            scaffold=IN_ROBOT,
            says="unknown `type` of joint `j`: `hinge`",
        ),
        Bad(
            '<link name="arm"/><joint name="j" type="«spherical»"><parent link="base"/><child link="arm"/></joint>',
            scaffold=IN_ROBOT,
            says="`spherical`, which MuJoCo and PyBullet alone know",
        ),
    )
    good = (
        Good(
            '<joint name="j" type="FIXED"><parent>world</parent><child>base</child></joint>',
            why="of joint types any case is read",
            scaffold=IN_MODEL,
        ),
        Good(
            "<scene><fog><type>exp2</type></fog></scene>",
            why="Gazebo Classic, which alone shows fog, has it",
            scaffold=IN_WORLD,
        ),
        Good('<physics type="ignore"/>', why="as `ignored`, which nobody reads", scaffold=IN_WORLD),
        Good(
            '<sensor name="s" type="wideanglecamera"><camera/></sensor>',
            why="another spelling of wide_angle_camera",
        ),
        Good(
            '<link name="arm"/><joint name="j" type="fixed"><parent link="base"/><child link="arm"/></joint>',
            scaffold=IN_ROBOT,
        ),
    )

    def check(self, problem: problems.UnknownChoice) -> Iterator[Diagnostic]:
        if problem.suggestion == "ignored" or is_of_classic(problem.value):
            return  # the type of physics that nobody is to read, and nobody does; fog of Gazebo Classic
        value, choices = problem.value, [choice for choice in problem.choices if choice]
        place = f"`{value.element.name}`"
        if value.attribute is not None:
            place = f"`{value.attribute}` of {value.element.title}"
        message = f"unknown {place}: `{value.text.strip()}`"
        is_read = is_of_simulators(value)
        if is_read:
            message += ", which MuJoCo and PyBullet alone know"
        known = f"known {'are' if len(choices) > 1 else 'is'} {listed(choices)}"
        guess = problem.suggestion
        yield self.diagnostic(
            value,
            message,
            meant=guess,
            help=known if guess is None or len(choices) <= MANY else None,
            severity=None if problem.refused and not is_read else Severity.WARNING,
            affects=unreadable(value)
            if problem.refused
            else dict.fromkeys(Consumer, warns("takes a default")),
        )


def is_of_classic(value: Value) -> bool:
    """Is it a type of fog that Gazebo Classic has, alone of all that show fog? The format lists others."""
    parent = value.element.parent
    return parent is not None and parent.name == "fog" and value.text.strip() in {"exp", "exp2"}


def is_of_simulators(value: Value) -> bool:
    """Is it the ball joint of URDF that two simulators read?"""
    parent = value.element.parent
    return value.text.strip() == "spherical" and parent is not None and parent.name == "robot"

from collections.abc import Iterator

from sdfcheck import Bad, Consumer, Diagnostic, Good, Rule, Severity, accepts, drops, problems, write_instead

PARTS = frozenset(("gazebo", "joint", "link", "material", "ros2_control", "transmission"))
"""Parts that only a robot holds."""
SEEN = (
    Consumer.DRAKE,
    Consumer.GAZEBO,
    Consumer.PINOCCHIO,
    Consumer.PYBULLET,
    Consumer.ROS,
    Consumer.URDFDOM,
)
SETTINGS = {**dict.fromkeys(SEEN, accepts("takes the element `robot`")), Consumer.MUJOCO: drops("the robot")}
"""The reactions to a file in which settings for MuJoCo are before the robot."""


class UnrecognizedDocument(Rule):
    """The file is not SDFormat, URDF, xacro or model.config.

    They are recognized by their root element: `sdf`, `robot`, `model`. Other formats share
    the suffix `.sdf`: chemical structures, timing of circuits, templates of any kind. A file
    that holds parts of a robot alone gets a warning: exporters paste such files into a robot.
    """

    code = "XML009"
    name = "unrecognized-document"
    severity = Severity.ERROR
    remedy = """Correct the root element, or exclude the file: `exclude = ["…"]` in the configuration.

    The root of SDFormat is `<sdf version="…">`, of URDF `<robot name="…">`. A file of another format with
    the same ending is best excluded by its folder.
    """
    explains = (problems.UnrecognizedDocument,)

    bad = (
        Bad(
            '<«robt» name="r"><link name="l"/></robt>',
            fixed='<robot name="r"><link name="l"/></robot>',
            unsafe=True,
            says="did you mean `robot`?",
        ),
        Bad(
            '<«mujoco»><compiler discardvisual="false"/></mujoco>\n<robot name="r"><link name="l"/></robot>',
            file="r.urdf",
            says="the root element is `mujoco`, and MuJoCo does not see the `robot` after it",
        ),
        Bad(
            '<«gazebo» reference="l"/>\n<gazebo reference="m"/>',
            file="gazebo.urdf",
            says="the root element is `gazebo`, which belongs in a `robot`",
        ),
        Bad("<«html»><body/></html>", says="the root element is `html`, not `sdf` or `robot`"),
        Bad("«solid cube»\n", says="this looks like plain text"),
        Bad("«»", says="the file is empty"),
    )
    good = (
        Good('<sdf version="1.12"><world name="w"/></sdf>'),
        Good('<robot name="r"><link name="l"/></robot>'),
    )

    def check(self, problem: problems.UnrecognizedDocument) -> Iterator[Diagnostic]:
        advice, severity = None, None
        if not problem.span.source.text.strip():
            message, advice = "the file is empty", "write a description into it, or remove it"
        elif problem.root is None:
            message = f"this looks like {problem.looks_like}, not like a robot description"
        else:
            message = f"the root element is `{problem.root}`, not `sdf` or `robot`"
            if problem.root == "mujoco":
                message = "the root element is `mujoco`, and MuJoCo does not see the `robot` after it"
                advice = "put it into `<robot>`"
            elif problem.root in PARTS:
                message = f"the root element is `{problem.root}`, which belongs in a `robot`"
                advice = "put it into `<robot>`, or exclude the file if something pastes it into one"
                severity = Severity.WARNING
            elif problem.suggestion is not None:
                message = f"unknown root element `{problem.root}`; did you mean `{problem.suggestion}`?"
        fix = write_instead(problem.suggestion, problem.span, problem.end) if problem.end else None
        affects = SETTINGS if problem.root == "mujoco" else None
        yield self.diagnostic(problem.span, message, help=advice, severity=severity, fix=fix, affects=affects)

from collections.abc import Iterator

from sdfcheck import Bad, Diagnostic, Good, Rule, Severity, problems, replace

FILE = "robot.urdf.xacro"
PROJECT = {".git/HEAD": ""}
ROBOT = '<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro"><link name="base"/>{}</robot>'


def limits(*names: str) -> str:
    return "".join(f'<xacro:property name="{name}" value="1"/>' for name in names)


def joint(name: str, upper: str) -> str:
    limit = f'<limit lower="-1" upper="${{{upper}}}" effort="1" velocity="1"/>'
    ends = f'<parent link="base"/><child link="{name}_link"/>'
    return f'<joint name="{name}" type="revolute">{ends}{limit}</joint><link name="{name}_link"/>'


class CounterpartProperty(Rule):
    """A joint or link reads the property of another one, and nothing reads its own.

    A block was copied, and the number or side in one of its names stayed: joint 2 is limited by `joint_1_upper`, while
    `joint_2_upper` is defined and never read. Reported where another joint or link whose name has that number or side
    reads the property, all files that are included are known, and no expression in the project reads its counterpart.
    """

    code = "XAC034"
    name = "counterpart-property"
    severity = Severity.WARNING
    remedy = "Read the property with the number or side of the joint or link, or remove that property."
    explains = (problems.CounterpartProperty,)
    scaffold = ROBOT

    bad = (
        Bad(
            limits("up_1", "up_2") + joint("j1", "up_1") + joint("j2", "«up_1»"),
            fixed=limits("up_1", "up_2") + joint("j1", "up_1") + joint("j2", "up_2"),
            unsafe=True,
            file=FILE,
            files=PROJECT,
            says="joint `j2` reads `up_1`, and nothing reads `up_2`",
        ),
        Bad(
            limits("left_y", "right_y") + joint("left_hip", "left_y") + joint("right_hip", "«left_y»"),
            fixed=limits("left_y", "right_y") + joint("left_hip", "left_y") + joint("right_hip", "right_y"),
            unsafe=True,
            file=FILE,
            files=PROJECT,
            says="joint `right_hip` reads `left_y`, and nothing reads `right_y`",
        ),
    )
    good = (
        Good(limits("up_1", "up_2") + joint("j1", "up_1") + joint("j2", "up_2"), file=FILE),
        Good(
            limits("up_1", "up_2") + joint("j2", "up_1") + joint("j3", "up_2"),
            why="their numbers are not those of the joints",
            file=FILE,
        ),
        Good(
            limits("up_1", "up_2") + joint("j1", "up_1") + joint("j2", "up_1") + joint("arm", "up_2"),
            why="both are read",
            file=FILE,
        ),
        Good(
            limits("up_1", "up_2") + joint("j1", "up_1") + joint("j2", "up_1"),
            files={**PROJECT, "other.xacro": '<robot><link name="${up_2}"/></robot>'},
            why="another file of the project reads it",
            file=FILE,
        ),
    )

    def check(self, problem: problems.CounterpartProperty) -> Iterator[Diagnostic]:
        own = problem.near or ""
        message = f"{problem.holder} reads `{problem.name}`, and nothing reads `{own}`"
        labels = dict.fromkeys(problem.places, "also here")
        if problem.other is not None:
            labels[problem.other] = "never read"
        fix = replace(problem.span, own, f"write `{own}`", unsafe=True)
        yield self.diagnostic(problem.span, message, labels=labels, fix=fix)

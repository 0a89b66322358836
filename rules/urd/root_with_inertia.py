from collections.abc import Iterator

from sdfcheck import Bad, Diagnostic, Good, Rule, Severity, problems

MASS = '<inertial><mass value="1"/><inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial>'
JOINT = '<joint name="j" type="fixed"><parent link="a"/><child link="b"/></joint></robot>'


class RootWithInertia(Rule):
    """The root link has mass, which KDL drops.

    robot_state_publisher and whatever else uses KDL prints a warning at every start.
    Nothing is wrong with the robot: whoever wants silence adds an empty root link, and a
    fixed joint to the old one. Taking the mass away breaks it for simulators.
    """

    code = "URD008"
    name = "root-with-inertia"
    severity = Severity.INFO
    explains = (problems.RootWithInertia,)

    bad = (
        Bad(
            f'<robot name="r"><link name="a">{MASS.replace("inertial", "«inertial»", 1)}</link>'
            f'<link name="b"/>{JOINT}',
            says="root link `a` has mass, which KDL drops",
        ),
    )
    good = (
        Good(f'<robot name="r"><link name="a"/><link name="b">{MASS}</link>{JOINT}', why="an empty root"),
        Good(f'<robot name="r"><link name="a">{MASS}</link></robot>', why="a thing, not a chain of links"),
    )

    def check(self, problem: problems.RootWithInertia) -> Iterator[Diagnostic]:
        message = f"root {problem.link.title} has mass, which KDL drops"
        advice = "put an empty link above it, with a fixed joint"
        yield self.diagnostic(problem.inertial, message, labels={problem.link: "the root"}, help=advice)

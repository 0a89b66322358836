from collections.abc import Iterator

from sdfcheck import (
    IN_MODEL,
    IN_ROBOT,
    Bad,
    Consumer,
    Diagnostic,
    Edit,
    Good,
    Rule,
    Severity,
    make_fix,
    problems,
    warns,
)

OLD, NEW = "http://ignitionrobotics.org/schema", "http://gazebosim.org/schema"


class IgnitionName(Rule):
    """A plugin, element or prefix is called after Ignition, as Gazebo was up to Fortress.

    Gazebo Garden still took the old names, with a warning; later releases do not find the
    plugins and pass over the elements. Fortress takes the new names of plugins as well.
    """

    code = "GAZ001"
    name = "ignition-name"
    severity = Severity.WARNING
    affects = {Consumer.GAZEBO: warns("does not find it, from Harmonic on")}
    explains = (problems.IgnitionName,)
    scaffold = IN_MODEL

    bad = (
        Bad(
            '<plugin filename="«libignition-gazebo-diff-drive-system.so»" '
            'name="ignition::gazebo::systems::DiffDrive"/>',
            fixed='<plugin filename="gz-sim-diff-drive-system" name="gz::sim::systems::DiffDrive"/>',
            says="`libignition-gazebo-diff-drive-system.so` is now called `gz-sim-diff-drive-system`",
        ),
        Bad(
            '<plugin filename="gz-sim-imu-system" name="«ignition::gazebo::systems::Imu»"/>',
            fixed='<plugin filename="gz-sim-imu-system" name="gz::sim::systems::Imu"/>',
        ),
        Bad(
            '<gazebo><plugin filename="«ignition-gazebo6-imu-system»" name="imu"/></gazebo>',
            fixed='<gazebo><plugin filename="gz-sim-imu-system" name="imu"/></gazebo>',
            scaffold=IN_ROBOT,
        ),
        Bad(
            '<plugin filename="MinimalScene" name="3D View"><«ignition-gui»><title>3D View</title>'
            "</ignition-gui></plugin>",
            fixed='<plugin filename="MinimalScene" name="3D View"><gz-gui><title>3D View</title></gz-gui></plugin>',
        ),
        Bad(
            f'<sdf version="1.9" xmlns:ignition="{OLD}"><model name="m"><link name="l">'
            "<«ignition»:note>a</ignition:note><ignition:note/></link></model></sdf>",
            fixed=f'<sdf version="1.9" xmlns:gz="{NEW}"><model name="m"><link name="l">'
            "<gz:note>a</gz:note><gz:note/></link></model></sdf>",
            says="`ignition` is now called `gz`",
            scaffold="{}",
        ),
        Bad(
            f'<sdf version="1.9" xmlns:gz="{NEW}" xmlns:ignition="{OLD}"><model name="m" gz:a="1">'
            '<link name="l" «ignition»:kind="a"/></model></sdf>',
            fixed=f'<sdf version="1.9" xmlns:gz="{NEW}"><model name="m" gz:a="1">'
            '<link name="l" gz:kind="a"/></model></sdf>',
            scaffold="{}",
        ),
    )
    good = (
        Good('<plugin filename="gz-sim-diff-drive-system" name="gz::sim::systems::DiffDrive"/>'),
        Good(
            '<plugin filename="own-system" name="my::ignition::Spark"/>',
            why="the ignition of one's own engine",
        ),
        Good(
            "<include><uri>https://fuel.ignitionrobotics.org/1.0/a/models/b</uri></include>",
            why="the old address still leads there",
        ),
    )

    def check(self, problem: problems.IgnitionName) -> Iterator[Diagnostic]:
        edits = tuple(Edit(span, text) for span, text in problem.changes)
        fix = make_fix(f"rename it to `{problem.new}`", edits)
        yield self.diagnostic(problem.span, f"`{problem.old}` is now called `{problem.new}`", fix=fix)

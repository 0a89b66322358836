from collections.abc import Iterator

from sdfcheck import (
    IN_LINK,
    IN_MODEL,
    IN_WORLD,
    Bad,
    Consumer,
    Diagnostic,
    Good,
    Rule,
    Severity,
    problems,
    used,
    warns,
)


class ClassicOnlyElement(Rule):
    """An element, sensor type or plugin that only Gazebo Classic reads.

    Gazebo Classic came to its end in 2025. Its successor loads other plugins, does
    sound, grippers and the view with plugins, and has no populations, roads or saved states.
    The elements are passed over; a plugin that cannot be loaded is an error on the console.
    """

    code = "GAZ002"
    name = "classic-only-element"
    severity = Severity.WARNING
    default = False
    affects = {Consumer.GAZEBO: warns("ignores it")}
    explains = (problems.ClassicOnlyElement,)
    scaffold = IN_MODEL

    bad = (
        Bad(
            '<plugin filename="«libgazebo_ros_diff_drive.so»" name="drive"/>',
            says="plugin `libgazebo_ros_diff_drive.so` is for Gazebo Classic only",
        ),
        Bad(
            '<«road» name="a"><point>0 0 0</point><point>1 0 0</point></road>',
            says="`road` in `world` is for Gazebo Classic only",
            scaffold=IN_WORLD,
        ),
        Bad(
            '<sensor name="s" type="«sonar»"><sonar><min>0</min><max>1</max></sonar></sensor>',
            scaffold=IN_LINK,
        ),
        Bad(
            "<«audio_sink»/><audio_sink/>",
            says="(used 2 times)",
            scaffold=IN_LINK,
        ),
    )
    good = (
        Good('<plugin filename="gz-sim-diff-drive-system" name="gz::sim::systems::DiffDrive"/>'),
        Good('<plugin filename="libmine.so" name="mine"/>', why="nobody knows for whom it was built"),
        Good(
            '<sensor name="s" type="camera"><camera/></sensor>',
            why="a sensor, not the view",
            scaffold=IN_LINK,
        ),
    )

    def check(self, problem: problems.ClassicOnlyElement) -> Iterator[Diagnostic]:
        yield self.diagnostic(
            problem.target, f"{problem.what} is for Gazebo Classic only{used(problem.count)}"
        )

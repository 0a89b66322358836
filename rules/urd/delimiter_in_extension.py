from collections.abc import Iterator

from sdfcheck import IN_ROBOT, Bad, Consumer, Diagnostic, GazeboBlock, Good, Rule, Severity, Value, refuses


class DelimiterInExtension(Rule):
    """A name inside `gazebo` contains `::`.

    When libsdformat has converted the robot it checks all names for `::`, those of a
    plugin's own elements included, and refuses the whole robot for one. Only the name of
    a plugin itself, mostly a C++ class, may hold it.
    """

    code = "URD017"
    name = "delimiter-in-extension"
    severity = Severity.WARNING
    affects = {Consumer.GAZEBO: refuses("refuses the robot")}
    looks_at = (GazeboBlock,)
    selects = ("urdf:robot/gazebo",)
    scaffold = IN_ROBOT

    bad = (
        Bad(
            '<gazebo><plugin name="p" filename="p"><joint name="«r::j»"/></plugin></gazebo>',
            says="`r::j` contains `::`, for which libsdformat refuses the robot",
        ),
    )
    good = (
        Good('<gazebo><plugin name="gz::sim::systems::Imu" filename="p"/></gazebo>', why="a plugin's class"),
        Good(
            '<gazebo><plugin name="p" filename="p"><joint>r::j</joint></plugin></gazebo>', why="text is free"
        ),
    )

    @staticmethod
    def applies(block: GazeboBlock) -> bool:
        return "::" in block.document.source.text and bool(delimited(block))

    def check(self, block: GazeboBlock) -> Iterator[Diagnostic]:
        for value in delimited(block):
            message = f"the name `{value.text}` contains `::`, for which libsdformat refuses the robot"
            yield self.diagnostic(value, message)


def delimited(block: GazeboBlock) -> list[Value]:
    named = (element.attribute("name") for element in block.all_elements() if element.name != "plugin")
    return [value for value in named if value is not None and "::" in value.text]

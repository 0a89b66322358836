from collections.abc import Iterator

from sdfcheck import IN_ROBOT, Bad, Diagnostic, Element, GazeboBlock, Good, Rule, Severity, Value


class DelimiterInExtension(Rule):
    """A name inside `gazebo` contains `::`.

    When libsdformat has converted the robot it checks the names of sensors, links and joints for `::`
    and refuses the whole robot for one; before version 17 its checker alone does. A plugin's own name,
    mostly a C++ class, may hold it, and so may whatever is inside a plugin.
    """

    code = "URD017"
    name = "delimiter-in-extension"
    severity = Severity.WARNING
    remedy = """Rename it without `::`, for example with an underscore.

    Topics that contain the name change with it. A scope is not needed: names in a robot are unique.
    """
    looks_at = (GazeboBlock,)
    selects = ("urdf:robot/gazebo",)
    scaffold = IN_ROBOT

    bad = (
        Bad(
            '<gazebo reference="base"><sensor name="«r::s»" type="imu"/></gazebo>',
            says="`r::s` contains `::`, for which libsdformat refuses the robot",
        ),
    )
    good = (
        Good('<gazebo><plugin name="gz::sim::systems::Imu" filename="p"/></gazebo>', why="a plugin's class"),
        Good(
            '<gazebo><plugin name="p" filename="p"><joint name="r::j">r::j</joint></plugin></gazebo>',
            why="a plugin's own element",
        ),
    )

    @staticmethod
    def applies(block: GazeboBlock) -> bool:
        return block.document.source.contains("::") and bool(delimited(block))

    def check(self, block: GazeboBlock) -> Iterator[Diagnostic]:
        for value in delimited(block):
            message = f"the name `{value.text}` contains `::`, for which libsdformat refuses the robot"
            yield self.diagnostic(value, message)


def delimited(block: GazeboBlock) -> list[Value]:
    named = (element.attribute("name") for element in block.all_elements() if not _is_in_plugin(element))
    return [value for value in named if value is not None and "::" in value.text]


def _is_in_plugin(element: Element) -> bool:
    """Is it a plugin, or inside one?"""
    return element.name == "plugin" or any(around.name == "plugin" for around in element.around)

import re
from collections.abc import Iterator

from sdfcheck import (
    IN_LINK,
    Bad,
    Diagnostic,
    Element,
    Good,
    Plugin,
    Rule,
    Severity,
    TextEdit,
    make_fix,
    rename,
)

PLUGIN = (
    '<sensor name="s" type="imu"><plugin name="p" filename="libgazebo_ros_imu_sensor.so"><ros>{}</ros></plugin>'
    "</sensor>"
)
ONE_COLON = re.compile(r"([^\s:=${}]+):(?!=)([^\s:=]+)")
JOINED = re.compile(r"--ros-args\s+(?:-r|--remap)\s+([^\s:=${}]+:=\S+)")


class OutdatedRemapping(Rule):
    """A remapping of a plugin of Gazebo Classic is written as an argument, or lacks its `:=`.

    `gazebo_ros` reads `<remapping>from:=to</remapping>`. In `<argument>` the same still works, and ROS 2 warns at each
    start that it will not for ever; with a colon alone it lacks the `=` of a remapping, so the topic keeps its name.
    It does as well where `--ros-args` is in the same text: `gazebo_ros` hands each `<argument>` on in one piece
    (`node.cpp`), and `rcl` compares whole arguments with `--ros-args` (`arguments.c`).
    """

    code = "GAZ040"
    name = "outdated-remapping"
    severity = Severity.WARNING
    remedy = "Write `<remapping>~/out:=scan</remapping>`."
    looks_at = (Plugin,)
    needs = ("argument", "remapping")
    scaffold = IN_LINK

    bad = (
        Bad(
            PLUGIN.format("<argument>«~/out:scan»</argument>"),
            fixed=PLUGIN.format("<remapping>~/out:=scan</remapping>"),
            unsafe=True,
            says="`~/out:scan` lacks the `=` of a remapping, so the topic keeps its name",
        ),
        Bad(
            PLUGIN.format("<remapping>«~/out:scan»</remapping>"),
            fixed=PLUGIN.format("<remapping>~/out:=scan</remapping>"),
            unsafe=True,
        ),
        Bad(
            PLUGIN.format("<«argument»>~/out:=scan</argument>"),
            fixed=PLUGIN.format("<remapping>~/out:=scan</remapping>"),
            unsafe=True,
            says="a remapping in `argument` is deprecated in ROS 2",
        ),
        Bad(
            PLUGIN.format("<argument>«--ros-args --remap ~/out:=scan»</argument>"),
            fixed=PLUGIN.format("<remapping>~/out:=scan</remapping>"),
            unsafe=True,
            says="`--ros-args --remap ~/out:=scan` reaches ROS 2 as one argument, so the topic keeps its name",
        ),
    )
    good = (
        Good(PLUGIN.format("<remapping>~/out:=scan</remapping>")),
        Good(
            PLUGIN.format(
                "<argument>--ros-args</argument><argument>-r</argument><argument>~/out:=scan</argument>"
            ),
            why="three arguments",
        ),
        Good(PLUGIN.format("<argument>__node:=front</argument>"), why="a name of a node"),
    )

    @staticmethod
    def applies(plugin: Plugin) -> bool:
        return any(True for _ in rules_of(plugin))

    def check(self, plugin: Plugin) -> Iterator[Diagnostic]:
        for element in rules_of(plugin):
            text = element.content.strip()
            renamed = rename("remapping", element)
            if ":=" in text and not text.startswith("-"):
                message = "a remapping in `argument` is deprecated in ROS 2"
                yield self.diagnostic(element, message, severity=Severity.INFO, fix=renamed)
                continue
            joined = JOINED.fullmatch(text)
            meant = joined[1] if joined else text.replace(":", ":=", 1)
            edits: tuple[TextEdit, ...] = (TextEdit(element.own_value.span, meant),)
            if element.name == "argument" and renamed is not None:
                edits += renamed.edits
            fix = make_fix("write a remapping", edits, unsafe=True)
            fault = "reaches ROS 2 as one argument" if joined else "lacks the `=` of a remapping"
            yield self.diagnostic(
                element.own_value, f"`{text}` {fault}, so the topic keeps its name", fix=fix
            )


def rules_of(plugin: Plugin) -> Iterator[Element]:
    """The elements with a remapping that is out of date, or none."""
    for ros in plugin.children("ros"):
        is_flagged = any(each.content.strip() == "--ros-args" for each in ros.children("argument"))
        for element in ros.children():
            text = element.content.strip()
            is_plain = ":=" in text and not is_flagged and not text.startswith(("-", "__"))
            is_old = element.name == "argument" and (is_plain or JOINED.fullmatch(text))
            if is_old or (element.name in {"argument", "remapping"} and ONE_COLON.fullmatch(text)):
                yield element

from collections.abc import Iterator

from sdfcheck import Bad, Consumer, Diagnostic, Good, Root, Rule, Severity, accepts

ROBOT = (
    '<{} xmlns:xacro="http://www.ros.org/wiki/xacro" name="r"><xacro:property name="n" value="a"/>'
    '<link name="${{n}}"/></robot>'
)
PATH = 'path = os.path.join(get_package_share_directory("arm"), "urdf", "arm.urdf.xacro")\n'
COMMAND = PATH + 'text = ParameterValue(Command(["xacro{}", path]), value_type=str)\n'
READ = PATH + "text = open(path).read()\n"
FORMER = (
    '<launch><param name="robot_description" command="$(find xacro)/{} $(find arm)/urdf/arm.urdf.xacro"/>'
    "</launch>\n"
)
PACKAGE = "<package><name>arm</name></package>"
WORDS = {
    "joined": "joins the name of xacro and that of this file, so that no program is found: "
    'write `"xacro "` with the space',
    "read": "gives this file to its nodes as it is written, and no consumer of URDF knows xacro",
    "gone": "expands this file with `xacro.py`, which Noetic does not have",
}

TAKEN = dict.fromkeys(Consumer, accepts("takes what other releases of xacro expand it to"))


def launch(text: str, name: str = "view.launch.py") -> dict[str, str]:
    return {f"launch/{name}": text, "package.xml": PACKAGE}


class UnexpandedLaunch(Rule):
    """A launch file does not get the robot that this file of xacro expands to.

    `Command` joins its texts without spaces: `Command(["xacro", path])` looks for a program called `xacro/…/arm.xacro`
    and ends with "file not found". A file that is opened instead is given to `robot_state_publisher` with its macros,
    which knows none of them. In Noetic, the last ROS 1, the program `xacro.py` is called `xacro`; that one is for
    information, as older releases have both.
    """

    code = "RES033"
    name = "unexpanded-launch"
    severity = Severity.ERROR
    remedy = """Write `Command(["xacro ", path])` with a space, or `xacro.process_file(path).toxml()`.

    In ROS 2 the result goes into `ParameterValue(…, value_type=str)`; in ROS 1 `command="xacro $(find …)/…"` will do.
    """
    looks_at = (Root,)
    scaffold = "{}"

    bad = (
        Bad(
            ROBOT.format("«robot»"),
            file="urdf/arm.urdf.xacro",
            files=launch(COMMAND.format("")),
            says="`view.launch.py` joins the name of xacro and that of this file",
        ),
        Bad(
            ROBOT.format("«robot»"),
            file="urdf/arm.urdf.xacro",
            files=launch(READ),
            says="`view.launch.py` gives this file to its nodes as it is written",
        ),
        Bad(
            ROBOT.format("«robot»"),
            file="urdf/arm.urdf.xacro",
            files=launch(FORMER.format("xacro.py"), "view.launch"),
            says="`view.launch` expands this file with `xacro.py`",
        ),
    )
    good = (
        Good(ROBOT.format("robot"), file="urdf/arm.urdf.xacro", files=launch(COMMAND.format(" "))),
        Good(
            ROBOT.format("robot"),
            file="urdf/arm.urdf.xacro",
            files=launch(READ + COMMAND.format(" ")),
            why="it is expanded as well",
        ),
        Good(
            ROBOT.format("robot"),
            file="urdf/arm.urdf.xacro",
            files=launch(FORMER.format("xacro"), "view.launch"),
        ),
    )

    @staticmethod
    def applies(root: Root) -> bool:
        return root.launch_fault is not None

    def check(self, root: Root) -> Iterator[Diagnostic]:
        fault = root.launch_fault
        assert fault is not None
        message = f"`{fault.span.source.path.name}` {WORDS[fault.kind]}"
        labels = {fault.span: "here"}
        if fault.kind == "gone":
            yield self.diagnostic(root.element, message, labels=labels, severity=Severity.INFO, affects=TAKEN)
        else:
            yield self.diagnostic(root.element, message, labels=labels)

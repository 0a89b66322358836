from collections.abc import Iterator

from sdfcheck import Bad, Diagnostic, Good, Rule, Severity, problems, replace

FILE = "claw.urdf.xacro"
IN_XACRO = '<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">{}</robot>'
CLAW = (
    """<xacro:macro name="claw" params="prefix:=''"><link name="${prefix}palm"/><link name="${prefix}left"/>"""
    '<joint name="${prefix}slide" type="fixed"><parent link="{}"/><child link="${prefix}left"/></joint>'
    "</xacro:macro><xacro:claw/>"
)
BOAT = (
    '<xacro:arg name="ns" default="boat"/><link name="$(arg ns)/hull"/><link name="$(arg ns)/mast"/>'
    '<joint name="$(arg ns)/foot" type="fixed"><parent link="{}"/><child link="$(arg ns)/mast"/></joint>'
)


class ForgottenPrefix(Rule):
    """A link or joint is named without the prefix that its own name gets.

    The name is right only as long as nobody calls the macro with a prefix, or gives the file another one as an
    argument; from then on it reaches nothing.
    """

    code = "XAC029"
    name = "forgotten-prefix"
    severity = Severity.WARNING
    remedy = """Write the prefix before the name, as where it is defined: `${prefix}palm`.

    A link that another file brings under the plain name is rightly without it: give it to the macro as a
    parameter, `parent`.
    """
    explains = (problems.ForgottenPrefix, problems.NameByDefault)
    scaffold = IN_XACRO

    bad = (
        Bad(
            CLAW.replace("{}", "«palm»"),
            fixed=CLAW.replace("{}", "${prefix}palm"),
            unsafe=True,
            file=FILE,
            says="the macro defines `${prefix}palm`, not `palm`",
        ),
        Bad(
            '<xacro:macro name="rotor" params="ns"><link name="${ns}/hub"/><gazebo><plugin name="p" filename="p.so">'
            "<linkName>«hub»</linkName></plugin></gazebo></xacro:macro>",
            fixed='<xacro:macro name="rotor" params="ns"><link name="${ns}/hub"/><gazebo>'
            '<plugin name="p" filename="p.so"><linkName>${ns}/hub</linkName></plugin></gazebo></xacro:macro>',
            unsafe=True,
            file="rotor.xacro",
        ),
        Bad(
            BOAT.replace("{}", "«boat/hull»"),
            fixed=BOAT.replace("{}", "$(arg ns)/hull"),
            unsafe=True,
            file=FILE,
            says="the name `$(arg ns)/hull` is not always `boat/hull`",
        ),
    )
    good = (
        Good(CLAW.replace("{}", "${prefix}palm"), file=FILE),
        Good(
            '<xacro:macro name="rotor" params="ns"><link name="${ns}/hub"/><gazebo><plugin name="p" filename="p.so">'
            "<frameId>hub</frameId></plugin></gazebo></xacro:macro>",
            why="programs of ROS may add the prefix to frames",
            file="rotor.xacro",
        ),
        Good(BOAT.replace("{}", "$(arg ns)/hull"), file=FILE),
        Good('<link name="palm"/>' + CLAW.replace("{}", "palm"), why="another link has the name", file=FILE),
    )

    def check(self, problem: problems.ForgottenPrefix | problems.NameByDefault) -> Iterator[Diagnostic]:
        assert problem.near is not None
        labels = {problem.other: "defined with the prefix"} if problem.other else None
        fix = replace(problem.span, problem.near, f"write `{problem.near}`", unsafe=True)
        message = f"the macro defines `{problem.near}`, not `{problem.name}`"
        if isinstance(problem, problems.NameByDefault):
            message = f"the name `{problem.near}` is not always `{problem.name}`"
        yield self.diagnostic(problem.span, message, labels=labels, fix=fix)

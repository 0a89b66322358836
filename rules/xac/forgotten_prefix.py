from collections.abc import Iterator

from sdfcheck import Bad, Diagnostic, Good, Rule, Severity, problems, replace

FILE = "claw.urdf.xacro"
IN_XACRO = '<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">{}</robot>'
CLAW = (
    """<xacro:macro name="claw" params="prefix:=''"><link name="${prefix}palm"/><link name="${prefix}left"/>"""
    '<joint name="${prefix}slide" type="fixed"><parent link="{}"/><child link="${prefix}left"/></joint>'
    "</xacro:macro><xacro:claw/>"
)


class ForgottenPrefix(Rule):
    """A macro names a link or joint without the prefix that it gives it.

    The name is right only as long as nobody calls the macro with a prefix; from then on it reaches nothing.
    """

    code = "XAC029"
    name = "forgotten-prefix"
    severity = Severity.WARNING
    remedy = """Write the prefix before the name, as where it is defined: `${prefix}palm`.

    A link that another file brings under the plain name is rightly without it: give it to the macro as a
    parameter, `parent`.
    """
    explains = (problems.ForgottenPrefix,)
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
    )
    good = (
        Good(CLAW.replace("{}", "${prefix}palm"), file=FILE),
        Good(
            '<xacro:macro name="rotor" params="ns"><link name="${ns}/hub"/><gazebo><plugin name="p" filename="p.so">'
            "<frameId>hub</frameId></plugin></gazebo></xacro:macro>",
            why="programs of ROS may add the prefix to frames",
            file="rotor.xacro",
        ),
        Good('<link name="palm"/>' + CLAW.replace("{}", "palm"), why="another link has the name", file=FILE),
    )

    def check(self, problem: problems.ForgottenPrefix) -> Iterator[Diagnostic]:
        assert problem.near is not None
        labels = {problem.other: "defined with the prefix"} if problem.other else None
        fix = replace(problem.span, problem.near, f"write `{problem.near}`", unsafe=True)
        message = f"the macro defines `{problem.near}`, not `{problem.name}`"
        yield self.diagnostic(problem.span, message, labels=labels, fix=fix)

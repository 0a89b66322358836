from collections.abc import Iterator

from sdfcheck import Bad, Consumer, Diagnostic, Good, Rule, Severity, problems, refuses, replace, unexpanded
from sdfcheck_rules.xac.scaffold import FILE, IN_XACRO

URDF = "robot.urdf.xacro"
JOINED = (
    '<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro"><xacro:property name="w" value="1"/><link name="a"/>'
    '<link name="b"/><joint name="j" type="fixed"><parent link="a"/><child link="b"/><origin rpy="0 {} 0"/></joint>'
    "</robot>"
)


class UnevaluatedExpression(Rule):
    """Something looks like an expression of xacro but is not one.

    Braces without a dollar sign stay as they are, so that a link is called `{side}_wheel`
    in the robot, and so does a name after a dollar sign without braces. In the place of a number, names stay as well
    that have neither: urdfdom then refuses the robot, and others take 0. For an expression without its end xacro 2
    stops; older versions drop all that follows.
    """

    code = "XAC010"
    name = "unevaluated-expression"
    severity = Severity.ERROR
    remedy = """Write an expression as `${…}`, with both braces, and an argument as `$(arg …)`.

    For braces that are meant, ignore this; a dollar sign before a brace that is meant is written `$${`.
    """
    explains = (problems.UnevaluatedExpression,)
    scaffold = IN_XACRO

    bad = (
        Bad(
            '<xacro:macro name="m" params="side"><link name="${side}_a"/><link name="«{side}»_b"/></xacro:macro>'
            '<xacro:m side="l"/>',
            fixed='<xacro:macro name="m" params="side"><link name="${side}_a"/><link name="${side}_b"/>'
            '</xacro:macro><xacro:m side="l"/>',
            unsafe=True,
            file=FILE,
            says="`{side}` is not evaluated; did you mean `${side}`?",
        ),
        Bad(
            '<xacro:property name="w" value="1"/><link name="a"><inertial><mass>«{w}»</mass></inertial></link>',
            fixed='<xacro:property name="w" value="1"/><link name="a"><inertial><mass>${w}</mass></inertial></link>',
            unsafe=True,
            file=FILE,
        ),
        Bad(
            '<xacro:property name="w" value="1"/><link name="«$w»"/>',
            fixed='<xacro:property name="w" value="1"/><link name="${w}"/>',
            unsafe=True,
            file=FILE,
            says="`$w` is not evaluated; did you mean `${w}`?",
        ),
        Bad(
            JOINED.replace("{}", "«-w/2»"),
            fixed=JOINED.replace("{}", "${-w/2}"),
            unsafe=True,
            file=URDF,
            scaffold="{}",
            says="`-w/2` is not evaluated; did you mean `${-w/2}`?",
        ),
        Bad(
            JOINED.replace("{}", "«{pi/2}»"),
            fixed=JOINED.replace("{}", "${pi/2}"),
            unsafe=True,
            file=URDF,
            scaffold="{}",
        ),
        Bad(
            '<xacro:property name="w" value="1"/><link name="a${w}"/><link name="«${w_b»"/>',
            file=FILE,
            says="has no end",
        ),
    )
    good = (
        Good('<plugin name="p" filename="p"><format>{side}</format></plugin>', why="no such name", file=FILE),
        Good(
            JOINED.replace("{}", "${w}").replace('"j"', '"w"'),
            why="not in the place of a number",
            file=URDF,
            scaffold="{}",
        ),
        Good('<xacro:property name="w" value="1"/><link name="a$${w"/><link name="${w}"/>', file=FILE),
    )

    def check(self, problem: problems.UnevaluatedExpression) -> Iterator[Diagnostic]:
        text = problem.span.text
        if problem.is_open:
            affects = dict.fromkeys(Consumer, refuses("gets no robot description"))
            yield self.diagnostic(problem.span, f"the expression `{text}` has no end", affects=affects)
            return
        fix = replace(problem.span, problem.meant, f"make it `{problem.meant}`", unsafe=True)
        yield self.diagnostic(
            problem.span,
            f"`{text}` is not evaluated",
            meant=problem.meant,
            fix=fix,
            affects={} if problem.value is None else unexpanded((problem.value,)),
        )

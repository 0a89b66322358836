from collections.abc import Iterator

from sdfcheck import Bad, Diagnostic, Good, Rule, Severity, problems
from sdfcheck_rules.xac.scaffold import FILE, IN_XACRO

ARGUMENT = '<xacro:arg name="sim" default="true"/>'


class NeverEqualText(Rule):
    """A value is compared with a text that it can never equal.

    Arguments are texts, and texts are compared letter by letter: `'true' == 'True'` is false.
    Of a property whose text is `true` or `false` xacro makes a truth value, which equals no
    text: `${sim == 'true'}` is always false, and `${sim in ['false', 'fast']}` does not know
    the argument `sim:=false`.
    """

    code = "XAC025"
    name = "never-equal-text"
    severity = Severity.WARNING
    remedy = """Compare with the text as it is written, or take the truth value as it is.

    `<xacro:if value="$(arg sim)">` needs no comparison. In an expression, a property of `true` is `${sim}`,
    its opposite `${not sim}`. In a list, `False` goes without quotes: `${sim in [False, 'fast']}`.
    """
    explains = (problems.NeverEqualText, problems.TruthComparedWithText)
    scaffold = IN_XACRO

    bad = (
        Bad(
            ARGUMENT + """<xacro:if value="${«'$(arg sim)' == 'True'»}"><link name="a"/></xacro:if>""",
            file=FILE,
            says="`true` is not `True`",
        ),
        Bad(
            ARGUMENT + """<xacro:property name="sim" value="$(arg sim)"/>"""
            """<xacro:if value="${«sim == 'true'»}"><link name="a"/></xacro:if>""",
            file=FILE,
            says="`sim` never equals the text `true`: xacro makes a truth value of it",
        ),
        Bad(
            """<xacro:arg name="lidar" default="short"/><xacro:property name="lidar" value="$(arg lidar)"/>"""
            """<xacro:if value="${lidar in ['short', «'false'»]}"><link name="a"/></xacro:if>""",
            file=FILE,
            says="`lidar` never equals the text `false`: xacro makes a truth value of it",
        ),
    )
    good = (
        Good(
            ARGUMENT + """<xacro:if value="${'$(arg sim)' == 'true'}"><link name="a"/></xacro:if>""",
            file=FILE,
        ),
        Good(
            """<xacro:property name="kind" value="fast"/>"""
            """<xacro:if value="${kind == 'true'}"><link name="a"/></xacro:if>""",
            why="a text",
            file=FILE,
        ),
        Good(
            """<xacro:arg name="lidar" default="short"/><xacro:property name="lidar" value="$(arg lidar)"/>"""
            """<xacro:if value="${lidar in ['short', 'false', False]}"><link name="a"/></xacro:if>""",
            file=FILE,
        ),
    )

    def check(
        self, problem: problems.NeverEqualText | problems.TruthComparedWithText
    ) -> Iterator[Diagnostic]:
        if isinstance(problem, problems.TruthComparedWithText):
            message = (
                f"`{problem.name}` never equals the text `{problem.near}`: xacro makes a truth value of it"
            )
            yield self.diagnostic(
                problem.span, message, help=f"write `{str(problem.near).title()}`, without quotes"
            )
            return
        labels = {problem.other: "its default"} if problem.other else None
        message = f"`{problem.near}` is not `{problem.name}`: texts are compared letter by letter"
        yield self.diagnostic(problem.span, message, labels=labels)

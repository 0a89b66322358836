from collections.abc import Iterator

from sdfcheck import Bad, Diagnostic, Good, Rule, Severity, problems
from sdfcheck_rules.xac.scaffold import FILE, IN_XACRO


class OverwrittenProperty(Rule):
    """A property gets a value that is replaced before anything reads it.

    The last definition counts, in silence; the first one has no effect.
    """

    code = "XAC019"
    name = "overwritten-property"
    severity = Severity.WARNING
    remedy = """Remove the first definition, or rename one of the two.

    If the first is meant as a default, write `<xacro:property name="w" default="…"/>` after the other,
    which takes effect only where nothing is defined.
    """
    explains = (problems.OverwrittenProperty,)
    scaffold = IN_XACRO

    bad = (
        Bad(
            '<xacro:property name="«w»" value="1"/><xacro:property name="w" value="2"/><link name="l${w}"/>',
            file=FILE,
            says="`w` is defined again before anything reads this value",
        ),
    )
    good = (
        Good(
            '<xacro:property name="w" value="1"/><link name="l${w}"/><xacro:property name="w" value="2"/>'
            '<link name="m${w}"/>',
            why="read in between",
            file=FILE,
        ),
    )

    def check(self, problem: problems.OverwrittenProperty) -> Iterator[Diagnostic]:
        labels = {problem.other: "the value that counts"} if problem.other else None
        message = f"`{problem.name}` is defined again before anything reads this value"
        yield self.diagnostic(problem.span, message, labels=labels)

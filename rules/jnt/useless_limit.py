from collections.abc import Iterator

from sdfcheck import IN_MODEL, IN_ROBOT, Bad, Consumer, Diagnostic, Good, Rule, Severity, problems, warns

_ENDS = "<parent>base</parent><child>arm</child>"
_URDF_ENDS = '<parent link="base"/><child link="arm"/>'


class UselessLimit(Rule):
    """A joint has position limits that its type does not know.

    A continuous joint turns without end. A joint that is meant to stop somewhere is
    of type revolute.
    """

    code = "JNT011"
    name = "useless-limit"
    severity = Severity.WARNING
    affects = dict.fromkeys(Consumer, warns("has a joint that cannot be driven"))
    explains = (problems.UselessLimit,)
    scaffold = IN_MODEL

    bad = (
        Bad(
            f'<link name="arm"/><joint name="j" type="continuous">{_ENDS}<axis><xyz>0 0 1</xyz>'
            "<limit><lower>«-1»</lower><upper>1</upper></limit></axis></joint>",
            says="joint `j` of type continuous has no use for the limit -1",
        ),
        Bad(
            f'<link name="arm"/><joint name="j" type="continuous">{_URDF_ENDS}<axis xyz="0 0 1"/>'
            '<limit lower="«-1»" upper="1" effort="5" velocity="2"/></joint>',
            scaffold=IN_ROBOT,
            says="joint `j` of type continuous has no use for the limit -1",
        ),
    )
    good = (
        Good(
            f'<link name="arm"/><joint name="j" type="continuous">{_ENDS}<axis><xyz>0 0 1</xyz>'
            "<limit><lower>-1e16</lower><upper>1e16</upper><effort>5</effort></limit></axis></joint>",
            why="as good as no limit, and the effort counts",
        ),
    )

    def check(self, problem: problems.UselessLimit) -> Iterator[Diagnostic]:
        value = problem.value
        message = (
            f"{problem.joint.title} of type {problem.type} has no use for the limit {value.text.strip()}"
        )
        labels = dict.fromkeys(problem.others, "nor for this one")
        yield self.diagnostic(value, message, labels=labels)

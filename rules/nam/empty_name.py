from collections.abc import Iterator

from sdfcheck import IN_MODEL, REFUSES, Bad, Consumer, Diagnostic, Good, Rule, Severity, problems


class EmptyName(Rule):
    """A name is empty or blank.

    libsdformat stops reading there: what has a name must have one that can be referred to.
    """

    code = "NAM006"
    name = "empty-name"
    severity = Severity.ERROR
    affects = {Consumer.GAZEBO: REFUSES, Consumer.DRAKE: REFUSES, Consumer.URDFDOM: REFUSES}
    explains = (problems.EmptyName,)
    scaffold = IN_MODEL

    bad = (
        Bad('<link «name»=""/>', says="the name of `link` is empty"),
        Bad('<frame name="« »"/>', says="the name of `frame` is blank"),
    )
    good = (Good('<plugin name="" filename="p"/>', why="a plugin needs no name since 1.10"),)

    def check(self, problem: problems.EmptyName) -> Iterator[Diagnostic]:
        value = problem.value
        what = "blank" if value.text else "empty"
        message = f"the name of `{value.element.name}` is {what}"
        if problem.until is None:
            yield self.diagnostic(value, message)
            return
        message += f", and required up to version {problem.until}"
        yield self.diagnostic(value, message, severity=Severity.WARNING)

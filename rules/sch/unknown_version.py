from collections.abc import Iterator

from sdfcheck import REFUSES, Bad, Consumer, Diagnostic, Good, Rule, Severity, problems, replace


class UnknownVersion(Rule):
    """The file declares a version of the format that does not exist.

    libsdformat looks the version up as a text: `1.6.0`, `1.06` and ` 1.6` are all unknown
    to it, as is everything before 1.2. The load fails, and where the text does not begin
    with a number the program crashes.
    """

    code = "SCH002"
    name = "unknown-version"
    severity = Severity.ERROR
    affects = {Consumer.GAZEBO: REFUSES, Consumer.DRAKE: {"sdf": REFUSES}, Consumer.URDFDOM: REFUSES}
    explains = (problems.UnknownVersion,)
    scaffold = '<sdf version="{}"><model name="m"><link name="base"/></model></sdf>'

    bad = (
        Bad("«1.6.0»", fixed="1.6", unsafe=True, says="did you mean `1.6`?"),
        Bad("«1.13»", says="version `1.13` is not known"),
        Bad("«1,9»", fixed="1.9", unsafe=True, says="did you mean `1.9`?"),
    )
    good = (Good("1.2", why="the oldest that readers convert"), Good("1.10", why="ten, not one"))

    def check(self, problem: problems.UnknownVersion) -> Iterator[Diagnostic]:
        value, meant = problem.value, problem.meant
        message = f"version `{value.text}` is not known"
        known = f"known are {problem.oldest} to {problem.newest}"
        if meant is None:
            yield self.diagnostic(value, message, help=known)
            return
        fix = replace(value, meant, f"declare version {meant}", unsafe=True)
        yield self.diagnostic(value, f"{message}; did you mean `{meant}`?", fix=fix, help=known)

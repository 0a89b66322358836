from collections.abc import Iterator

from sdfcheck import IN_MODEL, REFUSES, Bad, Consumer, Diagnostic, Good, Rule, Severity, problems


class MalformedScopedName(Rule):
    """A reference has an empty part before, behind or between `::`.

    A scoped name leads down into nested models, one name after the other. There is no
    way up: a leading `::` does not mean the outermost scope, and finds nothing.
    """

    code = "NAM005"
    name = "malformed-scoped-name"
    severity = Severity.ERROR
    affects = {Consumer.GAZEBO: REFUSES, Consumer.DRAKE: REFUSES}
    explains = (problems.MalformedScopedName,)
    scaffold = IN_MODEL

    bad = (
        Bad('<frame name="f" attached_to="«::base»"/>', says="`::base` begins with `::`"),
        Bad('<frame name="f"><pose relative_to="«base::»"/></frame>', says="`base::` ends with `::`"),
        Bad(
            '<joint name="j" type="fixed"><parent>world</parent><child>«n::::l»</child></joint>'
            '<model name="n"><link name="l"/></model>',
            says="`n::::l` has an empty part",
        ),
    )
    good = (Good('<frame name="f" attached_to="n::l"/><model name="n"><link name="l"/></model>'),)

    def check(self, problem: problems.MalformedScopedName) -> Iterator[Diagnostic]:
        name = problem.value.text.strip()
        if name.startswith("::"):
            what = "begins with `::`, and no reference leads out of its scope"
        else:
            what = "ends with `::`" if name.endswith("::") else "has an empty part"
        yield self.diagnostic(problem.value, f"scoped name `{name}` {what}")

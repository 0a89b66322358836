from collections.abc import Iterator

from sdfcheck import IN_MODEL, REFUSES, Bad, Consumer, Diagnostic, Good, Rule, Severity, Value, problems


class DelimiterInName(Rule):
    """A name contains `::`, which parts the names of scopes in references.

    From version 1.8 on libsdformat refuses it. In worlds up to 1.7 it takes `A::x` for
    `x` in a nested model `A`, and the program crashes when something in `A` refers to
    what lies outside.
    """

    code = "NAM004"
    name = "delimiter-in-name"
    severity = Severity.ERROR
    affects = {Consumer.GAZEBO: REFUSES, Consumer.DRAKE: {"sdf": REFUSES}}
    explains = (problems.DelimiterInName,)
    scaffold = IN_MODEL

    bad = (
        Bad('<link name="«arm::tip»"/>', says="the name `arm::tip` contains `::`"),
        Bad(
            '<sdf version="1.7"><model name="m"><link name="«arm::tip»"/></model></sdf>',
            scaffold="",
            says="which parts the names of scopes",
        ),
        Bad(
            '<sdf version="1.7"><world name="w"><model name="m"><link name="b"/>'
            '<frame name="«A::f»" attached_to="b"/></model></world></sdf>',
            scaffold="",
            says="`A::f` cannot be taken apart, because `b` is not in `A`",
        ),
    )
    good = (
        Good(
            '<frame name="f" attached_to="n::l"/><model name="n"><link name="l"/></model>', why="a reference"
        ),
        Good('<link name="arm:tip"/>'),
        Good('<plugin name="sim::Plugin" filename="p"/>', why="the names of plugins are free"),
    )

    def check(self, problem: problems.DelimiterInName) -> Iterator[Diagnostic]:
        value, foreign = problem.value, problem.foreign
        name = value.text.strip()
        if foreign is not None:
            scope = name.partition("::")[0]
            why = (
                f"`{foreign.text}` is not in `{scope}`"
                if isinstance(foreign, Value)
                else "its axis has no `xyz`"
            )
            yield self.diagnostic(
                value,
                f"`{name}` cannot be taken apart, because {why}: libsdformat crashes",
                labels={foreign: "this is in the way"},
            )
            return
        message = f"the name `{name}` contains `::`, which parts the names of scopes"
        yield self.diagnostic(value, message, severity=None if problem.refused else Severity.WARNING)

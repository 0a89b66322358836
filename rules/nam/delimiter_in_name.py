from collections.abc import Iterator

from sdfcheck import IN_MODEL, REFUSES, Bad, Consumer, Diagnostic, Good, Name, Root, Rule, Severity, Value


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
    looks_at = (Root,)
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

    @staticmethod
    def applies(root: Root) -> bool:
        return any(map(_is_divided, root.names.special))

    def check(self, root: Root) -> Iterator[Diagnostic]:
        for given in filter(_is_divided, root.names.special):
            name, obstacle = given.name, root.names.obstacles.get(given.value.element)
            if obstacle is None:
                severity = Severity.WARNING if root.is_older_than("1.8") else None
                message = f"the name `{name}` contains `::`, which parts the names of scopes"
                yield self.diagnostic(given.value, message, severity=severity)
                continue
            is_reference = isinstance(obstacle, Value)
            why = (
                f"`{obstacle.text}` is not in `{name.partition('::')[0]}`"
                if is_reference
                else "its axis has no `xyz`"
            )
            message = f"`{name}` cannot be taken apart, because {why}: libsdformat crashes"
            yield self.diagnostic(given.value, message, labels={obstacle: "this is in the way"})


def _is_divided(name: Name) -> bool:
    """Does it have a delimiter where one is not allowed? Custom elements and materials are free to."""
    return "::" in name.name and ":" not in name.kind and name.kind != "material"

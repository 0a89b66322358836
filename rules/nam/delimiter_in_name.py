from collections.abc import Iterator

from sdfcheck import (
    IN_MODEL,
    REFUSES,
    Bad,
    Consumer,
    Diagnostic,
    Good,
    Name,
    Root,
    Rule,
    Severity,
    Value,
    accepts,
)


class DelimiterInName(Rule):
    """A name contains `::`, which separates the names of scopes in references.

    From version 1.8 on libsdformat refuses it; in older files it is worth knowing only. In
    worlds up to 1.7 libsdformat takes `A::x` for `x` in a nested model `A`, and the program
    crashes when something in `A` refers to what lies outside.
    """

    code = "NAM004"
    name = "delimiter-in-name"
    severity = Severity.ERROR
    remedy = """Replace `::` in the name, for example by an underscore, and in all references.

    For a part that is in a nested model, write the nested model itself: `::` is then how to refer to it
    from outside. Files that were converted from old merged models get their nested models back by an
    `<include>`.
    """
    looks_at = (Root,)
    scaffold = IN_MODEL

    bad = (
        Bad('<link name="«arm::tip»"/>', says="the name `arm::tip` contains `::`"),
        Bad(
            '<sdf version="1.7"><model name="m"><link name="«arm::tip»"/></model></sdf>',
            scaffold="",
            says="does not allow from 1.8 on",
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
                yield self.unseparated(given, is_old=root.is_older_than("1.8"))
                continue
            is_reference = isinstance(obstacle, Value)
            why = (
                f"`{obstacle.text}` is not in `{name.partition('::')[0]}`"
                if is_reference
                else "its axis has no `xyz`"
            )
            message = f"`{name}` cannot be taken apart, because {why}: libsdformat crashes"
            yield self.diagnostic(given.value, message, labels={obstacle: "this is in the way"})

    def unseparated(self, given: Name, *, is_old: bool) -> Diagnostic:
        if not is_old:
            message = f"the name `{given.name}` contains `::`, which separates the names of scopes"
            return self.diagnostic(given.value, message)
        message = f"the name `{given.name}` contains `::`, which SDFormat does not allow from 1.8 on"
        affects = dict.fromkeys(Consumer, accepts("takes it in this version"))
        if given.kind == "link":
            affects[Consumer.DRAKE] = REFUSES
        return self.diagnostic(given.value, message, severity=Severity.INFO, affects=affects)


def _is_divided(name: Name) -> bool:
    """Does it have a delimiter where one is not allowed? Custom elements and materials are free to.

    Those in `<gazebo>` blocks are the business of delimiter-in-extension.
    """
    is_free = ":" in name.kind or name.kind == "material" or name.is_extension
    return "::" in name.name and not is_free

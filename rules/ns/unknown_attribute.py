from collections.abc import Iterator

from sdfcheck import IN_MODEL, Bad, Diagnostic, Good, Rule, Severity, problems, replace


class UnknownAttribute(Rule):
    """An attribute without prefix is not in the specification of its element.

    The custom-elements proposal keeps names without prefix for the standard; attributes
    of one's own are given a prefix, those of custom elements are free. libsdformat warns
    and goes on as if the attribute were not there; Drake refuses the file. It is a warning,
    because Gazebo, for which most files are written, ignores it. For Drake, set it to `error`
    under `[severity]`. Where the misspelling leaves out what is required, it is an error.
    """

    code = "NS001"
    name = "unknown-attribute"
    severity = Severity.WARNING
    remedy = """Write the attribute as the specification has it, or give it a declared prefix.

    `sdfcheck describe link` and the like list the attributes of an element. An attribute of your own is
    `mine:color`, with `xmlns:mine="…"` on the root element; a note belongs in a comment.
    """
    explains = (problems.UnknownAttribute,)
    scaffold = IN_MODEL

    bad = (
        Bad(
            '<frame name="f" «atached_to»="base"/>',
            fixed='<frame name="f" attached_to="base"/>',
            unsafe=True,
            says="unknown attribute `atached_to` of frame `f`; did you mean `attached_to`?",
        ),
        Bad(
            '<link name="arm" «gravity»="false" self_collide="true"/>',
            says="`gravity` and 1 more of link `arm` are elements, not attributes",
        ),
        Bad('<link name="arm" «color»="red"/>', says="unknown attribute `color` of link `arm`"),
        Bad(
            '<frame name="f" attached_to="base" «atached_to»="base"/>',
            says="unknown attribute `atached_to` of frame `f`",
        ),
    )
    good = (
        Good(
            '<p:wheel xmlns:p="https://example.org/p" name="w" color="red"/>',
            why="attributes of custom elements are free",
        ),
        Good('<link xmlns:p="https://example.org/p" name="arm" p:color="red"/>', why="it has a prefix"),
        Good(
            '<sdf version="1.6"><model name="m"><link name="l"/><include><uri>model://arm</uri>'
            '<pose frame="">0 0 0 0 0 0</pose></include></model></sdf>',
            why="libsdformat converts it in every pose",
            scaffold="{}",
        ),
        Good(
            '<plugin name="p" filename="p"><link name="base" color="red"/></plugin>',
            why="the content of a plugin is the plugin's",
        ),
    )

    def check(self, problem: problems.UnknownAttribute) -> Iterator[Diagnostic]:
        element, name, guess = problem.element, problem.attribute, problem.suggestion
        if name == "degrees" and element.has("pose"):
            return  # the business of misplaced-degrees
        attribute = element.attribute(name)
        place = attribute.name_span if attribute is not None else element.span
        message = f"unknown attribute `{name}` of {element.title}"
        if problem.child is not None:
            message = f"`{name}` of {element.title} is an element, not an attribute"
            if problem.others:
                message = (
                    f"`{name}` and {len(problem.others)} more of {element.title} are elements, not attributes"
                )
            advice = (
                f"write `<{problem.child}>{attribute.text}</{problem.child}>` in it"
                if attribute is not None
                else None
            )
            yield self.diagnostic(place, message, help=advice)
            return
        if problem.more:
            message += f", and {problem.more} more"
        if guess is None or element.attribute(guess) is not None:
            advice = "give it a prefix if it is your own"
            yield self.diagnostic(place, message, help=advice)
            return
        fix = replace(place, guess, f"rename it to `{guess}`", unsafe=True)
        yield self.diagnostic(place, message, meant=guess, fix=fix)

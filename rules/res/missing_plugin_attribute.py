from collections.abc import Iterator

from sdfcheck import (
    IN_MODEL,
    IN_ROBOT,
    REFUSES,
    Bad,
    Consumer,
    Diagnostic,
    Good,
    Rule,
    Severity,
    problems,
    warns,
)

OLDER = dict.fromkeys((Consumer.GAZEBO, Consumer.DRAKE), warns("older releases refuse the file"))


class MissingPluginAttribute(Rule):
    """A plugin has no `filename`, or in old versions no `name`.

    Without the name of the library there is nothing to load, and libsdformat stops
    reading the document. A `name` is required up to version 1.9; later readers do
    without, and only older ones refuse the file.
    """

    code = "RES008"
    name = "missing-plugin-attribute"
    severity = Severity.ERROR
    affects = {Consumer.GAZEBO: REFUSES, Consumer.DRAKE: {"sdf": REFUSES}}
    explains = (problems.MissingAttribute,)
    scaffold = IN_MODEL

    bad = (
        Bad('<«plugin» name="p"/>', says="plugin `p` has no `filename`"),
        Bad('<plugin name="p" «filename»=""/>', says="`filename` of plugin `p` is empty"),
        Bad('<gazebo><«plugin» name="p"/></gazebo>', scaffold=IN_ROBOT, says="plugin `p` has no `filename`"),
        Bad(
            '<«plugin» filename="libp.so"/>',
            scaffold=IN_MODEL.replace("1.12", "1.9"),
            says="up to version 1.9",
        ),
    )
    good = (
        Good('<plugin filename="libp.so"/>', why="a plugin needs no name since 1.10"),
        Good(
            '<plugin filename="libp.so" name="p"><plugin/></plugin>', why="the content of a plugin is its own"
        ),
    )

    def check(self, problem: problems.MissingAttribute) -> Iterator[Diagnostic]:
        element, name = problem.element, problem.attribute
        if element.name != "plugin":
            return
        message = (
            f"`{name}` of {element.title} is empty" if problem.empty else f"{element.title} has no `{name}`"
        )
        value = element.attribute(name)
        target = element.span if value is None else value.name_span
        severity, affects = Severity.ERROR, {}
        if problem.until is not None:
            message += f", required up to version {problem.until}"
            severity, affects = Severity.WARNING, OLDER
        yield self.diagnostic(target, message, severity=severity, affects=affects)

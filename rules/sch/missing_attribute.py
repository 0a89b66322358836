from collections.abc import Iterator

from sdfcheck import IN_LINK, IN_MODEL, Bad, Diagnostic, Good, Rule, Severity, problems


class MissingAttribute(Rule):
    """A required attribute is missing or empty.

    libsdformat stops reading at the first one: a joint without type, a link without name,
    a plugin without filename cost the whole document. An attribute that later versions
    no longer require is told as a warning, because only older readers refuse the file.
    """

    code = "SCH005"
    name = "missing-attribute"
    severity = Severity.ERROR
    explains = (problems.MissingAttribute,)
    scaffold = IN_LINK

    bad = (
        Bad('<«sensor» name="s"/>', says="sensor `s` has no `type`"),
        Bad('<sensor name="s" «type»=""/>', says="`type` of sensor `s` is empty"),
        Bad("<«link»/>", scaffold=IN_MODEL, says="`link` has no `name`"),
        Bad(
            '<«plugin» filename="libp.so"/>',
            scaffold=IN_MODEL.replace("1.12", "1.9"),
            says="required up to version 1.9",
        ),
    )
    good = (
        Good('<sensor name="s" type="imu"/>'),
        Good('<plugin filename="libp.so"/>', why="a plugin needs no name since 1.10", scaffold=IN_MODEL),
        Good(
            '<p:sensor xmlns:p="https://example.org/p"/>',
            why="a custom element has the attributes that it has",
        ),
    )

    def check(self, problem: problems.MissingAttribute) -> Iterator[Diagnostic]:
        element, name = problem.element, problem.attribute
        message = (
            f"`{name}` of {element.title} is empty" if problem.empty else f"{element.title} has no `{name}`"
        )
        value = element.attribute(name)
        target = element.span if value is None else value.name_span
        if problem.until is None:
            yield self.diagnostic(target, message)
            return
        message += f", required up to version {problem.until}"
        yield self.diagnostic(target, message, severity=Severity.WARNING)

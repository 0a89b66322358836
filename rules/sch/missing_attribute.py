from collections.abc import Iterator

from sdfcheck import (
    IN_LINK,
    IN_MODEL,
    IN_WORLD,
    Bad,
    Consumer,
    Diagnostic,
    Element,
    Good,
    Rule,
    Severity,
    is_harmless,
    lacking,
    problems,
    warns,
)


class MissingAttribute(Rule):
    """A required attribute is missing or empty.

    libsdformat stops reading at the first one: a joint without type or a link
    without name costs the whole document. An attribute that later versions
    no longer require is reported as a warning, because only older consumers refuse the file.
    """

    code = "SCH005"
    name = "missing-attribute"
    severity = Severity.ERROR
    remedy = """Write the attribute with the value that is meant.

    Names are free but unique among siblings; `sdfcheck describe joint/@type` and the like list the values
    of types. In a macro of xacro look at the property that it is made of.
    """
    explains = (problems.MissingAttribute,)
    scaffold = IN_LINK

    bad = (
        Bad('<«sensor» name="s"/>', says="sensor `s` has no `type`"),
        Bad('<sensor name="s" «type»=""/>', says="`type` of sensor `s` is empty"),
        Bad("<«link»/>", scaffold=IN_MODEL, says="`link` has no `name`"),
        Bad(
            '<sdf version="1.9"><world name="w"><model name="m"><link name="l"/></model>'
            '<state world_name="w"><model name="m">'
            '<«joint»><angle axis="0">1</angle></joint></model></state></world></sdf>',
            scaffold="",
            says="required up to version 1.11",
        ),
        Bad(
            '<include><uri>arm.sdf</uri><experimental:params><visual element_id="hand::v">'
            '<«plugin» action="add"/></visual></experimental:params></include>',
            scaffold=IN_WORLD.replace(
                "<sdf ", '<sdf xmlns:experimental="http://sdformat.org/schemas/experimental" '
            ),
            files={
                "arm.sdf": '<sdf version="1.12"><model name="arm"><link name="hand">'
                '<visual name="v"/></link></model></sdf>'
            },
            says="`plugin` has no `filename`",
        ),
    )
    good = (
        Good(
            '<visual><geometry><sphere radius="1"/></geometry>'
            '<material name="m"><color rgba="1 0 0 1"/><texture/></material></visual>',
            why="the color is taken",
            scaffold='<robot name="r"><link name="l">{}</link></robot>',
        ),
        Good('<sensor name="s" type="imu"/>'),
        Good('<plugin name="p"/>', why="missing-plugin-attribute owns this one"),
        Good(
            '<p:sensor xmlns:p="https://example.org/p"/>',
            why="a custom element has the attributes that it has",
        ),
    )

    def check(self, problem: problems.MissingAttribute) -> Iterator[Diagnostic]:
        element, name = problem.element, problem.attribute
        if element.name == "plugin" and not is_parameter(element):
            return  # missing-plugin-attribute looks at those that are there
        message = (
            f"`{name}` of {element.title} is empty" if problem.empty else f"{element.title} has no `{name}`"
        )
        value = element.attribute(name)
        target = element.span if value is None else value.name_span
        if problem.until is None:
            affects = dict(lacking(element, name))
            severity = Severity.WARNING if is_harmless(affects) else None
            yield self.diagnostic(target, message, affects=affects, severity=severity)
            return
        message += f", required up to version {problem.until}"
        affects = dict.fromkeys(Consumer, warns("older releases refuse the file"))
        yield self.diagnostic(target, message, severity=Severity.WARNING, affects=affects)


def is_parameter(element: Element) -> bool:
    """Is it something that the parameters of an include add?"""
    at: Element | None = element
    while at is not None and at.name != "experimental:params":
        at = at.parent
    return at is not None

from collections.abc import Iterator, Sequence

from sdfcheck import (
    IN_LINK,
    IN_MODEL,
    IN_URDF_LINK,
    IN_WORLD,
    Bad,
    Consumer,
    Diagnostic,
    Element,
    Fix,
    Good,
    Rule,
    Severity,
    is_harmless,
    lacking,
    problems,
    rewrite,
    used,
    warns,
)

BALL = '<geometry><sphere radius="1"/></geometry>'
MOMENTS = '<inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/>'

VALUES = frozenset(
    (
        ("axis", "xyz"),
        ("box", "size"),
        ("child", "link"),
        ("color", "rgba"),
        ("material", "name"),
        ("parent", "link"),
        ("sphere", "radius"),
    )
)
"""Elements of URDF, and the attribute that says all of them."""


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
        Bad(
            f"<visual>{BALL}<«material»/></visual><visual>{BALL}<material/></visual>",
            scaffold=IN_URDF_LINK,
            says="`material` (used 2 times) has no `name`",
        ),
        Bad("<«link»/>", scaffold=IN_MODEL, says="`link` has no `name`"),
        Bad(
            f"<inertial><«mass»>2</mass>{MOMENTS}</inertial>",
            fixed=f'<inertial><mass value="2"/>{MOMENTS}</inertial>',
            unsafe=True,
            scaffold=IN_URDF_LINK,
            says="`mass` has no `value`, only text",
        ),
        Bad(
            "<visual><geometry><cylinder><«radius»>1</radius><length>2</length></cylinder></geometry></visual>",
            fixed='<visual><geometry><cylinder radius="1" length="2"/></geometry></visual>',
            unsafe=True,
            scaffold=IN_URDF_LINK,
            says="`radius` and 1 more of `cylinder` are attributes, not elements",
        ),
        Bad(
            "<contact><«lateral_friction»>0.5</lateral_friction></contact>",
            fixed='<contact><lateral_friction value="0.5"/></contact>',
            unsafe=True,
            scaffold=IN_URDF_LINK,
            says="`lateral_friction` has no `value`, only text",
        ),
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
        Good(
            '<visual><geometry><sphere radius="1"/></geometry>'
            '<material name="m"><color rgba="1 0 0 1"/><texture filename=""/></material></visual>',
            why="a CAD program writes it so",
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
        title = element.title + used(1 + len(problem.others))
        message = f"`{name}` of {title} is empty" if problem.empty else f"{title} has no `{name}`"
        value, fix = element.attribute(name), None
        target = element.span if value is None else value.name_span
        if problem.elements:
            first, *others = problem.elements
            target, message = first.span, f"`{first.name}` of {element.title} is an attribute, not an element"
            if others:
                message = (
                    f"`{first.name}` and {len(others)} more of {element.title} are attributes, not elements"
                )
            fix = as_attributes(problem.elements, element)
        elif (
            (name == "value" or (element.name, name) in VALUES) and element.content and not element.attributes
        ):
            message += ", only text"
            fix = as_attributes((element,), element, name)
        if problem.until is None:
            affects = dict(lacking(element, name))
            severity = Severity.WARNING if is_harmless(affects) else None
            yield self.diagnostic(
                target,
                message,
                affects=affects,
                severity=severity,
                fix=fix,
                cause=problem.cause,
                repeats=problem.others,
            )
            return
        message += f", required up to version {problem.until}"
        affects = dict.fromkeys(Consumer, warns("older releases refuse the file"))
        cause = problem.cause
        yield self.diagnostic(target, message, severity=Severity.WARNING, affects=affects, cause=cause)


def is_parameter(element: Element) -> bool:
    """Is it something that the parameters of an include add?"""
    at: Element | None = element
    while at is not None and at.name != "experimental:params":
        at = at.parent
    return at is not None


def as_attributes(values: Sequence[Element], element: Element, name: str = "") -> Fix | None:
    """The fix that writes elements with text, which are all that an element has, as its attributes."""
    given = {name or value.name: value.content for value in values}
    is_simple = not any(value.attributes or any(value.children()) for value in values)
    rest = [child for child in element.children() if child not in values]
    if (
        element.attributes
        or rest
        or not is_simple
        or len(given) < len(values)
        or '"' in "".join(given.values())
    ):
        return None
    text = " ".join(f'{key}="{value}"' for key, value in given.items())
    return rewrite("write attributes", {element: f"<{element.name} {text}/>"})

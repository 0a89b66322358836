from collections.abc import Callable, Iterator, Mapping

from sdfcheck import (
    IN_COLLISION,
    IN_JOINT,
    IN_LINK,
    IN_URDF_LINK,
    Bad,
    Consumer,
    Diagnostic,
    Element,
    Fix,
    Good,
    Rule,
    Severity,
    is_harmless,
    problems,
    refuses,
    rewrite,
    suggest,
    unreadable,
    warns,
)

INERTIAL = (
    '<sdf version="1.12"><model name="m"><link name="base"><inertial>{}</inertial></link></model></sdf>'
)

WORDS = {
    "BLANK": "`{name}` has a tab or line break beside a number, or a space after the last one",
    "COMMA": "`{name}` should be {expected}, separated by spaces and not by commas",
    "EXPRESSION": "`{name}` holds an expression that nothing has expanded",
    "FRACTION": "`{name}` should be {expected}, and `{part}` is a fraction",
    "HEXADECIMAL": "`{name}` should be {expected}, and `{part}` is hexadecimal",
    "NOT_A_BOOLEAN": "`{name}` should be {expected}, not `{part}`",
    "NOT_FINITE": "`{name}` should be {expected}, and `{part}` is not finite",
    "TOO_LARGE": "`{part}` is too large for `{name}`",
    "TOO_SMALL": "`{part}` is too near to zero for `{name}`",
}
"""By the cause; other types hold numbers."""


TRUTHS = {**dict.fromkeys(("yes", "on", "y", "t"), "true"), **dict.fromkeys(("no", "off", "n", "f"), "false")}


def _truth(text: str, expected: str) -> str | None:
    return TRUTHS.get(text.lower()) or suggest(text, ("true", "false"))


def _apart(text: str, expected: str) -> str | None:
    """Numbers without their commas, if they are as many as are expected."""
    numbers = text.replace(",", " ").split()
    return " ".join(numbers) if expected == f"{len(numbers)} numbers" else None


def _nothing(text: str, expected: str) -> None:
    return None


MEANT: Mapping[str, Callable[[str, str], str | None]] = {"NOT_A_BOOLEAN": _truth, "COMMA": _apart}
"""Cause → what was probably meant by a text, of which so much is expected."""
MOMENTS = '<inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/>'


class MalformedValue(Rule):
    """A value is not of the type that its place asks for.

    libsdformat refuses the whole document for one such value, and says of it only that
    some element could not be read. Numbers have a decimal point and are separated by
    spaces; a truth value is true, false, 1 or 0. Where a value may be left out, an empty
    one is the default, and gets a warning.
    """

    code = "SCH011"
    name = "malformed-value"
    severity = Severity.ERROR
    remedy = """Write a value of this type, without its unit; `sdfcheck describe ELEMENT` shows type and unit.

    Numbers have a decimal point, no unit, and are separated by spaces. Truth values are `true`, `false`,
    `1` or `0`. Expressions of xacro need `sdfcheck expand` or xacro first, those of other templates their
    own program.
    """
    explains = (problems.MalformedValue,)
    scaffold = IN_LINK

    bad = (
        Bad(
            "<gravity>«yes»</gravity>",
            fixed="<gravity>true</gravity>",
            unsafe=True,
            says="`gravity` should be true or false, not `yes`; did you mean `true`?",
        ),
        Bad("<pose>0 0 «high» 0 0 0</pose>", says="`pose` should be 6 numbers, and `high` is not a number"),
        Bad("<pose>«0 0 ${z} 0 0 0»</pose>", says="`pose` holds an expression that nothing has expanded"),
        Bad(
            "<pose>«0,0,1,0,0,0»</pose>",
            fixed="<pose>0 0 1 0 0 0</pose>",
            unsafe=True,
            says="should be 6 numbers, separated by spaces and not by commas",
        ),
        Bad("<mass>«heavy»</mass>", scaffold=INERTIAL, says="`mass` should be a number, not `heavy`"),
        Bad("<mass>«1e400»</mass>", scaffold=INERTIAL, says="`1e400` is too large for `mass`"),
        Bad(
            '<pose degrees="«on»">0 0 0 0 0 0</pose>',
            fixed='<pose degrees="true">0 0 0 0 0 0</pose>',
            unsafe=True,
            says="`degrees` should be true or false",
        ),
        Bad("<geometry><mesh><«uri»/></mesh></geometry>", scaffold=IN_COLLISION, says="`uri` is empty"),
        Bad(
            "<axis><xyz>0 0 1</xyz><use_parent_model_frame>«maybe»</use_parent_model_frame></axis>",
            scaffold=IN_JOINT.replace("1.12", "1.6"),
            says="`use_parent_model_frame` should be true or false, not `maybe`",
        ),
        Bad("<«mass»></mass>", scaffold=INERTIAL, says="`mass` is empty, so 1.0 is taken"),
        Bad(
            '<«mass» value="2"/>',
            fixed="<mass>2</mass>",
            unsafe=True,
            scaffold=INERTIAL,
            says="`mass` is empty, and its attribute `value` is not read, so 1.0 is taken",
        ),
        Bad(
            f'<inertial><mass value="«heavy»"/>{MOMENTS}</inertial>',
            scaffold=IN_URDF_LINK,
            says="`value` should be a number, not `heavy`",
        ),
        Bad(
            '<robot name="r"><link name="a"/><gazebo reference="a"><kp>«true»</kp></gazebo></robot>',
            scaffold="{}",
            says="`kp` should be a number, not `true`",
        ),
    )
    good = (
        Good("<gravity>TRUE</gravity>", why="any case is read"),
        Good("<pose/>", why="an empty pose is the default"),
        Good(
            '<sdf version="1.12"><world name="w"><include><uri>arm</uri><static/></include></world></sdf>',
            why="unusable-include owns this one",
            scaffold="{}",
        ),
        Good("<mass>1.</mass>", scaffold=INERTIAL),
        Good(
            '<p:mass xmlns:p="https://example.org/p">heavy</p:mass>',
            why="custom elements hold what they like",
        ),
        Good(f'<inertial><mass value="2"/>{MOMENTS}</inertial>', scaffold=IN_URDF_LINK),
    )

    def check(self, problem: problems.MalformedValue) -> Iterator[Diagnostic]:
        value, reading, part = problem.value, problem.reading, problem.span.text
        name = value.attribute or value.element.name
        if reading.cause is None:
            yield from self.empty(problem)
            return
        if reading.cause.name in WORDS:
            message = WORDS[reading.cause.name].format(name=name, expected=reading.expected, part=part)
        elif part == value.text.strip():
            message = f"`{name}` should be {reading.expected}, not `{part}`"
        else:
            message = f"`{name}` should be {reading.expected}, and `{part}` is not a number"
        meant = MEANT.get(reading.cause.name, _nothing)(part, reading.expected)
        affects = (
            unreadable(value) if reading.refused else dict.fromkeys(Consumer, warns("takes the default"))
        )
        severity = Severity.WARNING if not reading.refused or is_harmless(affects) else None
        is_template = reading.cause.name == "EXPRESSION"
        advice = "expand the file first, with `sdfcheck expand` or the program that it is for"
        yield self.diagnostic(
            problem.span,
            message,
            meant=meant,
            help=advice if is_template else None,
            affects=affects,
            severity=severity,
            # In URDF the expression itself is the mistake.
            cause=problem.span if is_template else None,
        )

    def empty(self, problem: problems.MalformedValue) -> Iterator[Diagnostic]:
        """No value at all, for which a default is taken if the file is read."""
        message = f"`{problem.value.attribute or problem.value.element.name}` is empty"
        parent, fix = problem.value.element.parent, None
        if problem.attribute is not None:
            message += f", and its attribute `{problem.attribute}` is not read"
            fix = as_text(problem.value.element, problem.attribute)
        if parent is not None and parent.name == "include" and not problem.reading.refused:
            return
        if problem.reading.refused:
            yield self.diagnostic(problem.span, message, fix=fix, affects=unreadable(problem.value))
            return
        message += f", so {problem.definition.default} is taken"
        affects = dict.fromkeys(Consumer, warns("takes the default"))
        if problem.attribute is not None:
            affects[Consumer.DRAKE] = refuses("refuses unknown attributes")
        yield self.diagnostic(problem.span, message, fix=fix, severity=Severity.WARNING, affects=affects)


def as_text(element: Element, attribute: str) -> Fix | None:
    """The fix that writes the only attribute of an empty element as its text."""
    text = f"<{element.name}>{element.attributes[attribute]}</{element.name}>"
    return None if element.nodes else rewrite(f"write `{text}`", {element: text})

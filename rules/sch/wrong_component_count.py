from collections.abc import Iterator

from sdfcheck import (
    IN_COLLISION,
    IN_LINK,
    IN_URDF_LINK,
    IN_VISUAL,
    Bad,
    Consumer,
    Diagnostic,
    Good,
    Rule,
    Severity,
    ignores,
    problems,
    unreadable,
)


class WrongComponentCount(Rule):
    """A pose, vector, color or time has too few or too many numbers.

    Too few are refused, and so are too many in a pose or color. A vector with more
    numbers than it needs is accepted, without the last ones: that gets a warning.
    A pose has six numbers, or seven with `rotation_format="quat_xyzw"`.
    """

    code = "SCH013"
    name = "wrong-component-count"
    severity = Severity.ERROR
    remedy = """Write as many numbers as the type has, separated by spaces.

    A pose has six: `x y z roll pitch yaw`; a vector three, a color three or four, a time two (seconds and
    nanoseconds). A pose that is only moved ends in `0 0 0`.
    """
    explains = (problems.WrongComponentCount,)
    scaffold = IN_LINK

    bad = (
        Bad("<pose>«0 0 1»</pose>", says="`pose` has 3 numbers and needs 6"),
        Bad('<pose rotation_format="quat_xyzw">«0 0 1 0 0 0»</pose>', says="has 6 numbers and needs 7"),
        Bad("<pose>0 0 1 0 0 0 «1»</pose>", says="has 7 numbers and needs 6"),
        Bad(
            "<geometry><box><size>1 1 1 «1»</size></box></geometry>",
            scaffold=IN_COLLISION,
            says="`size` has 4 numbers and needs 3, so the rest is ignored",
        ),
        Bad(
            "<geometry><sphere><radius>1</radius></sphere></geometry>"
            "<material><ambient>«1 0»</ambient></material>",
            scaffold=IN_VISUAL,
            says="`ambient` has 2 numbers and needs 3 or 4",
        ),
        Bad(
            '<visual><origin xyz="«0 0»"/><geometry><box size="1 1 1"/></geometry></visual>',
            scaffold=IN_URDF_LINK,
            says="has 2 numbers and needs 3",
        ),
    )
    good = (
        Good("<pose>\n  0 0 1\n  0 0 0\n</pose>", why="any spaces separate numbers"),
        Good('<pose rotation_format="quat_xyzw">0 0 1 0 0 0 1</pose>'),
        Good(
            '<visual><origin xyz="0 0 0"/><geometry><box size="1 1 1"/></geometry></visual>',
            scaffold=IN_URDF_LINK,
        ),
    )

    def check(self, problem: problems.WrongComponentCount) -> Iterator[Diagnostic]:
        name = problem.value.attribute or problem.value.element.name
        reading = problem.reading
        numbers = "1 number" if reading.got == 1 else f"{reading.got} numbers"
        message = f"`{name}` has {numbers} and needs {' or '.join(map(str, reading.wanted))}"
        if reading.refused:
            yield self.diagnostic(problem.span, message, affects=unreadable(problem.value))
            return
        message += ", so the rest is ignored"
        affects = dict.fromkeys(Consumer, ignores("the rest"))
        yield self.diagnostic(problem.span, message, severity=Severity.WARNING, affects=affects)

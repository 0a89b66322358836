from collections.abc import Iterator

from sdfcheck import (
    IN_COLLISION,
    IN_WORLD,
    Bad,
    Consumer,
    Diagnostic,
    Geometry,
    Good,
    Light,
    Rule,
    Severity,
    Value,
    warns,
)

PLANE = "<geometry><plane><normal>{}</normal><size>1 1</size></plane></geometry>"


class ZeroDirection(Rule):
    """The normal of a plane or the direction of a light has no length.

    `0 0 0` points nowhere: what simulators make of it is up to their mathematics.
    """

    code = "SCH022"
    name = "zero-direction"
    severity = Severity.WARNING
    affects = {Consumer.GAZEBO: warns("takes another direction, or none")}
    looks_at = (Geometry, Light)
    scaffold = IN_COLLISION

    bad = (
        Bad(PLANE.format("«0 0 0»"), says="`normal` has no length"),
        Bad(
            '<light name="sun" type="directional"><direction>«0 0 0.0»</direction></light>',
            scaffold=IN_WORLD,
            says="`direction` has no length",
        ),
    )
    good = (
        Good(PLANE.format("0 0 5"), why="of any length"),
        Good(
            '<light name="lamp" type="point"><direction>0 0 0</direction></light>',
            scaffold=IN_WORLD,
            why="shines everywhere",
        ),
    )

    @staticmethod
    def applies(part: Geometry | Light) -> bool:
        if part.kind == "light":
            return part.has("direction") and zero_direction(part) is not None
        return part.has("plane") and zero_direction(part) is not None

    def check(self, part: Geometry | Light) -> Iterator[Diagnostic]:
        value = zero_direction(part)
        assert value is not None
        yield self.diagnostic(value, f"`{value.element.name}` has no length")


def zero_direction(part: Geometry | Light) -> Value | None:
    """The direction, if it is written as zero."""
    holder = part.find("plane") if part.kind == "geometry" else part.element
    if holder is None or (isinstance(part, Light) and part.type == "point"):
        return None
    child = holder.find("normal" if part.kind == "geometry" else "direction")
    if child is None:
        return None
    words = child.content.split()
    is_zero = len(words) == 3 and all(word.strip("0.+-") == "" and "0" in word for word in words)
    return child.own_value if is_zero else None

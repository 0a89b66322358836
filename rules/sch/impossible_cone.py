import math
from collections.abc import Iterator

from sdfcheck import IN_WORLD, Bad, Diagnostic, Good, Light, Rule, Severity

LIGHT = (
    '<light name="l" type="{}"><spot><inner_angle>{}</inner_angle><outer_angle>{}</outer_angle>'
    "<falloff>1</falloff></spot><direction>0 0 -1</direction></light>"
)


class ImpossibleCone(Rule):
    """A spot light has a bright inner cone that is wider than the whole, or a cone of more than a turn.

    The light is full within `inner_angle` and fades out until `outer_angle`, both in radians.
    Angles above 2π were most likely meant in degrees.
    """

    code = "SCH021"
    name = "impossible-cone"
    severity = Severity.WARNING
    remedy = """Write both angles in radians, and the inner one not wider than the outer one.

    60° is 1.0472 rad. The light fades between the two; `falloff` says how.
    """
    looks_at = (Light,)
    scaffold = IN_WORLD

    bad = (
        Bad(
            LIGHT.format("spot", "«0.9»", "0.5"),
            says="the inner cone of 0.9 rad is wider than the outer one of 0.5 rad",
        ),
        Bad(
            LIGHT.format("spot", "5", "«10.1»"),
            says="a cone of 10.1 rad is more than a turn; 10.1 degrees are 0.17628 rad",
        ),
    )
    good = (
        Good(LIGHT.format("spot", "0.5", "0.5"), why="no fading"),
        Good(LIGHT.format("point", "0.5", "0"), why="shines everywhere"),
    )

    @staticmethod
    def applies(light: Light) -> bool:
        return light.has("spot") and light.type == "spot" and bool(wrong_angle(light))

    def check(self, light: Light) -> Iterator[Diagnostic]:
        spot = light.find("spot")
        name = wrong_angle(light)
        element = None if spot is None else spot.find(name)
        if element is None:
            return
        value = element.own_value
        angle = value.number
        if angle > 2 * math.pi:
            meant = f"{angle:.6g} degrees are {math.radians(angle):.5g} rad"
            yield self.diagnostic(value, f"a cone of {angle:.6g} rad is more than a turn; {meant}")
            return
        whole = angle_of(light, "outer_angle")
        message = f"the inner cone of {angle:.6g} rad is wider than the outer one of {whole:.6g} rad"
        yield self.diagnostic(value, message)


def wrong_angle(light: Light) -> str:
    """The angle that cannot be meant: `inner_angle`, `outer_angle`, or empty."""
    inner, outer = angle_of(light, "inner_angle"), angle_of(light, "outer_angle")
    if outer > 2 * math.pi:
        return "outer_angle"
    return "inner_angle" if inner > outer else ""


def angle_of(light: Light, name: str) -> float:
    """One of its angles (rad); nan where it is not written, or no number."""
    spot = light.find("spot")
    written = None if spot is None else spot.find(name)
    return math.nan if written is None else written.own_value.number

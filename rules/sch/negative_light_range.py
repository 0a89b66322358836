from collections.abc import Iterator

from sdfcheck import IN_WORLD, Bad, Diagnostic, Good, Light, Number, Rule, Severity

LIGHT = '<light name="l" type="point"><attenuation><range>{}</range><constant>0.5</constant></attenuation></light>'


class NegativeLightRange(Rule):
    """The range of a light is negative.

    It is the distance up to which the light is seen (m). With a negative one nothing is lit.
    """

    code = "SCH024"
    name = "negative-light-range"
    severity = Severity.WARNING
    remedy = """Write how far the light reaches, in meters: a positive number.

    Together with `constant`, `linear` and `quadratic` it is the attenuation of a point or spot light. 10 to
    20 m suits a room.
    """
    looks_at = (Light,)
    scaffold = IN_WORLD

    bad = (Bad(LIGHT.format("«-20»"), says="range -20 of light `l` is negative"),)
    good = (Good(LIGHT.format("20")),)

    @staticmethod
    def applies(light: Light) -> bool:
        return light.has("attenuation") and reach(light).number < 0

    def check(self, light: Light) -> Iterator[Diagnostic]:
        distance = reach(light)
        yield self.diagnostic(distance, f"range {distance.text} of {light.title} is negative")


def reach(light: Light) -> Number:
    """How far it shines (m)."""
    attenuation = light.find("attenuation")
    value = None if attenuation is None else attenuation.value("range")
    return Number.of(value, light.element, 10.0)

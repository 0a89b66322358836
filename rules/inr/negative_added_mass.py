from collections.abc import Iterator

from sdfcheck import IN_LINK, Bad, Diagnostic, Good, Inertial, Rule, Severity, Value

DIAGONAL = ("xx", "yy", "zz", "pp", "qq", "rr")
WATER = (
    "<inertial><mass>5</mass><inertia><ixx>1</ixx><iyy>1</iyy><izz>1</izz></inertia>"
    "<fluid_added_mass><xx>{}</xx><xy>-1</xy><yy>2</yy></fluid_added_mass></inertial>"
)


class NegativeAddedMass(Rule):
    """The mass that a fluid adds along an axis is negative.

    The fluid that a body moves along adds to its mass. A negative number reduces the mass, and
    where the sum is negative, forces push the body the wrong way. Papers on underwater vehicles
    write the derivatives `Xudot`, `Yvdot` …, which are negative: their signs have to be
    changed.
    """

    code = "INR012"
    name = "negative-added-mass"
    severity = Severity.WARNING
    remedy = """Change the sign of the added mass: the diagonal is positive.

    `xx` is `-Xudot`, `yy` is `-Yvdot`, `zz` is `-Zwdot`, `pp` is `-Kpdot` and so on, of the hydrodynamic
    derivatives that papers print. For a sphere the added mass is half of that of the water that it
    displaces.
    """
    preview = True
    looks_at = (Inertial,)
    scaffold = IN_LINK

    bad = (Bad(WATER.format("«-3»"), says="the added mass `xx` of link `base` is negative: -3"),)
    good = (Good(WATER.format("3"), why="terms that couple two axes have either sign"),)

    @staticmethod
    def applies(inertial: Inertial) -> bool:
        return not inertial.is_unremarkable and inertial.has("fluid_added_mass") and any(negative(inertial))

    def check(self, inertial: Inertial) -> Iterator[Diagnostic]:
        for value in negative(inertial):
            what = f"the added mass `{value.element.name}` of {inertial.link.title}"
            yield self.diagnostic(value, f"{what} is negative: {value.text.strip()}")


def negative(inertial: Inertial) -> Iterator[Value]:
    """The negative ones on the diagonal."""
    added = inertial.find("fluid_added_mass")
    for name in () if added is None else DIAGONAL:
        value = added.value(name) if added is not None else None
        if value is not None and value.number < 0:
            yield value

from collections.abc import Iterator, Sequence
from math import cos, sin

from sdfcheck import (
    IN_URDF_LINK,
    Bad,
    Diagnostic,
    Good,
    Inertial,
    Model,
    Number,
    Rule,
    Severity,
    TextEdit,
    make_fix,
)
from sdfcheck_rules.inr.exchanged_moments import is_turned
from sdfcheck_rules.inr.moments import is_weighed, is_written

LEAST = 0.1
"""Of the smallest moment: smaller products turn the axes of a body by little."""
LIKE = 1.35
"""Moments within this factor of those of the shapes are of the same body."""
FITS, CONTRARY = 0.3, 1.5
"""How far products are off those of the shapes, of the largest one: once turned, and as they are."""
NAMES = ("ixy", "ixz", "iyz")
SHOWN = 3
"""So many of the other links are marked."""


def beam(sign: float) -> str:
    """A beam that is turned by half a radian about z, and its moments."""
    turn, along, across = 0.5, 0.005, 0.065
    own = [cos(turn) ** 2 * along + sin(turn) ** 2 * across, sin(turn) ** 2 * along + cos(turn) ** 2 * across]
    product = sign * cos(turn) * sin(turn) * (along - across)
    return (
        f'<inertial><mass value="3"/><inertia ixx="{own[0]:.4g}" ixy="{product:.4g}" ixz="0" iyy="{own[1]:.4g}"'
        f' iyz="0" izz="{across:.4g}"/></inertial><visual><origin rpy="0 0 {turn}"/><geometry>'
        '<box size="0.5 0.1 0.1"/></geometry></visual>'
    )


class MirroredProducts(Rule):
    """The products of inertia of a link have the sign of the other convention.

    With it turned around they are those of the link's shapes, filled evenly, and so are the moments. CAD programs give
    the products as `∫ x y dm`, and URDF and SDFormat want `ixy = -∫ x y dm`: the body turns about axes that are mirror
    images of its own. So does a part whose moments are copied from its mirror image.
    """

    code = "INR022"
    name = "mirrored-products"
    severity = Severity.WARNING
    remedy = """Turn the signs of `ixy`, `ixz` and `iyz` around, in all links that the finding counts.

    Of a CAD program that has a choice, take the notation in which the products are negative integrals.
    """
    looks_at = (Model,)
    selects = ("urdf:robot",)
    scaffold = IN_URDF_LINK

    bad = (
        Bad(
            beam(-1).replace('ixy="', 'ixy="«').replace('" ixz', '»" ixz'),
            fixed=beam(1),
            unsafe=True,
            says="the products of inertia are those of the shapes of link `base` with the other sign",
        ),
    )
    good = (Good(beam(1)), Good(beam(0), why="left out"))

    @staticmethod
    def applies(robot: Model) -> bool:
        return next(mirrored(robot), None) is not None

    def check(self, robot: Model) -> Iterator[Diagnostic]:
        first, *others = mirrored(robot)
        place, *rest = products(first)
        message = f"the products of inertia are those of the shapes of {first.link.title} with the other sign"
        if others:
            message += f"; the same holds for {len(others)} more link{'s' * (len(others) > 1)}"
        values = [value for each in (first, *others) for value in products(each)]
        edits = tuple(TextEdit(value.span, negative(value.text.strip())) for value in values)
        yield self.diagnostic(
            place,
            message,
            labels=dict.fromkeys(rest, "this too")
            | {each.moments_element: "the same" for each in others[:SHOWN]},
            fix=make_fix("turn the signs around", edits, unsafe=True),
        )


def mirrored(robot: Model) -> Iterator[Inertial]:
    """The inertials whose products have the other sign: one program wrote them all."""
    for link in robot.links if robot.is_urdf else ():
        if is_lopsided(link.inertial.tensor) and is_written(link.inertial) and is_mirrored(link.inertial):
            yield link.inertial


def products(inertial: Inertial) -> list[Number]:
    """Its products of inertia that are not 0."""
    return [inertial.moments[name] for name in NAMES if inertial.moments[name].number != 0]


def is_lopsided(moments: Sequence[float]) -> bool:
    """Are its products large enough to say something?"""
    return 0 < LEAST * min(moments[:3]) <= max(map(abs, moments[3:]))


def is_mirrored(inertial: Inertial) -> bool:
    """Are the moments those of the shapes, and the products with the other sign?"""
    if not is_weighed(inertial) or is_turned(inertial):
        return False
    filled = inertial.link.filled
    if filled is None or not is_lopsided(filled):
        return False
    given, shaped = inertial.tensor, [inertial.mass.number * moment for moment in filled]
    if not all(1 / LIKE < one / other < LIKE for one, other in zip(given[:3], shaped[:3], strict=True)):
        return False
    pairs = list(zip(given[3:], shaped[3:], strict=True))
    largest = max(map(abs, shaped[3:]))
    turned, written = (max(abs(one + way * other) for one, other in pairs) for way in (1, -1))
    return turned < FITS * largest and written > CONTRARY * largest


def negative(number: str) -> str:
    """A number as text with the other sign."""
    return number[1:] if number.startswith("-") else f"-{number.removeprefix('+')}"

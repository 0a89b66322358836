from collections.abc import Iterator
from math import nan

from sdfcheck import IN_LINK, IN_URDF_LINK, Bad, Diagnostic, Good, Inertial, Part, Rule, Severity
from sdfcheck_rules.inr.moments import is_doubtful, is_weighed

EVEN = 0.005
"""Moments that are off by one factor differ by less in it."""
LONG = 1.1
"""A body whose moments differ by less is nearly round, and any moments fit it."""
LIKE, FAR = 1.25, 50.0
"""Factors within the first are a choice; beyond the second other rules speak."""
TWICE = 4.0
"""The factor of a shape of twice the size, which is a mistake, or a choice, of another kind."""
WRIST = (
    '<inertial><mass value="0.426"/><inertia ixx="{}" ixy="0" ixz="0" iyy="{}" iyz="0" izz="{}"/></inertial>'
    '<collision><geometry><cylinder radius="0.04" length="0.14"/></geometry></collision>'
)


class MomentsOfAnotherMass(Rule):
    """The moments of inertia of a link are exactly those of its shape with another mass.

    All three are those of a solid of the link's only shape, but for one factor: they were computed from a mass that is
    not the one of the link. Often a macro for the inertia is given a number of its own, which was not changed
    with the mass.
    """

    code = "INR021"
    name = "moments-of-another-mass"
    severity = Severity.WARNING
    remedy = """Compute the moments with the mass of the link, or write the mass that they are for.

    In xacro give the macro of the inertia the same property that `<mass value="…"/>` has.
    """
    looks_at = (Inertial,)
    scaffold = IN_URDF_LINK

    bad = (
        Bad(
            WRIST.format("«0.00036295»", "0.00036295", "0.0001428"),
            says="the moments are those of 0.1785 kg in the shape of link `base`, and its mass is 0.426",
        ),
    )
    good = (
        Good(WRIST.format("0.0008662", "0.0008662", "0.0003408")),
        Good(WRIST.format("0.00036295", "0.00036295", "0.0002"), why="of another shape"),
        Good(WRIST.format("0.0034648", "0.0034648", "0.0013632"), why="of twice the size"),
        Good(
            "<inertial><inertia><ixx>0.00036295</ixx><iyy>0.00036295</iyy><izz>0.0001428</izz></inertia></inertial>"
            '<collision name="c"><geometry><cylinder><radius>0.04</radius><length>0.14</length></cylinder></geometry>'
            "</collision>",
            why="missing-element says that there is no mass",
            scaffold=IN_LINK,
        ),
    )

    @staticmethod
    def applies(inertial: Inertial) -> bool:
        return inertial.mass.is_given and is_doubtful(inertial) and factor(inertial) > 0

    def check(self, inertial: Inertial) -> Iterator[Diagnostic]:
        mass = inertial.mass
        message = (
            f"the moments are those of {factor(inertial) * mass.number:.4g} kg in the shape of"
            f" {inertial.link.title}, and its mass is {mass.text}"
        )
        labels = {mass: "the mass", inertial.link.solids[0]: "the shape"}
        yield self.diagnostic(inertial.moments["ixx"], message, labels=labels)


def factor(inertial: Inertial) -> float:
    """The one factor between its moments and those of the link's only solid with its mass; nan if that says nothing."""
    moments = inertial.tensor if is_weighed(inertial) else ()
    if not moments or not min(moments[:3]) > 0 or not max(moments[:3]) * (1 + EVEN) > LONG * min(moments[:3]):
        return nan
    if max(map(abs, moments[3:])) > EVEN * min(moments[:3]):
        return nan
    solids = inertial.link.solids
    solid = solids[0].geometry.solid if len(solids) == 1 else None
    given = [inertial.moments[name] for name in ("ixx", "iyy", "izz")]
    if solid is None or not all(moment.is_given for moment in given) or not turned_alike(inertial):
        return nan
    usual = [inertial.mass.number * moment for moment in solid.moments[:3]]
    if not min(usual) > 0 or max(usual) < LONG * min(usual):
        return nan
    factors = [one / other for one, other in zip(moments[:3], usual, strict=True)]
    found = sum(factors) / 3
    is_one = max(factors) < (1 + EVEN) * min(factors)
    is_off = LIKE < found < FAR or 1 / FAR < found < 1 / LIKE
    is_sized = any(abs(found / size - 1) < EVEN for size in (TWICE, 1 / TWICE))
    return found if is_one and is_off and not is_sized else nan


def turned_alike(inertial: Inertial) -> bool:
    """Has the inertial the rotation of the link's first solid?"""
    own, other = (rotation(part) for part in (inertial, inertial.link.solids[0]))
    return own is not None and own == other


def rotation(part: Part) -> list[float] | None:
    """The rotation that its own pose writes, as numbers; None where it is written in another way."""
    place = part.find("origin" if part.is_urdf else "pose")
    if place is None:
        return [0.0, 0.0, 0.0]
    words = (place.text_of("rpy") or "0 0 0").split() if part.is_urdf else place.content.split()[3:]
    if place.text_of("quat_xyzw") is not None or place.attributes.keys() & {"rotation_format", "degrees"}:
        return None
    try:
        return [float(word) for word in words] or [0.0, 0.0, 0.0]
    except ValueError:
        return None

from collections.abc import Iterator
from math import inf, sqrt

from sdfcheck import IN_LINK, IN_URDF_LINK, Bad, Diagnostic, Good, Inertial, Rule, Severity

LEAST = 1e-6
"""kg: less counts as none, for which there are rules."""
MOST = 20.0
"""m: no link of a robot is that large."""


class OversizedInertia(Rule):
    """The inertia of a link without shapes is that of a body of more than twenty meters.

    The root of the greatest moment by the mass is a length, the radius of gyration: that of a body is
    always less than its size. Moments in kg·mm² or g·cm² are too large by a million and more.
    Links with shapes are compared with those.
    """

    code = "INR010"
    name = "oversized-inertia"
    severity = Severity.WARNING
    remedy = """Convert the moments to kg·m²: 1 kg·mm² is 1e-6, 1 g·cm² is 1e-7, 1 g·mm² is 1e-9.

    Set the unit system to SI (m, kg) in the CAD program before the export. As a check, √(I/m) is the radius
    of gyration in meters: it has to be less than the size of the part.
    """
    preview = True
    looks_at = (Inertial,)
    scaffold = IN_LINK

    bad = (
        Bad(
            "<inertial><mass>1</mass><«inertia»><ixx>900</ixx><iyy>900</iyy><izz>900</izz></inertia></inertial>",
            says="moments of 900 kg·m² for 1 kg need a body of more than 30 m",
        ),
        Bad(
            '<inertial><mass value="0.1"/><«inertia» ixx="50" ixy="0" ixz="0" iyy="50" iyz="0" izz="50"/></inertial>',
            scaffold=IN_URDF_LINK,
        ),
    )
    good = (
        Good(
            "<inertial><mass>1e5</mass><inertia><ixx>1e6</ixx><iyy>1e6</iyy><izz>1e6</izz></inertia></inertial>"
        ),
        Good(
            "<inertial><mass>1</mass><inertia><ixx>inf</ixx><iyy>inf</iyy><izz>1</izz></inertia></inertial>",
            why="out-of-range owns this one",
        ),
    )

    @staticmethod
    def applies(inertial: Inertial) -> bool:
        if inertial.is_unremarkable or inertial.inertia is None:
            return False
        if not inertial.is_given or not LEAST < inertial.mass.number < inf:
            return False
        largest = max(inertial.tensor[:3])
        if not MOST * MOST * inertial.mass < largest < inf:
            return False
        return not inertial.link.shapes and not inertial.link.may_be_static

    def check(self, inertial: Inertial) -> Iterator[Diagnostic]:
        largest, mass = max(inertial.tensor[:3]), float(inertial.mass)
        size = sqrt(largest / mass)
        yield self.diagnostic(
            inertial.moments_element,
            f"moments of {largest:.6g} kg·m² for {mass:.6g} kg need a body of more than {size:.3g} m",
        )

from collections.abc import Iterator

from sdfcheck import IN_LINK, Bad, Diagnostic, Element, Good, Inertial, Part, Rule, Severity
from sdfcheck_rules.inr.center_outside_link import MOST
from sdfcheck_rules.inr.excess_density import is_too_dense
from sdfcheck_rules.inr.moments import MARK, is_far_off, is_first, is_unit, others, ratio
from sdfcheck_rules.inr.places import outside
from sdfcheck_rules.inr.ratios import times

NOTHING = 1e-6
"""kg: so little is meant as none, beside moments that are meant."""


class ImplausibleInertia(Rule):
    """An inertia is off by more than a hundredfold from a solid of the link's mass and shapes.

    Hollow or weighted bodies differ by a small factor from solid ones; a factor of a hundred
    is usually a unit (mm for m, g for kg) or another link's numbers. Of meshes the boxes around them
    count, where their files are there.
    """

    code = "INR006"
    name = "implausible-inertia"
    severity = Severity.WARNING
    remedy = """Check the units of the moments (kg·m²) and compute them again for the mass and the shapes.

    1 kg·mm² is 1e-6 kg·m², 1 g·cm² is 1e-7, 1 g·mm² is 1e-9. MeshLab prints volume × length², in the unit
    of the file: multiply it by mass / volume, and for millimeters by 1e-6. If the link was copied, its
    inertia is still that of the other one. `sdfcheck inertia FILE` shows them side by side.
    """
    looks_at = (Inertial,)
    scaffold = IN_LINK

    bad = (
        Bad(
            "<inertial><mass>2</mass><«inertia»><ixx>2</ixx><iyy>2</iyy><izz>2</izz></inertia></inertial>"
            '<collision name="c"><geometry><sphere><radius>0.05</radius></sphere></geometry></collision>',
            says="1000 times",
        ),
    )
    good = (
        Good(
            "<inertial><mass>2</mass><inertia><ixx>0.004</ixx><iyy>0.004</iyy><izz>0.004</izz></inertia></inertial>"
            '<collision name="c"><geometry><sphere><radius>0.05</radius></sphere></geometry></collision>',
            why="twice a solid ball: a hollow one",
        ),
        Good(
            "<inertial><mass>0.001</mass><inertia><ixx>1e-12</ixx><iyy>1e-12</iyy><izz>1e-12</izz></inertia></inertial>"
            '<collision name="c"><geometry><sphere><radius>0.05</radius></sphere></geometry></collision>',
            why="1 g marks a place",
        ),
        Good(
            "<inertial><mass>900</mass><inertia><ixx>0.0009</ixx><iyy>0.0009</iyy><izz>0.0009</izz></inertia></inertial>"
            '<collision name="c"><geometry><sphere><radius>0.05</radius></sphere></geometry></collision>',
            why="it is the mass that is wrong",
        ),
        Good(
            "<inertial><pose>0 0 1 0 0 0</pose><mass>2</mass><inertia><ixx>0.004</ixx><iyy>0.004</iyy><izz>0.004</izz>"
            '</inertia></inertial><collision name="c"><geometry><sphere><radius>0.05</radius></sphere></geometry>'
            "</collision>",
            why="center-outside-link reports the place of the mass",
        ),
        Good(
            "<inertial><mass>1e-10</mass><inertia><ixx>1e-5</ixx><iyy>1e-5</iyy><izz>1e-5</izz></inertia></inertial>"
            '<collision name="c"><geometry><sphere><radius>0.05</radius></sphere></geometry></collision>',
            why="its mass is that of another link",
        ),
        Good(
            "<inertial><mass>2</mass><inertia><ixx>2</ixx><iyy>2</iyy><izz>2</izz></inertia></inertial>"
            '<collision name="c"><geometry><mesh><uri>https://example.org/a.dae</uri></mesh></geometry></collision>',
            why="a mesh that is not on this computer may be of any size",
        ),
    )

    @staticmethod
    def applies(inertial: Inertial) -> bool:
        return is_first(inertial, is_implausible)

    def check(self, inertial: Inertial) -> Iterator[Diagnostic]:
        message = f"the inertia is {times(ratio(inertial))} that of a solid of this mass in the link's shapes"
        more, same = others(inertial, is_implausible)
        compared = (inertial.link.solids or inertial.link.shapes)[0]
        labels: dict[Part | Element, str] = {inertial.link: "this link", compared: "compared with this shape"}
        yield self.diagnostic(inertial.moments_element, message + more, labels={**labels, **same})


def is_implausible(inertial: Inertial) -> bool:
    if not is_far_off(inertial) or inertial.inertia is None or is_unit(inertial):
        return False
    if ratio(inertial) > 1:
        return inertial.mass.number > NOTHING
    # else the mass or its place may be wrong, which other rules say
    return inertial.mass.number > MARK and not is_too_dense(inertial) and not outside(inertial) > MOST

from collections.abc import Iterator
from math import hypot

from sdfcheck import IN_LINK, IN_URDF_LINK, Bad, Diagnostic, Good, Inertial, Rule, Severity

MOST = 10.0
"""m"""
MASS = "<mass>1</mass><inertia><ixx>1</ixx><iyy>1</iyy><izz>1</izz></inertia>"


class DistantCenterOfMass(Rule):
    """The center of mass of a link is more than ten meters from its origin.

    Lengths are in meters: a part that was drawn in millimeters has such numbers, and would
    drag its joint around by a lever as long as a house. Links with shapes are compared with those.
    """

    code = "INR011"
    name = "distant-center-of-mass"
    severity = Severity.WARNING
    remedy = """Write the center of mass in meters and in the frame of the link.

    Divide by 1000 what a CAD program gave in millimeters. If the number is in meters, it was likely
    measured from the origin of the whole assembly: subtract the position of the link, or export the part in
    its own coordinate system.
    """
    looks_at = (Inertial,)
    scaffold = IN_LINK

    bad = (
        Bad(
            f"<inertial><pose>«0 35.2 12 0 0 0»</pose>{MASS}</inertial>",
            says="the center of mass is 37.2 m from the origin of link `base`",
        ),
        Bad(
            '<inertial><origin xyz="«0 0 -120»"/><mass value="1"/>'
            '<inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial>',
            scaffold=IN_URDF_LINK,
        ),
    )
    good = (Good(f"<inertial><pose>0 2 1 0 0 0</pose>{MASS}</inertial>"),)

    @staticmethod
    def applies(inertial: Inertial) -> bool:
        if inertial.is_unremarkable or not (inertial.has("pose") or inertial.has("origin")):
            return False
        return distance(inertial) > MOST and not inertial.link.may_be_static and inertial.link.extent is None

    def check(self, inertial: Inertial) -> Iterator[Diagnostic]:
        message = f"the center of mass is {distance(inertial):.3g} m from the origin of {inertial.link.title}"
        origin = inertial.find("origin" if inertial.is_urdf else "pose")
        value = None if origin is None else origin.attribute("xyz") or origin.own_value
        yield self.diagnostic(value or inertial, message)


def distance(inertial: Inertial) -> float:
    """How far its center of mass is from the origin of the link (m)."""
    return hypot(*(inertial.center or (0.0, 0.0, 0.0)))

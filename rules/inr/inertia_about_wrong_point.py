import math
from collections.abc import Iterator

from sdfcheck import IN_LINK, Bad, Diagnostic, Good, Inertial, Rule, Severity
from sdfcheck_rules.inr.moments import is_about_origin, ratio


class InertiaAboutWrongPoint(Rule):
    """An inertia fits the link's shapes only if it is about the link's origin.

    SDFormat and URDF want the moments about the center of mass, in the frame of the
    inertial's own pose. CAD programs offer both; with the wrong one the link is far too
    slow to turn.
    """

    code = "INR007"
    name = "inertia-about-wrong-point"
    severity = Severity.WARNING
    remedy = """Write the moments about the center of mass instead of the origin of the link.

    Most CAD programs print both: take the block "at the center of mass" (`Lxx` in SolidWorks, not `Ixx`).
    To convert, subtract what the parallel axes add: `ixx - m (y² + z²)`, `ixy + m x y` and so on, with the
    center of mass x y z in the frame of the link.
    """
    looks_at = (Inertial,)
    scaffold = IN_LINK

    bad = (
        Bad(
            "<inertial><pose>0 0 0.5 0 0 0</pose><mass>1</mass>"
            "<«inertia»><ixx>0.2517</ixx><iyy>0.2517</iyy><izz>0.0017</izz></inertia></inertial>"
            '<collision name="c"><pose>0 0 0.5 0 0 0</pose><geometry><box><size>0.1 0.1 0.1</size></box></geometry>'
            "</collision>",
            says="0.5 m away",
        ),
        Bad(
            "<inertial><pose>0 0 0.5 0 0 0</pose><mass>1</mass>"
            "<«inertia»><ixx>0.33356</ixx><iyy>0.33356</iyy><izz>0.00045</izz></inertia></inertial>"
            '<collision name="c"><pose>0 0 0.5 0 0 0</pose><geometry><cylinder><radius>0.03</radius><length>1</length>'
            "</cylinder></geometry></collision>",
            says="it is 4.0 times that of a solid",
        ),
    )
    good = (
        Good(
            "<inertial><pose>0 0 0.5 0 0 0</pose><mass>1</mass>"
            "<inertia><ixx>0.1</ixx><iyy>0.1</iyy><izz>0.001</izz></inertia></inertial>"
            '<collision name="c"><pose>0 0 0.5 0 0 0</pose><geometry><cylinder><radius>0.03</radius><length>1</length>'
            "</cylinder></geometry></collision>",
            why="a rod about its middle, and a little more",
        ),
        Good(
            "<inertial><pose>0 0 0.5 0 0 0</pose><mass>1</mass>"
            "<inertia><ixx>0.0017</ixx><iyy>0.0017</iyy><izz>0.0017</izz></inertia></inertial>"
            '<collision name="c"><pose>0 0 0.5 0 0 0</pose><geometry><box><size>0.1 0.1 0.1</size></box></geometry>'
            "</collision>",
            why="about the center of mass",
        ),
        Good(
            "<inertial><pose>0 0 0.2 0 0 0</pose><mass>250</mass>"
            "<inertia><ixx>12</ixx><iyy>12</iyy><izz>12</izz></inertia></inertial>"
            '<collision name="c"><pose>0 0 0.2 0 0 0</pose><geometry><box><size>0.3 0.55 0.05</size></box></geometry>'
            "</collision>",
            why="a number for all three axes",
        ),
    )

    @staticmethod
    def applies(inertial: Inertial) -> bool:
        return is_about_origin(inertial)

    def check(self, inertial: Inertial) -> Iterator[Diagnostic]:
        offset = math.hypot(*inertial.center or ())
        message = (
            f"the inertia seems to be about the link's origin, {offset:.3g} m away from the center of mass: "
            f"it is {ratio(inertial):.1f} times that of a solid"
        )
        yield self.diagnostic(inertial.moments_element, message, labels={inertial.link: "this link"})

from collections.abc import Iterator
from math import dist

from sdfcheck import IN_LINK, IN_URDF_LINK, Bad, Diagnostic, Good, Inertial, Rule, Severity
from sdfcheck_rules.inr.places import is_off_origin, outside

MOST = 0.7
"""By the greatest length of the link's shapes: of 4,088 links in public robots 40 are a length outside, and nearly
all of them because no place is written."""
TURNED, NEAR = 0.2, 0.1
"""The same where the center is not farther than this from the middle of the shapes once one sign is turned."""
MASS = "<mass>1</mass><inertia><ixx>0.01</ixx><iyy>0.01</iyy><izz>0.01</izz></inertia>"
BOX = '<collision name="c"><geometry><box><size>0.2 0.1 0.1</size></box></geometry></collision>'
URDF_BOX = '<collision><geometry><box size="0.2 0.1 0.1"/></geometry></collision>'


class CenterOutsideLink(Rule):
    """The center of mass of a link is outside of its shapes, by most of their size.

    The mass of a body is within its bounds. Where the shapes are at one place and the mass at another, the
    link hangs on a lever that nobody sees: joints need more effort than the machine, and robots tip over. A fifth of
    the size is enough where the center would be in the middle of the shapes if one coordinate had the other sign.
    Meshes count with the bounds of their files; a link with a shape of unknown size is not judged.
    """

    code = "INR013"
    name = "center-outside-link"
    severity = Severity.WARNING
    remedy = """Move the center of mass into the shapes, in the frame of the link and in meters.

    CAD programs print it in the frame of the assembly unless another coordinate system is chosen: subtract
    the position of the link, and mind its rotation. If the mass is right, the shapes are displaced: compare
    both with `sdfcheck view FILE`. A counterweight without a shape is a good reason to keep it; say so in a
    comment that ignores this.
    """
    looks_at = (Inertial,)
    scaffold = IN_LINK

    bad = (
        Bad(
            f"<inertial><pose>«0.5 0 0 0 0 0»</pose>{MASS}</inertial>{BOX}",
            says="the center of mass is 0.4 m outside of the shapes of link `base`, which are 0.2 m long",
        ),
        Bad(
            '<inertial><origin xyz="«0 0 -1»"/><mass value="1"/>'
            '<inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/></inertial>' + URDF_BOX,
            scaffold=IN_URDF_LINK,
        ),
        Bad(
            f"<inertial><pose>«-0.1 0 0 0 0 0»</pose>{MASS}</inertial>{BOX}".replace(
                '"c">', '"c"><pose>0.1 0 0 0 0 0</pose>'
            ),
            says="which are 0.2 m long, and would be in the middle of them if x were 0.1",
        ),
    )
    good = (
        Good(f"<inertial><pose>0.15 0 0 0 0 0</pose>{MASS}</inertial>{BOX}", why="shapes are simplified"),
        Good(
            f"<inertial><pose>5 0 0 0 0 0</pose>{MASS}</inertial>"
            '<collision name="c"><geometry><mesh><uri>https://example.org/a.dae</uri></mesh></geometry></collision>',
            why="the size of the mesh is not known",
        ),
        Good(
            f"<inertial><pose>0.5 0 0 0 0 0</pose>{MASS}</inertial>{BOX}"
            '<visual name="v"><geometry><mesh><uri>https://example.org/a.dae</uri></mesh></geometry></visual>',
            why="the visual may reach farther than the collision",
        ),
        Good(
            f"<inertial><pose>0.5 0 0 0 0 0</pose>{MASS}</inertial>{BOX}".replace("<mass>1<", "<mass>0.001<"),
            why="1 g marks a place",
        ),
    )

    @staticmethod
    def applies(inertial: Inertial) -> bool:
        far = outside(inertial)
        return (far > MOST or (far > TURNED and turned(inertial) is not None)) and not is_off_origin(inertial)

    def check(self, inertial: Inertial) -> Iterator[Diagnostic]:
        box = inertial.link.fixed_extent
        assert box is not None, "it was compared"
        size = max(box.size)
        origin = inertial.find("origin" if inertial.is_urdf else "pose")
        value = None if origin is None else origin.attribute("xyz") or origin.own_value
        message = f"the center of mass is {outside(inertial) * size:.3g} m outside of the shapes of"
        message += f" {inertial.link.title}, which are {size:.3g} m long"
        sign = turned(inertial)
        if sign is not None:
            message += f", and would be in the middle of them if {sign[0]} were {sign[1]:.3g}"
        yield self.diagnostic(
            value or inertial, message, labels={inertial.link.shapes[0]: "the first of its shapes"}
        )


def turned(inertial: Inertial) -> tuple[str, float] | None:
    """The coordinate of the center that has the wrong sign by the shapes of the link alone, and what it would be."""
    center, box = inertial.center, inertial.link.extent
    if center is None or box is None:
        return None
    for axis, name in enumerate("xyz"):
        other = [-at if axis == number else at for number, at in enumerate(center)]
        if dist(other, box.center) < NEAR * max(box.size):
            return name, other[axis]
    return None

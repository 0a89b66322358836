from collections.abc import Iterator

from sdfcheck import IN_LINK, IN_URDF_LINK, Bad, Diagnostic, Good, Inertial, Rule, Severity
from sdfcheck_rules.inr.moments import is_first, others
from sdfcheck_rules.inr.places import is_off_origin, place_of

MASS = "<mass>1</mass><inertia><ixx>0.01</ixx><iyy>0.01</iyy><izz>0.01</izz></inertia>"
URDF_MASS = '<mass value="1"/><inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/>'
BOX = (
    '<collision name="c"><pose>0.1 0 0 0 0 0</pose><geometry><box><size>0.2 0.1 0.1</size></box></geometry>'
    "</collision>"
)
URDF_BOX = '<collision><origin xyz="0 0 0.15"/><geometry><box size="0.02 0.02 0.3"/></geometry></collision>'


class CenterAtOrigin(Rule):
    """The center of mass of a link is at its origin, and its shapes are elsewhere.

    The origin is the place of the joint, often at the end of the part: with its mass there it balances where it
    should hang. `<pose>` (SDFormat) or `<origin>` (URDF) of the inertial says where the center of mass is, and is
    zero where it is left out. Of ten such links of public robots that were read, all were mistakes.
    """

    code = "INR014"
    name = "center-at-origin"
    severity = Severity.WARNING
    remedy = """Write where the center of mass is: the middle of the shapes, if nothing better is known.

    In SDFormat it is the `<pose>` of the `<inertial>`, in URDF its `<origin xyz="…"/>`, in meters from the
    origin of the link. The moments stay as they are if they were computed about the center of mass; those
    about the origin of the link have to be converted (`sdfcheck rule inertia-about-wrong-point`).
    """
    looks_at = (Inertial,)
    scaffold = IN_LINK

    bad = (
        Bad(
            f"<«inertial»>{MASS}</inertial>{BOX}",
            says="the center of mass is at the origin of link `base`, as no pose is written,"
            " and the middle of its shapes at 0.1 0 0",
        ),
        Bad(
            f"<«inertial»>{URDF_MASS}</inertial>{URDF_BOX}",
            scaffold=IN_URDF_LINK,
            says="as no origin is written",
        ),
    )
    good = (
        Good(f"<inertial><pose>0.02 0 0 0 0 0</pose>{MASS}</inertial>{BOX}", why="another place is written"),
        Good(
            f"<inertial>{MASS}</inertial>"
            '<collision name="c"><pose>0.05 0 0 0 0 0</pose><geometry><box><size>0.2 0.1 0.1</size></box></geometry>'
            "</collision>",
            why="near the middle",
        ),
        Good(
            f"<inertial>{MASS}</inertial>"
            '<collision name="c"><pose>0.02 0 0 0 0 0</pose><geometry><box><size>0.02 0.3 0.3</size></box></geometry>'
            "</collision>",
            why="at the hub of a flat part",
        ),
    )

    @staticmethod
    def applies(inertial: Inertial) -> bool:
        return is_first(inertial, is_off_origin)

    def check(self, inertial: Inertial) -> Iterator[Diagnostic]:
        box = inertial.link.extent
        assert box is not None, "it was compared"
        middle = " ".join(f"{round(at, 4) + 0.0:g}" for at in box.center)
        what = "origin" if inertial.is_urdf else "pose"
        place = place_of(inertial)
        why = "" if place is not None else f", as no {what} is written,"
        more, same = others(inertial, is_off_origin)
        yield self.diagnostic(
            place or inertial,
            f"the center of mass is at the origin of {inertial.link.title}{why}"
            f" and the middle of its shapes at {middle}{more}",
            labels={inertial.link.shapes[0]: "the first of its shapes", **same},
        )

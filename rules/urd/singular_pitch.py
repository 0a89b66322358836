import math
from collections.abc import Iterator

from sdfcheck import IN_URDF_LINK, Bad, Diagnostic, Good, Placement, Rule, Severity

VISUAL = '<visual><origin rpy="{}"/><geometry><sphere radius="1"/></geometry></visual>'

POLE = 0.99999
"""Where the sine of the pitch is beyond this, urdfdom takes the angle for a right one."""
NOTABLE = 1e-4
"""An error in radians that is worth a report: 1.5708 is right, 1.57 is not."""


class SingularPitch(Rule):
    """The pitch of a shape is so near to 90° that urdfdom takes it for 90°.

    Where the sine of the pitch is beyond 0.99999, its conversion back to angles gives
    exactly a right angle. libsdformat writes the poses of visuals and collisions with it,
    so they turn by up to 4.5 milliradians; other consumers take the angle as written.
    """

    code = "URD016"
    name = "singular-pitch"
    severity = Severity.INFO
    remedy = """Write the right angle with more digits, `1.5707963`, or turn the shape in another way.

    In xacro `${pi/2}` has all the digits. If the small difference is meant, put it into the roll or yaw of
    a frame above, or into the mesh.
    """
    looks_at = (Placement,)
    selects = ("urdf:visual/origin", "urdf:collision/origin")
    scaffold = IN_URDF_LINK

    bad = (
        Bad(VISUAL.replace("{}", "0 «1.57» 0"), says="pitch 1.57 is taken for 90°, which is off by 0.8 mrad"),
        Bad(VISUAL.replace("{}", "0.3 «-1.573» 0.5"), says="off by 2.2 mrad"),
    )
    good = (
        Good(VISUAL.replace("{}", "0 1.5708 0"), why="off by less than anybody sees"),
        Good(VISUAL.replace("{}", "0 1.56 0"), why="far enough away"),
        Good(VISUAL.replace("{}", "1.57 0 1.57"), why="only the pitch is singular"),
    )

    @staticmethod
    def applies(origin: Placement) -> bool:
        return not origin.is_quaternion and error(origin) > NOTABLE

    def check(self, origin: Placement) -> Iterator[Diagnostic]:
        value = origin.rotation.value
        if value is not None:
            pitch = value.part(1)
            message = f"pitch {pitch.text} is taken for 90°, which is off by {error(origin) * 1000:.1f} mrad"
            yield self.diagnostic(pitch, message)


def error(origin: Placement) -> float:
    """How far the pitch is from 90°, in radians, if urdfdom takes it for that; else 0."""
    rotation = origin.rotation
    if len(rotation) != 3 or not math.isfinite(rotation[1]):
        return 0.0
    sine = abs(math.sin(rotation[1]))
    return math.pi / 2 - math.asin(min(sine, 1.0)) if sine >= POLE else 0.0

from collections.abc import Iterator
from math import dist

from sdfcheck import Bad, Diagnostic, Good, Inertial, Link, Rule, Severity
from sdfcheck_rules.inr.moments import is_written
from sdfcheck_rules.inr.places import place_of

SAME, LEAST, NEAR = 1e-6, 0.002, 0.05
"""m: centers that are equal, and one that is off the middle plane; of the size, shapes that are mirror images."""
HIP = (
    '<link name="{0}_hip"><inertial><origin xyz="{1}"/><mass value="2"/>'
    '<inertia ixx="0.01" iyy="0.01" izz="0.01" ixy="0" ixz="0" iyz="0"/></inertial><collision>'
    '<origin xyz="0 {2} -0.1"/><geometry><box size="0.1 0.12 0.2"/></geometry></collision></link>'
    '<joint name="{0}_hip_joint" type="revolute"><origin xyz="0 {3} 0"/><parent link="world"/><child link="{0}_hip"/>'
    '<axis xyz="0 0 1"/><limit lower="-1" upper="1" effort="9" velocity="1"/></joint>'
)


class CopiedCenter(Rule):
    """The center of mass of a part on the left is that of its counterpart on the right, not the mirror image.

    Their shapes are mirror images, and in one of them the center of mass is on the side where the other one extends.
    The robot leans, and gaits and efforts differ from side to side. Exporters and people copy one side, and
    turn the sign of the joint and of the shapes.
    """

    code = "INR020"
    name = "copied-center"
    severity = Severity.WARNING
    remedy = """Write the center of mass of the other side with the sign of its y turned.

    Turn the signs of `ixy` and `iyz` with it.
    """
    looks_at = (Inertial,)
    selects = ("urdf:robot/link/inertial",)
    scaffold = '<robot name="r"><link name="world"/>{}</robot>'

    bad = (
        Bad(
            HIP.format("left", "«0 -0.03 -0.1»", 0.03, 0.1)
            + HIP.format("right", "0 -0.03 -0.1", -0.03, -0.1),
            says="the center of mass of link `left_hip` is that of `right_hip`, whose shapes are its mirror image",
        ),
    )
    good = (
        Good(HIP.format("left", "0 0.03 -0.1", 0.03, 0.1) + HIP.format("right", "0 -0.03 -0.1", -0.03, -0.1)),
        Good(
            HIP.format("left", "0 0.03 -0.1", 0.03, 0.1) + HIP.format("right", "0 0.03 -0.1", 0.03, -0.1),
            why="the same part on both sides",
        ),
    )

    @staticmethod
    def applies(inertial: Inertial) -> bool:
        return twin_of(inertial) is not None

    def check(self, inertial: Inertial) -> Iterator[Diagnostic]:
        twin = twin_of(inertial)
        assert twin is not None
        message = f"the center of mass of {inertial.link.title} is that of `{twin.name}`"
        message += ", whose shapes are its mirror image"
        yield self.diagnostic(place_of(inertial) or inertial, message, labels={twin: "its counterpart"})


def twin_of(inertial: Inertial) -> Link | None:
    """The mirror image of its link that has the same center of mass, where it is on the wrong side of this one."""
    center = inertial.center
    if center is None or not any(abs(at) > LEAST for at in center[:2]) or not is_written(inertial):
        return None
    link = inertial.link
    joint = next(iter(link.parent_joints), None)
    mirror = joint.mirror if joint is not None else None
    twin = mirror.child_link if mirror is not None else None
    other = twin.inertial.center if twin is not None else None
    if (
        twin is None
        or other is None
        or dist(center, other) > SAME
        or twin.extent is None
        or link.extent is None
    ):
        return None
    own, its = link.extent, twin.extent
    near = NEAR * max(own.size)
    if dist(own.size, its.size) > near:
        return None
    for across in (0, 1):
        image = [-at if axis == across else at for axis, at in enumerate(its.center)]
        is_beyond = center[across] * own.center[across] < 0 and abs(center[across]) > LEAST
        if is_beyond and abs(own.center[across]) > near and dist(own.center, image) < near:
            return twin
    return None

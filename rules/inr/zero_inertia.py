from collections.abc import Iterator

from sdfcheck import (
    IN_LINK,
    REFUSES,
    Bad,
    Consumer,
    Diagnostic,
    Good,
    Inertial,
    Joint,
    Rule,
    Severity,
    accepts,
)
from sdfcheck_rules.inr.moments import has_moments, joints_to_world

ZERO = "<ixx>0</ixx><iyy>0</iyy><izz>0</izz><ixy>0</ixy><ixz>0</ixz><iyz>0</iyz>"
INERTIA = '<{} ixx="0" iyy="0" izz="0" ixy="0" ixz="0" iyz="0"/>'
ROBOT = f'<robot name="r"><link name="a"><inertial><mass value="1"/>{INERTIA}</inertial></link>{{}}</robot>'
CHILD = '<link name="b"/><joint name="j" type="continuous"><parent link="a"/><child link="b"/></joint>'
PART = '<joint name="j" type="fixed"><parent link="body"/><child link="a"/></joint>'


MOVED = (
    '<robot name="r"><link name="a"><inertial><mass value="1"/>'
    '<inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial></link><link name="b">{}</link>'
    '<joint name="j" type="continuous"><parent link="a"/><child link="b"/></joint></robot>'
)
BODY = (
    f'<inertial><mass value="1"/>{INERTIA.format("«inertia»")}</inertial>'
    '<collision><geometry><box size="1 1 1"/></geometry></collision>'
)
HINGED = (
    '<sdf version="1.12"><model name="m"><link name="door">'
    f"<inertial><mass>1</mass><«inertia»>{ZERO}</inertia></inertial>"
    '<collision name="c"><geometry><sphere><radius>0.1</radius></sphere></geometry></collision></link>'
    '<joint name="hinge" type="revolute"><parent>world</parent><child>door</child>'
    "<axis><xyz>0 0 1</xyz></axis></joint></model></sdf>"
)


class ZeroInertia(Rule):
    """A body has mass, and moments of inertia that are all 0.

    Nothing resists when it is turned. Where it floats alone, Drake loads it and cannot simulate it: the mass
    matrix is not positive definite. On a joint that moves MuJoCo refuses it. A point mass without a shape may be
    meant there, for what it is tied to resists; a link with a shape is a body.
    """

    code = "INR009"
    name = "zero-inertia"
    severity = Severity.WARNING
    remedy = """Write the moments of inertia that the mass has in the link's shapes.

    For a compact body of size d they are about m d² / 6 to m d² / 10; `sdfcheck rule missing-inertial` has
    the formulas. Numbers that look like 0 may have been rounded by the exporter: let it write nine
    decimals. A tiny placeholder such as 1e-9 makes simulations unstable where a heavy link hangs on it.
    """
    looks_at = (Inertial,)
    scaffold = IN_LINK

    bad = (
        Bad(
            f"<inertial><mass>1</mass><«inertia»>{ZERO}</inertia></inertial>",
            says="link `base` has a mass of 1 kg and moments of 0",
        ),
        Bad(ROBOT.format("«inertia»", ""), scaffold="", says="moments of 0"),
        Bad(MOVED.format(BODY), scaffold="", says="link `b` has a mass of 1 kg and moments of 0"),
        Bad(HINGED, scaffold="", says="link `door` has a mass of 1 kg and moments of 0"),
    )
    good = (
        Good("<inertial><mass>1</mass></inertial>", why="the moments are 1 where they are not written"),
        Good(ROBOT.format("inertia", CHILD), scaffold="", why="a point mass on a joint"),
        Good(ROBOT.format("inertia", PART), scaffold="", why="its parent is elsewhere", file="part.xacro"),
    )

    @staticmethod
    def applies(inertial: Inertial) -> bool:
        if (
            inertial.link.may_be_static
            or not has_moments(inertial)
            or inertial.inertia is None
            or any(inertial.tensor)
        ):
            return False
        if not (inertial.mass.is_given and inertial.mass.number > 0):
            return False
        link = inertial.link
        holding = link.parent_joints or joints_to_world(link)
        if holding:
            return bool(link.shapes) and holding[0].moves
        # In a part or a macro the other end of a joint is where nobody can see it.
        return not link.child_joints and not any(
            joint.child_link is link or link.name in {joint.parent_name, joint.child_name}
            for joint in inertial.root.each(Joint)
        )

    def check(self, inertial: Inertial) -> Iterator[Diagnostic]:
        link, mass = inertial.link, inertial.mass
        message = f"{link.title} has a mass of {mass.text.strip()} kg and moments of 0"
        affects = {
            Consumer.DRAKE: accepts("takes it for a point mass"),
            Consumer.MUJOCO: REFUSES,
        }
        if not link.parent_joints:
            affects = {Consumer.MUJOCO: accepts("makes it part of the world")}
        yield self.diagnostic(inertial.moments_element, message, labels={link: "this link"}, affects=affects)

from collections.abc import Iterator

from sdfcheck import IN_MODEL, Bad, Diagnostic, Good, Link, Rule, Severity
from sdfcheck_rules.inr.moments import joints_to_world

LEG = (
    '<link name="body"><inertial><mass>2</mass></inertial></link>{}<link name="leg"><inertial><mass>1</mass>'
    '</inertial></link><joint name="yaw" type="ball"><parent>body</parent><child>hip</child></joint>'
    '<joint name="pitch" type="ball"><parent>hip</parent><child>leg</child></joint>'
)


class MissingInertial(Rule):
    """A link that moves has a shape and no `<inertial>`, or is between joints that move.

    libsdformat gives it 1 kg and moments of 1 kg·m² each, whatever its size; Drake takes the
    same. A cup of that inertia turns like a barrel, and an auxiliary link between two joints weighs
    what it is thought not to.
    """

    code = "INR004"
    name = "missing-inertial"
    severity = Severity.WARNING
    remedy = """Give the link an `<inertial>` with its mass, center of mass and moments of inertia.

    Mass is in kg, the center of mass in meters in the frame of the link, moments in kg·m² about the center
    of mass. Ways to get them:

    - CAD programs print them as mass properties: choose SI units, the axes of the link, and the moments at
      the center of mass; check the sign of the products.
    - For a box of x × y × z `ixx = m/12 · (y² + z²)` and so on; for a cylinder along z `izz = m r²/2`,
      `ixx = iyy = m/12 · (3 r² + h²)`; for a sphere `2/5 · m r²`.
    - MeshLab (Compute Geometric Measures) prints volume, center of mass and tensor of a closed mesh for a
      density of 1: multiply the tensor by mass / volume, and scale a mesh in millimeters to meters first.
    - In SDFormat 1.11 `<inertial auto="true"/>` and a `<density>` let the simulator compute them from the
      collisions; `sdfcheck print --expand-auto-inertials FILE` writes the numbers.

    `sdfcheck inertia FILE` shows the result for each link and for the whole robot. A part that never moves
    is better made static.
    """
    looks_at = (Link,)
    scaffold = IN_MODEL

    bad = (
        Bad(
            '<«link» name="cup"><collision name="c"><geometry><sphere><radius>0.05</radius></sphere></geometry>'
            "</collision></link>",
            says="`cup`",
            also=("FRM012",),
        ),
        Bad(
            LEG.format("<«link» name='hip'/>"),
            says="link `hip` between two joints has no inertial: simulators take 1 kg and unit inertia",
        ),
    )
    good = (
        Good('<link name="mark"/>', why="no shape: nothing to weigh"),
        Good(
            LEG.format("<link name='hip'/>").replace("ball", "fixed", 1),
            why="a place on the link that carries it",
        ),
        Good(
            '<sdf version="1.12"><model name="wall"><static>true</static><link name="l"><collision name="c">'
            "<geometry><box><size>1 1 1</size></box></geometry></collision></link></model></sdf>",
            why="a static model does not move",
            scaffold="",
        ),
    )

    @staticmethod
    def applies(link: Link) -> bool:
        if link.has("inertial") or link.is_urdf or link.may_be_static:
            return False  # In URDF what a link without inertial means depends on its joint.
        return has_shape(link) or is_between_joints(link)

    def check(self, link: Link) -> Iterator[Diagnostic]:
        where = "" if has_shape(link) else " between two joints"
        message = f"link `{link.name}`{where} has no inertial: simulators take 1 kg and unit inertia"
        yield self.diagnostic(link, message, cause=link.misnamed("inertial"))


def has_shape(link: Link) -> bool:
    return link.has("collision") or link.has("visual")


def is_between_joints(link: Link) -> bool:
    """Does a joint move it, and another one what hangs on it?"""
    if not any(joint.moves for joint in link.child_joints):
        return False
    holding = link.parent_joints or joints_to_world(link)
    return any(joint.moves for joint in holding)

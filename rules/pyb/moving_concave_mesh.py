from collections.abc import Iterator

from sdfcheck import Bad, Diagnostic, Element, Good, Link, Rule, Severity

BODY = '<inertial><mass value="{}"/><inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial>'
ROBOT = (
    f'<robot name="r"><link name="base">{BODY}<collision{{}}><geometry><mesh filename="a.obj"/></geometry></collision>'
    "</link></robot>"
)

MOST_FIXED = 100
"""So many fixed joints, one above the other, are followed."""
FILES = {"a.obj": "v 1 1 1\nv 1 -1 -1\nv -1 1 -1\nv -1 -1 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n"}


class MovingConcaveMesh(Rule):
    """A link that moves has a collision with `concave`, which touches no plane and no other such mesh in PyBullet.

    With this attribute, whatever its value, Bullet takes the triangles of the mesh instead of its hull. Triangles meet
    solid shapes and hulls alone: the link falls through `plane.urdf`, and two parts with such meshes through each
    other. They are for what stands still, as links without mass and robots with `useFixedBase` do.
    """

    code = "PYB003"
    name = "moving-concave-mesh"
    severity = Severity.WARNING
    remedy = """Remove the attribute, and give the link several convex collisions that make up its shape.

    `pybullet.vhacd` cuts a mesh into convex parts; an OBJ file with several objects is one hull each.
    """
    default = False
    looks_at = (Link,)
    selects = ("urdf:robot/link",)
    needs = ("concave=",)
    scaffold = "{}"
    sources = (
        "https://github.com/bulletphysics/bullet3/blob/master/examples/Importers/ImportURDFDemo/UrdfParser.cpp",
    )

    bad = (
        Bad(
            ROBOT.format(2, ' «concave»="yes"'),
            files=FILES,
            says="the mesh of link `base` touches neither planes nor other meshes in PyBullet, and the link moves",
        ),
    )
    good = (
        Good(ROBOT.format(0, ' concave="yes"'), files=FILES, why="it stands still"),
        Good(ROBOT.format(2, ""), files=FILES),
    )

    @staticmethod
    def applies(link: Link) -> bool:
        return any(concave(link)) and floats(link)

    def check(self, link: Link) -> Iterator[Diagnostic]:
        message = f"the mesh of {link.title} touches neither planes nor other meshes in PyBullet, and the link moves"
        for element in concave(link):
            value = element.attribute("concave")
            yield self.diagnostic(element if value is None else value.name_span, message)
            return


def concave(link: Link) -> Iterator[Element]:
    """Its collisions whose meshes are to stay as they are."""
    for shape in link.collisions:
        if shape.geometry.shape == "mesh" and "concave" in shape.element.attributes:
            yield shape.element


def floats(link: Link) -> bool:
    """Does it, or what it hangs on, move?"""
    at = link
    for _ in range(MOST_FIXED):
        if not at.parent_joints:
            return at.name != "world" and not (at.has("inertial") and at.inertial.mass.number == 0)
        joint = at.parent_joints[0]
        if not joint.is_fixed or joint.parent_link is None:
            return not joint.is_fixed
        at = joint.parent_link
    return False

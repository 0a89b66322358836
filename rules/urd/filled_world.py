from collections.abc import Iterator

from sdfcheck import IN_ROBOT, Bad, Diagnostic, Element, Good, Link, Rule, Severity

PARTS = ("visual", "collision")
MASS = '<inertial><mass value="1"/><inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial>'
WORLD = (
    '<link name="{}">{}</link><joint name="fix" type="fixed"><parent link="{}"/><child link="base"/></joint>'
)
TABLE = '<«visual»><geometry><box size="1 1 1"/></geometry></«visual»>'


class FilledWorld(Rule):
    """The link `world` has shapes.

    To Gazebo `world` is the world itself: what hangs on it is tied to the ground, and what the link holds is
    left out. RViz shows it, the simulator does not.
    """

    code = "URD029"
    name = "filled-world"
    severity = Severity.WARNING
    remedy = """Move the shapes to a link of their own that is fixed to `world`.

    ```xml
    <link name="world"/>
    <link name="table">…</link>
    <joint name="table_joint" type="fixed"><parent link="world"/><child link="table"/></joint>
    ```
    """
    looks_at = (Link,)
    selects = ("urdf:robot/link",)
    scaffold = IN_ROBOT

    bad = (
        Bad(
            WORLD.format("world", TABLE.replace("</«visual»>", "</visual>"), "world"),
            says="`visual` of link `world` is not in Gazebo, to which that link is the world",
        ),
    )
    good = (
        Good(WORLD.format("world", MASS, "world"), why="its mass moves nothing"),
        Good(WORLD.format("table", TABLE.replace("«", "").replace("»", "") + MASS, "table")),
    )

    @staticmethod
    def applies(link: Link) -> bool:
        return link.name == "world" and any(held(link))

    def check(self, link: Link) -> Iterator[Diagnostic]:
        first = next(held(link))
        yield self.diagnostic(
            first, f"`{first.name}` of {link.title} is not in Gazebo, to which that link is the world"
        )


def held(link: Link) -> Iterator[Element]:
    """The shapes of the link, which Gazebo leaves out."""
    return (child for child in link.children() if child.name in PARTS)

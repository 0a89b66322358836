from collections.abc import Iterator

from sdfcheck import Bad, Diagnostic, Good, Link, Rule, Severity

MASS = '<inertial><mass value="{}"/><inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial>'
SHAPE = '<collision><geometry><box size="1 1 1"/></geometry></collision>'
ARM = (
    f'<robot name="r"><link name="a">{MASS.format(1)}</link>{{}}'
    '<joint name="j" type="continuous"><parent link="a"/><child link="b"/></joint>'
    '<joint name="k" type="fixed"><parent link="b"/><child link="c"/></joint></robot>'
)


class ShapesWithoutMass(Rule):
    """A link that moves has shapes and no mass, and only links fixed to it have some.

    Consumers that merge fixed links take the mass of the others for the whole: the arm weighs what its tip does.
    Where no link that is fixed to it has a mass, another rule
    reports that.
    """

    code = "INR017"
    name = "shapes-without-mass"
    severity = Severity.WARNING
    remedy = """Give the link an `<inertial>` of its own, with the mass of its own shapes.

    The links that are fixed to it keep theirs: consumers add them up. If the one inertial was measured for
    the whole, move it to the link that moves, and remove it from the fixed one.
    `sdfcheck rule missing-inertial` says how to get the numbers.
    """
    looks_at = (Link,)
    selects = ("urdf:robot/link",)
    scaffold = ARM

    bad = (
        Bad(
            f'<«link» name="b">{SHAPE}</link><link name="c">{SHAPE}{MASS.format(1)}</link>',
            says="link `b` moves and has shapes, but no inertial; link `c`, which is fixed to it, has 1 kg",
        ),
    )
    good = (
        Good(f'<link name="b"/><link name="c">{SHAPE}{MASS.format(1)}</link>', why="a frame"),
        Good(
            f'<link name="b">{SHAPE}</link><link name="c">{MASS.format(1)}</link>',
            why="the second link is there for its inertia",
        ),
        Good(
            f'<link name="b">{SHAPE}</link>'
            f'<link name="c">{SHAPE.replace("collision", "visual")}{MASS.format(1)}</link>',
            why="the second link is there for its inertia, and shows where",
        ),
    )

    @staticmethod
    def applies(link: Link) -> bool:
        return weight(link) is not None

    def check(self, link: Link) -> Iterator[Diagnostic]:
        other = weight(link)
        if other is None:
            return
        yield self.diagnostic(
            link,
            f"{link.title} moves and has shapes, but no inertial; {other.title}, which is fixed to it,"
            f" has {other.inertial.mass.text} kg",
            labels={other: "fixed to it"},
            cause=link.misnamed("inertial"),
        )


def weight(link: Link) -> Link | None:
    """The first link fixed to one that moves without mass that has some."""
    if link.has("inertial") or not link.has("collision"):
        return None
    if not any(joint.moves for joint in link.parent_joints):
        return None
    tied = [joint.child_link for joint in link.child_joints if joint.is_fixed]
    weighed = [other for other in tied if other is not None and other.has_mass]
    return weighed[0] if weighed and all(other.has("collision") for other in weighed) else None

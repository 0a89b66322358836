from collections.abc import Iterator

from sdfcheck import Bad, Consumer, Diagnostic, Good, Link, Rule, Severity

NOTHING = '<inertial><mass value="0"/><inertia ixx="0" ixy="0" ixz="0" iyy="0" iyz="0" izz="0"/></inertial>'
MASS = '<inertial><mass value="2"/><inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial>'
RIG = (
    '<robot name="r"><link name="base">{}</link><link name="holder">{}</link><link name="table">{}</link>'
    '<joint name="{}" type="fixed"><parent link="base"/><child link="holder"/></joint>'
    '<joint name="m" type="fixed"><parent link="base"/><child link="table"/></joint></robot>'
)


class MergedWithoutMass(Rule):
    """Two links are merged before either has mass, and then one with mass joins them.

    libsdformat merges the links of fixed joints one after the other, in the order of the joints'
    names, and divides by the mass of both for their center. Without mass that is 0/0: the center
    of the whole is not a number, and Gazebo refuses the robot.
    """

    code = "URD027"
    name = "merged-without-mass"
    severity = Severity.ERROR
    remedy = """Leave the `<inertial>` without mass out, or give it the mass of the part.

    A link without `<inertial>` is merged without a division, so a mere frame needs none. Where the part has
    mass, weigh it or take its volume × density; `sdfcheck rule missing-inertial` says how to get the
    moments.
    """
    looks_at = (Link,)
    selects = ("urdf:robot/link",)
    needs = ("<mass",)
    scaffold = "{}"

    bad = (
        Bad(
            RIG.format(NOTHING, NOTHING.replace("0", "«0»", 1), MASS, "a"),
            says="`holder` and `base` have no mass when libsdformat merges them",
        ),
        Bad(RIG.format("", NOTHING.replace("0", "«0»", 1), MASS, "a")),
    )
    good = (
        Good(RIG.format(NOTHING, NOTHING, MASS, "z"), why="there is mass already when it is merged"),
        Good(RIG.format("", "", MASS, "a"), why="without inertial there is nothing to merge"),
        Good(RIG.format(NOTHING, NOTHING, "", "a"), why="without any mass the link is left out"),
    )

    @staticmethod
    def applies(link: Link) -> bool:
        return link in link.model.as_built_by(Consumer.GAZEBO).without_center

    def check(self, link: Link) -> Iterator[Diagnostic]:
        other = link.model.as_built_by(Consumer.GAZEBO).without_center[link]
        target = link.inertial.mass.value if link.inertial.is_given else None
        message = (
            f"`{link.name}` and `{other.name}` have no mass when libsdformat merges them: "
            "their center of mass is 0/0"
        )
        yield self.diagnostic(target or link, message, labels={other: "the link above"})

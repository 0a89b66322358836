from collections.abc import Iterator

from sdfcheck import (
    IN_URDF_LINK,
    REFUSES,
    Bad,
    Consumer,
    Diagnostic,
    Good,
    Inertial,
    Rule,
    Severity,
    named,
    warns,
)

PARTS = ("mass", "inertia")
MOMENTS = frozenset({"ixx", "iyy", "izz"})


class IncompleteInertia(Rule):
    """An inertial lacks its mass, its inertia or some of the six numbers.

    urdfdom stops reading the link there: its visuals and collisions are lost, and in
    Gazebo a link without mass goes with all that hangs on it. Drake takes zero for missing
    moments, and for a missing mass a solid sphere of 1 kg. PyBullet refuses the file where the mass, the inertia or
    one of its moments is missing.
    """

    code = "URD010"
    name = "incomplete-inertia"
    severity = Severity.ERROR
    remedy = """Give the inertial a `<mass value="…"/>` and an `<inertia>` with all six numbers.

    Products that are zero are written as 0: `<inertia ixx="…" ixy="0" ixz="0" iyy="…" iyz="0" izz="…"/>`,
    in kg·m². `sdfcheck rule missing-inertial` has the ways to get them. A link that is a mere frame has no
    `<inertial>` at all.
    """
    looks_at = (Inertial,)
    selects = ("urdf:link/inertial",)
    scaffold = IN_URDF_LINK

    bad = (
        Bad(
            '<inertial><mass value="1"/><«inertia» ixx="1" iyy="1" izz="1"/></inertial>',
            says="the inertia of link `base` has no `ixy`, `ixz` or `iyz`",
        ),
        Bad('<«inertial»><mass value="1"/></inertial>', says="the inertial of link `base` has no `inertia`"),
        Bad(
            '<«inertial»><inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial>',
            says="has no `mass`",
        ),
        Bad('<«inertial»><origin xyz="0 0 0"/></inertial>', says="has no `mass` and no `inertia`"),
    )
    good = (
        Good(
            '<inertial><mass value="1"/><inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial>'
        ),
        Good(
            '<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro"><xacro:macro name="solid" params="m"/>'
            '<link name="a"><inertial><mass value="1"/><solid m="1"/></inertial></link></robot>',
            why="missing-xacro-prefix reports the call",
            file="arm.urdf.xacro",
            scaffold="{}",
        ),
        Good(
            '<visual><geometry><sphere radius="1"/></geometry></visual>', why="none at all is another matter"
        ),
    )

    @staticmethod
    def applies(inertial: Inertial) -> bool:
        return bool(_missing(inertial)) or any(map(inertial.lacks, PARTS))

    def check(self, inertial: Inertial) -> Iterator[Diagnostic]:
        link = inertial.link.title
        if parts := list(filter(inertial.lacks, PARTS)):
            affects = {Consumer.PYBULLET: REFUSES}
            if "mass" in parts:
                affects[Consumer.DRAKE] = warns("takes a solid sphere of 1 kg")
            lacks = " and no ".join(f"`{part}`" for part in parts)
            yield self.diagnostic(inertial, f"the inertial of {link} has no {lacks}", affects=affects)
        missing = _missing(inertial)
        if missing and inertial.inertia is not None:
            affects = {Consumer.PYBULLET: REFUSES} if MOMENTS.intersection(missing) else {}
            message = f"the inertia of {link} has no {named(missing, 'or')}"
            yield self.diagnostic(inertial.inertia, message, affects=affects)


def _missing(inertial: Inertial) -> list[str]:
    """The moments that are not there, not even under a misspelled name."""
    inertia = inertial.inertia
    if inertia is None:
        return []
    return [name for name in inertial.missing_moments if inertial.part(inertia).lacks(name)]

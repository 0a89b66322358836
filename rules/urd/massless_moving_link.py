from collections.abc import Iterator

from sdfcheck import Bad, Consumer, Diagnostic, Good, Link, Model, Rule, Severity, warns

INERTIA = '<inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/>'
MASS = f'<inertial><mass value="1"/>{INERTIA}</inertial>'
ARM = (
    f'<robot name="r"><link name="a">{MASS}</link>{{}}'
    '<joint name="j" type="continuous"><parent link="a"/><child link="b"/></joint></robot>'
)


class MasslessMovingLink(Rule):
    """A link that moves has no mass.

    libsdformat drops the link and all that hangs on it; in Drake its joint makes the mass
    matrix singular, and the simulation fails. A link counts as massless when neither it nor
    any link that fixed joints tie to it has mass. The same holds below a fixed joint that
    libsdformat is told to keep.
    """

    code = "URD014"
    name = "massless-moving-link"
    severity = Severity.WARNING
    affects = {
        Consumer.GAZEBO: warns("drops the link and those below it"),
        Consumer.DRAKE: warns("cannot simulate it"),
    }
    looks_at = (Model,)
    selects = ("urdf:robot",)
    scaffold = ARM

    bad = (
        Bad('<«link» name="b"/>', says="link `b` moves and has no mass, so libsdformat drops it"),
        Bad(
            '<«link» name="b"/><link name="c"/>'
            '<joint name="k" type="fixed"><parent link="b"/><child link="c"/></joint>',
            says="drops it and the 1 link below it",
        ),
        Bad('<link name="b"><inertial><mass value="«0»"/>' + INERTIA + "</inertial></link>"),
    )
    good = (
        Good(f'<link name="b">{MASS}</link>'),
        Good(
            f'<link name="b"/><link name="c">{MASS}</link>'
            '<joint name="k" type="fixed"><parent link="b"/><child link="c"/></joint>',
            why="c is fixed to b",
        ),
    )

    @staticmethod
    def applies(robot: Model) -> bool:
        return bool(dropped(robot))

    def check(self, robot: Model) -> Iterator[Diagnostic]:
        for link in dropped(robot):
            joint = link.parent_joints[0]
            below = sum(1 for _ in link.below()) - 1
            others = f" and the {below} link{'s' * (below > 1)} below it" if below else ""
            what = "is not to be merged" if joint.is_fixed else "moves"
            message = f"{link.title} {what} and has no mass, so libsdformat drops it{others}"
            label = "is kept" if joint.is_fixed else "moves it"
            mass = link.inertial.mass
            yield self.diagnostic(mass if mass.is_given else link, message, labels={joint: label})


def dropped(robot: Model) -> list[Link]:
    """Links that stay links of their own, without mass; a robot without any is reported for its root."""
    lumping = robot.lumping
    found: list[Link] = []
    for top in lumping.tops:
        members = list(top.below())
        if any(link.has_mass for link in members):
            found += [link for link in members[1:] if link not in lumping.with_mass and is_apart(link)]
    return found


def is_apart(link: Link) -> bool:
    joint = link.parent_joints[0]
    return joint.moves or joint.is_preserved

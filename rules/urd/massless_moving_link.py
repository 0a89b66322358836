from collections.abc import Iterator

from sdfcheck import (
    Bad,
    Consumer,
    Diagnostic,
    Good,
    Link,
    Model,
    Reaction,
    Rule,
    Severity,
    accepts,
    refuses,
    warns,
)
from sdfcheck_rules.urd.without_mass import in_drake

INERTIA = '<inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/>'
MASS = f'<inertial><mass value="1"/>{INERTIA}</inertial>'
ARM = (
    f'<robot name="r"><link name="root"/><link name="a">{MASS}</link>{{}}'
    '<joint name="base" type="fixed"><parent link="root"/><child link="a"/></joint>'
    '<joint name="j" type="continuous"><parent link="a"/><child link="b"/></joint></robot>'
)


class MasslessMovingLink(Rule):
    """A link that moves has no mass.

    libsdformat drops the link and all that hangs on it; in Drake its joint makes the mass
    matrix singular, and the simulation fails. A link counts as massless when it and all links that
    fixed joints tie to it from below have no mass. The same holds below a fixed
    joint that libsdformat has to keep. Where something is fixed to such a link or to one below it, a
    frame is left that hangs on nothing, and libsdformat 17 refuses the file; so it does where another joint
    mimics the one that is dropped. Releases before 9.10.1, 12.7.2, 13.5 and 14.1 dropped a link of up to 1e-6 kg as
    well, which is worth knowing.
    """

    code = "URD014"
    name = "massless-moving-link"
    severity = Severity.WARNING
    remedy = """Give the link an `<inertial>` with its mass and moments.

    `sdfcheck rule missing-inertial` says how to get the numbers. A link between two joints that only splits
    one motion in two (a universal joint, a virtual axis) needs a small mass too: about a hundredth of the
    next link, with moments to match. A link that does not move after all is tied by a fixed joint.
    """
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
        Bad(
            f'<«link» name="b"/><link name="c">{MASS}</link>'
            '<joint name="k" type="continuous"><parent link="a"/><child link="c"/><mimic joint="j"/></joint>',
            says="so libsdformat drops it, and refuses joint `k`, which follows joint `j`",
        ),
        Bad(
            f'<«link» name="b"/><link name="c">{MASS}</link>'
            '<joint name="k" type="continuous"><parent link="b"/><child link="c"/><mimic joint="j"/></joint>',
            says="so libsdformat drops it and the 1 link below it",
        ),
        Bad(
            f'<«link» name="b"/><link name="c">{MASS}</link><link name="d">{MASS}</link>'
            '<joint name="k" type="continuous"><parent link="b"/><child link="c"/></joint>'
            '<joint name="m" type="continuous"><parent link="a"/><child link="d"/><mimic joint="k"/></joint>',
            says="drops it and the 1 link below it, and refuses joint `m`, which follows joint `k`",
        ),
        Bad('<link name="b"><inertial><mass value="«0»"/>' + INERTIA + "</inertial></link>"),
        Bad(
            '<link name="b"><inertial><mass value="«1e-7»"/>' + INERTIA + "</inertial></link>",
            says="has a mass of 1e-7 kg, for which libsdformat before 12.7.2 drops it",
        ),
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
        return bool(dropped(robot) or faint(robot))

    def check(self, robot: Model) -> Iterator[Diagnostic]:
        built, links = robot.as_built_by(Consumer.GAZEBO), dropped(robot)
        for link in links:
            joint = link.parent_joints[0]
            members = list(link.below())
            below = len(members) - 1
            others = f" and the {below} link{'s' * (below > 1)} below it" if below else ""
            what = "is not to be merged" if joint.is_fixed else "moves"
            message = f"{link.title} {what} and has no mass, so libsdformat drops it{others}"
            labels = {joint: "is kept" if joint.is_fixed else "moves it"}
            leader = next((each for each in members if each in built.followed), None)
            if leader is not None:
                follower = built.followed[leader]
                message += f", and refuses {follower.title}, which follows {leader.parent_joints[0].title}"
                labels[follower] = "follows it"
            affects, mass = _affects(link, built.refused_without(link)), link.inertial.mass
            place, cause = mass if mass.is_given else link, built.mass_fault(link)
            yield self.diagnostic(place, message, labels=labels, affects=affects, cause=cause)
        for link in faint(robot):
            mass = link.inertial.mass
            message = (
                f"{link.title} has a mass of {mass.text} kg, for which libsdformat before 12.7.2 drops it"
            )
            affects = {
                Consumer.GAZEBO: warns("takes it; before 12.7.2 drops the link and those below it"),
                Consumer.DRAKE: accepts("takes it as it is"),
            }
            yield self.diagnostic(mass, message, severity=Severity.INFO, affects=affects)


def _affects(link: Link, refusal: str) -> dict[Consumer, Reaction]:
    found = in_drake(link)
    if refusal:
        found[Consumer.GAZEBO] = refuses(f"refuses the file, for {refusal}")
    if link.has_mass:
        found[Consumer.DRAKE] = accepts("takes it as it is")
    return found


def dropped(robot: Model) -> list[Link]:
    """Links that stay links of their own, without mass; a robot without any is reported for its root."""
    built = robot.as_built_by(Consumer.GAZEBO)
    found: list[Link] = []
    for top in built.tops:
        members = list(top.below())
        if any(link.has_mass for link in members):
            found += [link for link in members[1:] if link not in built.with_mass and is_apart(link)]
    return found


def faint(robot: Model) -> list[Link]:
    """Links that stay links of their own, with a mass of their own that older releases of libsdformat take for none."""
    built = robot.as_built_by(Consumer.GAZEBO)
    found = (link for link in robot.links if link in built.barely_with_mass and link.inertial.mass.is_given)
    return [link for link in found if link.parent_joints and is_apart(link) and not built.is_dropped(link)]


def is_apart(link: Link) -> bool:
    joint = link.parent_joints[0]
    return joint.moves or joint.is_preserved

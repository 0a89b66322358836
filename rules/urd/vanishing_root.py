from collections.abc import Iterator

from sdfcheck import (
    REFUSES,
    Bad,
    BuiltJoint,
    Consumer,
    Diagnostic,
    Good,
    Link,
    Model,
    Rule,
    Severity,
    drops,
    warns,
)
from sdfcheck_rules.urd.without_mass import in_drake

MASS = '<inertial><mass value="1"/><inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial>'
LINKS = f'<link name="b">{MASS}</link>'
TURNING = '<joint name="j" type="continuous"><parent link="a"/><child link="b"/></joint>'


class VanishingRoot(Rule):
    """The root link has no mass, so that the whole robot disappears in Gazebo.

    libsdformat drops a link without mass together with all that hangs on it. Links that
    fixed joints tie to it count, for they are merged into it; a root called `world` is the
    world, and then its children are the roots. One without mass that is fixed to the world is left out alone,
    and the joints on it have no parent any more: libsdformat refuses the file. A robot without any mass at all,
    fit to be looked at but not to be simulated, gets a mere hint.
    """

    code = "URD013"
    name = "vanishing-root"
    severity = Severity.WARNING
    remedy = """Give the root an `<inertial>`, or a link that a fixed joint ties to it.

    For a robot that is bolted to the floor, call the root `world`: the joint that follows then holds the
    robot in place. `sdfcheck rule missing-inertial` says how to get the numbers. To look at the robot in
    RViz, no mass is needed.
    """
    looks_at = (Model,)
    selects = ("urdf:robot",)
    scaffold = '<robot name="r">{}</robot>'

    bad = (
        Bad(
            f'<«link» name="a"/>{LINKS}{TURNING}',
            says="root link `a` has no mass, so libsdformat drops it and the 1 link below it",
        ),
        Bad(
            f'<link name="world"/><«link» name="a"/>{LINKS}{TURNING}'
            '<joint name="f" type="fixed"><parent link="world"/><child link="a"/></joint>',
            says="link `a` has no mass, so libsdformat leaves it out, and joint `j` loses its parent",
        ),
        Bad(
            f'<link name="world"/><«link» name="a"/>{LINKS}{TURNING.replace(chr(34) + "a", chr(34) + "world")}'
            '<joint name="f" type="fixed"><parent link="world"/><child link="a"/></joint>',
            says="link `a` has no mass, so libsdformat leaves it out",
        ),
        Bad('<«link» name="a"/>', says="no link of robot `r` has mass"),
        Bad('<«link» name="world"/>', says="robot `r` has no link but `world`"),
    )
    good = (
        Good(f'<link name="a"/>{LINKS}{TURNING.replace("continuous", "fixed")}', why="b is merged into a"),
        Good(
            f'<link name="world"/>{LINKS}{TURNING.replace(chr(34) + "a", chr(34) + "world")}',
            why="the world itself",
        ),
    )

    @staticmethod
    def applies(robot: Model) -> bool:
        if not robot.tree.is_whole or not all(each.moves or each.type == "fixed" for each in robot.joints):
            return is_world_alone(robot)  # what is built of it follows from a joint
        built = robot.as_built_by(Consumer.GAZEBO)
        return not built.with_mass.issuperset(built.tops) or is_world_alone(robot)

    def check(self, robot: Model) -> Iterator[Diagnostic]:
        if is_world_alone(robot):
            message = f"{robot.title} has no link but `world`, so libsdformat makes an empty model of it"
            yield self.diagnostic(robot.links[0], message, severity=Severity.INFO)
        built = robot.as_built_by(Consumer.GAZEBO)
        for top in built.tops:
            if top in built.with_mass:
                continue
            if built.is_left_out(top) and built.links:
                yield self.left_out(top, built.orphaned.get(top))
                continue
            links, affects = list(top.below()), in_drake(top)
            below = f" and the {len(links) - 1} link{'s' * (len(links) > 2)} below it" if links[1:] else ""
            message = f"root {top.title} has no mass, so libsdformat drops it{below}"
            if built.links:
                affects[Consumer.GAZEBO] = drops(f"it{below}")
            elif not any(link.has_mass for link in links):
                message = f"no link of {robot.title} has mass, so libsdformat makes an empty model of it"
                if robot.is_static:
                    affects[Consumer.GAZEBO] = warns("loads an empty model")
                yield self.diagnostic(top, message, severity=Severity.INFO, affects=affects)
                continue
            yield self.diagnostic(top, message, affects=affects, cause=built.mass_fault(top))

    def left_out(self, top: Link, lost: BuiltJoint | None) -> Diagnostic:
        if lost is None:
            message = f"{top.title} has no mass, so libsdformat leaves it out"
            affects = {**in_drake(top), Consumer.GAZEBO: warns("leaves it out")}
            return self.diagnostic(top, message, severity=Severity.INFO, affects=affects)
        message = (
            f"{top.title} has no mass, so libsdformat leaves it out, and joint `{lost.name}` loses its parent"
        )
        affects = {**in_drake(top), Consumer.GAZEBO: REFUSES}
        labels = {lost.origin: "the joint"}
        return self.diagnostic(top, message, severity=Severity.ERROR, affects=affects, labels=labels)


def is_world_alone(robot: Model) -> bool:
    """Is the world itself the only link?"""
    return len(robot.links) == 1 and robot.links[0].name == "world"

from collections.abc import Iterator

from sdfcheck import Bad, Consumer, Diagnostic, Good, Rule, Severity, problems, warns

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
    explains = (problems.MasslessMovingLink,)
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

    def check(self, problem: problems.MasslessMovingLink) -> Iterator[Diagnostic]:
        below = problem.lost - 1
        others = f" and the {below} link{'s' * (below > 1)} below it" if below else ""
        is_kept = problem.joint.attributes.get("type") == "fixed"
        what = "is not to be merged" if is_kept else "moves"
        message = f"{problem.link.title} {what} and has no mass, so libsdformat drops it{others}"
        label = "is kept" if is_kept else "moves it"
        yield self.diagnostic(problem.mass or problem.link, message, labels={problem.joint: label})

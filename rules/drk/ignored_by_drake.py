from collections.abc import Iterator

from sdfcheck import Bad, Consumer, Diagnostic, Element, Good, Rule, Severity, problems, used, warns
from sdfcheck_rules.drk.scaffolds import AXIS, LINK, ROBOT


class IgnoredByDrake(Rule):
    """A standard element or attribute that Drake passes over.

    Drake reads what it needs for dynamics and geometry. Sensors, plugins, joint friction, the surface
    parameters of Gazebo's engines and the like have no effect; for some of them there is a warning.
    """

    code = "DRK012"
    name = "ignored-by-drake"
    severity = Severity.INFO
    default = False
    affects = {Consumer.DRAKE: warns("ignores it")}
    explains = (problems.IgnoredByDrake,)
    scaffold = LINK

    bad = (
        Bad(
            "<«enable_wind»>true</enable_wind>",
            says="`enable_wind` in `link` is ignored by Drake, with a warning",
        ),
        Bad(
            "<dynamics><«friction»>0.5</friction></dynamics>",
            says="`friction` in `axis/dynamics` is ignored by Drake, without a word",
            scaffold=AXIS,
        ),
        Bad(
            '<link name="c"/><joint name="k" type="fixed"><parent link="b"/><child link="c"/>'
            '<«calibration» rising="0"/></joint>',
            scaffold=ROBOT,
        ),
    )
    good = (
        Good("<gravity>true</gravity>", why="the only value that Drake knows"),
        Good("<dynamics><friction>0</friction></dynamics>", scaffold=AXIS),
    )

    def check(self, problem: problems.IgnoredByDrake) -> Iterator[Diagnostic]:
        target = problem.target
        name = target.name if isinstance(target, Element) else target.attribute
        how = "with a warning" if problem.warned else "without a word"
        place = target if isinstance(target, Element) else target.name_span
        yield self.diagnostic(
            place, f"`{name}`{used(problem.uses)} in `{problem.parent}` is ignored by Drake, {how}"
        )

from collections.abc import Iterator

from sdfcheck import IN_LINK, REFUSES, Bad, Consumer, Diagnostic, Good, Rule, Severity, problems, warns


class UnusableAutomaticInertia(Rule):
    """An inertia is to be computed from collisions that do not give one.

    `<inertial auto="true">` (from 1.11) takes mass and moments from the link's collisions:
    there must be one, each with a volume and a positive density. libsdformat refuses the
    model otherwise.
    """

    code = "INR008"
    name = "unusable-automatic-inertia"
    severity = Severity.ERROR
    explains = (problems.UnusableAutomaticInertia,)
    affects = {Consumer.GAZEBO: REFUSES, Consumer.DRAKE: REFUSES}
    scaffold = IN_LINK

    bad = (
        Bad('<«inertial» auto="true"/>', says="no collision"),
        Bad(
            '<inertial auto="true"/><«collision» name="c"><density>1</density><geometry><plane><normal>0 0 1</normal>'
            "<size>1 1</size></plane></geometry></collision>",
            says="a plane has no volume",
        ),
        Bad(
            '<inertial auto="true"/><collision name="c"><«density»>-1</density><geometry><box><size>1 1 1</size></box>'
            "</geometry></collision>",
            says="density -1",
        ),
    )
    good = (
        Good(
            '<inertial auto="true"/><collision name="c"><density>800</density><geometry><box><size>1 1 1</size></box>'
            "</geometry></collision>",
        ),
    )

    def check(self, problem: problems.UnusableAutomaticInertia) -> Iterator[Diagnostic]:
        name = problem.link.attributes.get("name", "")
        message = f"the inertia of link `{name}` cannot be computed: {problem.reason}"
        is_density = problem.place.name == "density"
        affects = {Consumer.DRAKE: warns("takes a solid sphere in its place")} if is_density else {}
        yield self.diagnostic(problem.place, message, affects=affects)

from collections.abc import Iterator

from sdfcheck import (
    IN_URDF_LINK,
    REFUSES,
    Bad,
    Consumer,
    Diagnostic,
    Good,
    Rule,
    Severity,
    named,
    problems,
    warns,
)


class IncompleteInertia(Rule):
    """An inertial lacks its mass, its inertia or some of the six numbers.

    urdfdom stops reading the link there: its visuals and collisions are lost, and in
    Gazebo a link without mass goes with all that hangs on it. Drake takes zero for what
    is missing.
    """

    code = "URD010"
    name = "incomplete-inertia"
    severity = Severity.ERROR
    affects = {
        Consumer.GAZEBO: warns("drops the rest of the link"),
        Consumer.DRAKE: warns("takes zero"),
        Consumer.URDFDOM: warns("drops the rest of the link"),
        Consumer.MUJOCO: REFUSES,
    }
    explains = (problems.IncompleteInertial,)
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
    )
    good = (
        Good(
            '<inertial><mass value="1"/><inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial>'
        ),
        Good(
            '<visual><geometry><sphere radius="1"/></geometry></visual>', why="none at all is another matter"
        ),
    )

    def check(self, problem: problems.IncompleteInertial) -> Iterator[Diagnostic]:
        message = f"the {problem.element.name} of {problem.link.title} has no {named(problem.missing, 'or')}"
        yield self.diagnostic(problem.element, message)

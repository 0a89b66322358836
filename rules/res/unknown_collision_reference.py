from collections.abc import Iterator

from sdfcheck import (
    IN_LINK,
    IN_MODEL,
    IN_WORLD,
    Bad,
    Consumer,
    Diagnostic,
    Good,
    Rule,
    Severity,
    problems,
    warns,
)

SENSOR = '<sensor name="s" type="contact"><contact><collision>{}</collision></contact></sensor>'
SHELL = '<collision name="shell"><geometry><sphere><radius>1</radius></sphere></geometry></collision>'


class UnknownCollisionReference(Rule):
    """A contact sensor, sound, gripper or state names a collision, link or model that is not there.

    No reader complains. The sensor never senses, the sound never sounds, the gripper
    never grips, the state is not restored.
    """

    code = "RES011"
    name = "unknown-collision-reference"
    severity = Severity.WARNING
    affects = {Consumer.GAZEBO: warns("senses nothing")}
    explains = (problems.UnknownReference,)
    scaffold = IN_LINK

    bad = (
        Bad(SHELL + SENSOR.format("«shel»"), says="no collision `shel`, did you mean `shell`?"),
        Bad(
            '<gripper name="g"><gripper_link>«finger»</gripper_link><palm_link>base</palm_link></gripper>',
            scaffold=IN_MODEL,
            says="no link `finger`",
        ),
        Bad(
            '<gripper name="g"><gripper_link>base</gripper_link><palm_link>«bass»</palm_link></gripper>',
            scaffold=IN_MODEL,
            says="did you mean `base`?",
        ),
        Bad(
            '<state world_name="w"><model_state name="«cart»"/></state>',
            scaffold=IN_WORLD,
            says="world `w` has no model `cart`",
        ),
    )
    good = (
        Good(SHELL + SENSOR.format("shell")),
        Good(SHELL + SENSOR.format("__default__"), why="the word for nothing in particular"),
        Good(SHELL + SENSOR.format("m::base::shell"), why="readers differ in how they spell scopes"),
        Good(
            '<gripper name="g"><gripper_link>base</gripper_link><palm_link>base</palm_link></gripper>',
            scaffold=IN_MODEL,
        ),
    )

    def check(self, problem: problems.UnknownReference) -> Iterator[Diagnostic]:
        message = f"{problem.scope.title} has no {problem.kind} `{problem.value.text}`"
        if problem.suggestion is not None:
            message += f", did you mean `{problem.suggestion}`?"
        yield self.diagnostic(problem.value, message)

from collections.abc import Iterator

from sdfcheck import (
    IN_LINK,
    IN_MODEL,
    IN_WORLD,
    Bad,
    Consumer,
    Contact,
    Diagnostic,
    Good,
    Gripper,
    Rule,
    Severity,
    State,
    suggest_in,
    warns,
    write_instead,
)

SENSOR = '<sensor name="s" type="contact"><contact><collision>{}</collision></contact></sensor>'
SHELL = '<collision name="shell"><geometry><sphere><radius>1</radius></sphere></geometry></collision>'


class UnknownCollisionReference(Rule):
    """A contact sensor, sound, gripper or state names a collision, link or model that is not there.

    No consumer complains. The sensor never senses, the sound never sounds, the gripper
    never grips, the state is not restored.
    """

    code = "RES011"
    name = "unknown-collision-reference"
    severity = Severity.WARNING
    affects = {Consumer.GAZEBO: warns("senses nothing")}
    looks_at = (Contact, Gripper, State)
    scaffold = IN_LINK

    bad = (
        Bad(
            SHELL + SENSOR.format("«shel»"),
            fixed=SHELL + SENSOR.format("shell"),
            unsafe=True,
            says="no collision `shel`, did you mean `shell`?",
        ),
        Bad(
            '<gripper name="g"><gripper_link>«finger»</gripper_link><palm_link>base</palm_link></gripper>',
            scaffold=IN_MODEL,
            says="no link `finger`",
        ),
        Bad(
            '<gripper name="g"><gripper_link>base</gripper_link><palm_link>«bass»</palm_link></gripper>',
            fixed='<gripper name="g"><gripper_link>base</gripper_link><palm_link>base</palm_link></gripper>',
            unsafe=True,
            scaffold=IN_MODEL,
            says="did you mean `base`?",
        ),
        Bad(
            '<state world_name="w"><model_state name="«cart»"/></state>',
            scaffold=IN_WORLD,
            says="world `w` has no model `cart`",
        ),
        Bad(
            '<state world_name="w"><model name="«cart»"/></state>',
            scaffold='<sdf version="1.9"><world name="w">{}</world></sdf>',
            says="world `w` has no model `cart`",
        ),
        Bad('<state world_name="«v»"/>', scaffold=IN_WORLD, says="has no world `v`"),
    )
    good = (
        Good(SHELL + SENSOR.format("shell")),
        Good(SHELL + SENSOR.format(" shell "), why="spaces around a name are not part of it"),
        Good(SHELL + SENSOR.format("__default__"), why="the word for nothing in particular"),
        Good(SHELL + SENSOR.format("m::base::shell"), why="consumers differ in how they spell scopes"),
        Good(
            '<gripper name="g"><gripper_link>base</gripper_link><palm_link>base</palm_link></gripper>',
            scaffold=IN_MODEL,
        ),
    )

    @staticmethod
    def applies(part: Contact | Gripper | State) -> bool:
        return bool(part.unresolved)

    def check(self, part: Contact | Gripper | State) -> Iterator[Diagnostic]:
        for value, kind, scope, names in part.unresolved:
            message = f"{scope.title} has no {kind} `{value.text}`"
            near = suggest_in(part.document, value.text, names)
            if near is not None:
                message += f", did you mean `{near}`?"
            yield self.diagnostic(value, message, fix=write_instead(near, value))

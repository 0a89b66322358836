from collections.abc import Iterator

from sdfcheck import IN_WORLD, Actor, Bad, Diagnostic, Good, Rule, Severity, Value, named, write_instead

ACTOR = (
    '<actor name="walker"><skin><filename>https://example.org/walk.dae</filename></skin>'
    '<animation name="walk"><filename>https://example.org/walk.dae</filename></animation>'
    '<script><trajectory id="0" type="{}"><waypoint><time>0</time><pose>0 0 0 0 0 0</pose></waypoint>'
    "<waypoint><time>2</time><pose>2 0 0 0 0 0</pose></waypoint></trajectory></script></actor>"
)


class UnknownAnimation(Rule):
    """A trajectory of an actor is of a type that no animation of the actor has.

    The type of a trajectory is the name of the animation to play on the way. Without one of that name the actor
    slides along in its resting pose in Gazebo Classic, and plays the movement of its skin in the new Gazebo.
    """

    code = "SCH027"
    name = "unknown-animation"
    severity = Severity.WARNING
    remedy = """Let `type` name an animation of the actor.

    It is the `name` of one of its `<animation>` elements; if there is none, add one with the file of the
    movement.
    """
    looks_at = (Actor,)
    scaffold = IN_WORLD

    bad = (
        Bad(
            ACTOR.format("«wlak»"),
            fixed=ACTOR.format("walk"),
            unsafe=True,
            says="no animation of actor `walker` is called `wlak`; did you mean `walk`?",
        ),
        Bad(ACTOR.format("«run_away»"), says="; there is `walk`"),
    )
    good = (Good(ACTOR.format("walk")),)

    @staticmethod
    def applies(actor: Actor) -> bool:
        return bool(actor.animations) and any(unknown(actor))

    def check(self, actor: Actor) -> Iterator[Diagnostic]:
        names = sorted(animations(actor))
        for value in unknown(actor):
            meant = actor.nearest(value.text, names)
            rest = f"did you mean `{meant}`?" if meant is not None else f"there is {named(names, most=4)}"
            message = f"no animation of {actor.title} is called `{value.text}`"
            message += f"; {rest}" if names else ""
            yield self.diagnostic(value, message, fix=write_instead(meant, value))


def animations(actor: Actor) -> set[str]:
    names = {animation.attributes.get("name", "").strip() for animation in actor.animations}
    return names - {""}


def unknown(actor: Actor) -> Iterator[Value]:
    """The types of trajectories that are not the names of animations."""
    names = animations(actor)
    for trajectory in actor.trajectories:
        value = trajectory.attribute("type")
        if value is not None and value.text.strip() and value.text.strip() not in names:
            yield value

from collections.abc import Iterator

from sdfcheck import Bad, Diagnostic, Element, Good, Rule, Severity, State

FAR = 0.05
"""So far (m) nothing settles in the first steps."""
KINDS = ("model", "model_state")
"""Models in a state; since SDFormat 1.12 they are called by the second name."""
MODEL = '<model name="crate">{}<link name="l"/></model>'
STATE = '<state world_name="w"><model name="crate"><pose>{} 0 0 0 0 0</pose></model></state>'
SPEED = (
    '<state world_name="w"><model name="crate"><pose>0 0 0 0 0 0</pose><link name="l"><pose>0 0 0 0 0 0</pose>'
    "<velocity>{}</velocity></link></model></state>"
)
FAST = 0.1
"""m/s: things that lie still are slower."""


class StateElsewhere(Rule):
    """The state of a saved world has models elsewhere than the models themselves say, or moving.

    Gazebo Classic starts from the state, and goes back to the poses of the models when the world is reset; the new
    Gazebo reads no state. A world that was saved after things were moved has both, and one that was saved while they
    fell throws them as soon as it runs.
    """

    code = "SCH041"
    name = "state-elsewhere"
    severity = Severity.INFO
    remedy = """Write the poses of the state into the models, and remove `<state>`.

    A model is then in one place at the start, after a reset, and in the new Gazebo. Places and speeds of links in the
    state are of one moment, and are not needed.
    """
    looks_at = (State,)
    scaffold = '<sdf version="1.6"><world name="w">{}</world></sdf>'

    bad = (
        Bad(
            MODEL.format("<pose>1 0 0 0 0 0</pose>") + STATE.format("«3").replace(" 0</pose>", " 0»</pose>"),
            says="model `crate` is elsewhere in the state, by 2 m",
        ),
        Bad(
            MODEL.format("") + SPEED.format("«0 0 -4.2 0 0 0»"),
            says="model `crate` starts with 4.2 m/s, by the state",
        ),
    )
    good = (
        Good(MODEL.format("") + SPEED.format("0 0 -0.01 0 0 0"), why="it settles"),
        Good(MODEL.format("<pose>1 0 0 0 0 0</pose>") + STATE.format("1")),
        Good(MODEL.format("") + STATE.format("0.01"), why="it settled"),
        Good(STATE.format("3"), why="the model was inserted"),
    )

    @staticmethod
    def applies(state: State) -> bool:
        return next(moved(state), None) is not None or next(thrown(state), None) is not None

    def check(self, state: State) -> Iterator[Diagnostic]:
        found = list(moved(state))
        if not found:
            name, velocity, speed = next(thrown(state))
            message = f"model `{name}` starts with {speed:.3g} m/s, by the state"
            yield self.diagnostic(velocity.own_value, message)
            return
        (name, pose, way), *others = found
        message = f"model `{name}` is elsewhere in the state, by {way:.3g} m"
        if others:
            message = (
                f"model `{name}` and {len(others)} more are elsewhere in the state, the first by {way:.3g} m"
            )
        yield self.diagnostic(pose.own_value, message)


def models(state: State) -> Iterator[Element]:
    """The models in it."""
    return (part for kind in KINDS for part in state.element.children(kind))


def thrown(state: State) -> Iterator[tuple[str, Element, float]]:
    """The models that it has moving: name, the velocity of a link, and its size (m/s)."""
    for each in models(state) if state.world is not None else ():
        for link in (part for kind in ("link", "link_state") for part in each.children(kind)):
            velocity = link.find("velocity") or link.find("linear_velocity")
            numbers = place(velocity) if velocity is not None else None
            speed = sum(number**2 for number in numbers) ** 0.5 if numbers is not None else 0.0
            if velocity is not None and speed > FAST:
                yield each.attributes.get("name", ""), velocity, speed


def moved(state: State) -> Iterator[tuple[str, Element, float]]:
    """The models that are elsewhere in it: name, pose in the state, and how far (m)."""
    world = state.world
    if world is None:
        return
    own = {model.attributes.get("name", ""): model for model in world.element.children("model")}
    for each in models(state):
        name = each.attributes.get("name", "")
        pose, model = each.find("pose"), own.get(name)
        here, there = place(pose), place(model.find("pose") if model is not None else None)
        if pose is None or model is None or here is None or there is None:
            continue
        way = sum((a - b) ** 2 for a, b in zip(here, there, strict=True)) ** 0.5
        if way > FAR:
            yield name, pose, way


def place(pose: Element | None) -> tuple[float, ...] | None:
    """The first three numbers of a pose or velocity; None where there are none, or they are relative to a frame."""
    if pose is None or not pose.content:
        return (0.0, 0.0, 0.0)
    try:
        numbers = tuple(float(word) for word in pose.content.split()[:3])
    except ValueError:
        return None
    frames = [pose.attributes.get(name, "") for name in ("relative_to", "frame")]
    return None if any(frames) or len(numbers) < 3 else numbers

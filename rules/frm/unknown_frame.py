from collections.abc import Iterator

from sdfcheck import (
    IN_MODEL,
    SDF,
    Bad,
    Consumer,
    Diagnostic,
    FrameReference,
    Good,
    Reaction,
    Rule,
    Severity,
    accepts,
    replace,
    warns,
)

BUILT = ("frame", "include", "joint", "link", "model")
"""The parts whose poses consumers work out while they read the file."""
SHAPES = ("collision", "visual")
PLACED = (*SHAPES, "light", "particle_emitter", "projector", "sensor")
"""Those whose poses they work out later."""
IN_PARENT = warns("places it in its parent, with an error message")


class UnknownFrame(Rule):
    """A pose, an attachment or an axis refers to a frame that its scope does not have.

    A reference sees the links, joints, frames and nested models of its own model or
    world, and by `A::b` what is in nested models. It never sees what is around the model
    (SDFormat 1.8, notes on naming). libsdformat refuses the file when the pose of a link,
    joint, frame or model is concerned. It does not look at visuals, collisions, sensors
    and lights, whose poses then cannot be worked out when the simulation starts.
    """

    code = "FRM001"
    name = "unknown-frame"
    severity = Severity.ERROR
    remedy = """Name a link, joint, frame or nested model of the same model or world.

    A part of a nested model is reached by its scoped name, `arm::hand`; `sdfcheck graph frames FILE` lists
    the names. A frame of the model around it is out of reach: write the pose relative to the model, and let
    the include or the outer model place it with a pose or a joint of its own. A frame of the world cannot
    be named in a model.
    """
    looks_at = (FrameReference,)
    scaffold = IN_MODEL

    bad = (
        Bad(
            '<frame name="tool" attached_to="«bsae»"/>',
            fixed='<frame name="tool" attached_to="base"/>',
            unsafe=True,
            says="`attached_to` names `bsae`, which is not a frame of model `m`; did you mean `base`?",
        ),
        Bad(
            '<link name="arm"><visual name="v"><pose relative_to="«elbow»">0 0 1 0 0 0</pose>'
            "<geometry><sphere><radius>1</radius></sphere></geometry></visual></link>",
            says="`relative_to` names `elbow`",
        ),
        Bad(
            '<model name="gripper"><link name="palm"/></model><frame name="tool" attached_to="«palm»"/>',
            fixed='<model name="gripper"><link name="palm"/></model>'
            '<frame name="tool" attached_to="gripper::palm"/>',
            unsafe=True,
            says="in a nested model there is `gripper::palm`",
        ),
        Bad(
            '<model name="gripper"><link name="palm"><pose relative_to="«base»"/></link></model>',
            says="it is defined outside, out of reach",
        ),
        Bad(
            '<frame name="origin" attached_to="«world»"/>', says="`world`, which is not a frame of model `m`"
        ),
        Bad(
            '<sdf version="1.6"><world name="w"><gui><camera name="view"><pose frame="«base»">-5 0 9 0 0 0</pose>'
            "</camera></gui></world></sdf>",
            scaffold="",
            says="the pose of an element `camera` is never relative to a frame",
        ),
        Bad(
            '<sdf version="1.5"><model name="m"><link name="base">'
            '<pose frame="«tool»">0 0 1 0 0 0</pose></link></model></sdf>',
            scaffold="",
            says="`frame` names `tool`",
        ),
    )
    good = (
        Good(
            '<sdf version="1.7"><world name="w"><model name="m"><link name="l"/></model><state world_name="w">'
            '<model name="m"><frame name="f" attached_to="g"><pose relative_to="h"/></frame></model>'
            "</state></world></sdf>",
            scaffold="",
            why="frames in a state are not read",
        ),
        Good('<frame name="tool" attached_to="base"/><link name="arm"><pose relative_to="tool"/></link>'),
        Good('<frame name="tool" attached_to="__model__"/>', why="the model's own frame"),
        Good('<frame name="tool" attached_to=""/>', why="empty is the default"),
        Good('<frame name="tool" attached_to="base::"/>', why="malformed-scoped-name owns this one"),
        Good(
            '<model name="m"><include><uri>model://not_here</uri><name>arm</name></include>'
            '<frame name="tool" attached_to="arm::wrist"/></model>',
            scaffold=SDF,
            why="an include that could not be read may have it",
        ),
    )

    @staticmethod
    def applies(reference: FrameReference) -> bool:
        return reference.is_unresolved

    def check(self, reference: FrameReference) -> Iterator[Diagnostic]:
        name, scope = reference.name, reference.scope
        if scope is None:
            return
        if is_unread(reference):
            yield self.unread(reference)
            return
        affects, cause = _affects(reference), scope.fault_of(name)
        guess = scope.guess(name, but=(reference.owner_element.attributes.get("name", ""),))
        message = f"`{reference.value.attribute}` names `{name}`, which is not a frame of {scope.title}"
        if (meant := guess.meant) is not None:
            is_deeper = meant.endswith(f"::{name}")
            message += (
                f"; in a nested model there is `{meant}`" if is_deeper else f"; did you mean `{meant}`?"
            )
            fix = replace(reference.value, meant, f"write `{meant}`", unsafe=True)
            yield self.diagnostic(reference, message, fix=fix, affects=affects, cause=cause)
        elif name == "world":
            hint = "inside a model the frame of the world is out of reach"
            yield self.diagnostic(reference, message, help=hint, affects=affects, cause=cause)
        elif guess.outside is not None:
            message += "; it is defined outside, out of reach"
            labels = {guess.outside: f"`{name}` is defined here"}
            yield self.diagnostic(reference, message, labels=labels, affects=affects, cause=cause)
        else:
            yield self.diagnostic(reference, message, affects=affects, cause=cause)

    def unread(self, reference: FrameReference) -> Diagnostic:
        """The warning about a pose that nobody works out."""
        owner, attribute = reference.owner_element.name, reference.value.attribute
        message = (
            f"`{attribute}` names `{reference.name}`, and the pose of an element `{owner}` is never relative"
        )
        return self.diagnostic(
            reference,
            f"{message} to a frame",
            help=f"remove `{attribute}`: write the pose in the frame around the element",
            severity=Severity.WARNING,
            affects={Consumer.GAZEBO: IN_PARENT, Consumer.DRAKE: accepts("ignores the part")},
        )


def is_unread(reference: FrameReference) -> bool:
    """Does no consumer work out the pose that names it?"""
    return reference.role == "relative_to" and reference.owner_element.name not in BUILT + PLACED


def _affects(reference: FrameReference) -> dict[Consumer, Reaction]:
    owner = reference.owner_element.name
    if reference.role != "relative_to" or owner in BUILT:
        return {}
    drake = {} if owner in SHAPES else {Consumer.DRAKE: accepts("ignores the part")}
    return {Consumer.GAZEBO: IN_PARENT, **drake}

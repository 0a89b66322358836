from collections.abc import Iterator

from sdfcheck import SDF, Bad, Diagnostic, Good, Include, Model, Rule, Severity


class UnknownPlacementFrame(Rule):
    """The frame by which a model is placed is not in the model.

    With `placement_frame` the pose of a model or include says where this frame is, instead
    of the model's own. It can be any frame, link, joint or nested model of the model
    (SDFormat 1.8). libsdformat refuses the file otherwise.
    """

    code = "FRM004"
    name = "unknown-placement-frame"
    severity = Severity.ERROR
    remedy = """Name a frame, link, joint or nested model of the model that is placed.

    The name is one of the model itself, without the name of the model before it. `sdfcheck graph frames` of
    the included file lists them. Without `placement_frame` the origin of the model is what gets the pose.
    """
    looks_at = (Model, Include)
    scaffold = SDF

    bad = (
        Bad(
            '<model name="m" placement_frame="«foot»"><pose>0 0 1 0 0 0</pose><link name="base"/></model>',
            says="`foot` is not a frame of the model that is to be placed by it",
        ),
        Bad(
            '<model name="m" placement_frame="«bsae»"><link name="base"/></model>',
            fixed='<model name="m" placement_frame="base"><link name="base"/></model>',
            unsafe=True,
            says="did you mean `base`?",
        ),
    )
    good = (
        Good('<model name="m" placement_frame="foot"><link name="base"/><frame name="foot"/></model>'),
        Good('<model name="m" placement_frame="__model__"><link name="base"/></model>'),
        Good(
            '<robot name="r" placement_frame="foot"><link name="base"/></robot>',
            why="URDF has no placement frames",
            scaffold="",
        ),
    )

    @staticmethod
    def applies(placed: Model | Include) -> bool:
        value = placed.placement_frame_value
        if value is None or placed.is_urdf:
            return False
        model, name = _model(placed), value.text.strip()
        is_kept = name == "__root__" and isinstance(placed, Include)  # reserved-name reports it
        return model is not None and not is_kept and model.lacks(name)

    def check(self, placed: Model | Include) -> Iterator[Diagnostic]:
        value, model = placed.placement_frame_value, _model(placed)
        if value is None or model is None:
            return
        name = value.text.strip()
        message = f"`{name}` is not a frame of the model that is to be placed by it"
        yield self.diagnostic(value, message, meant=model.guess(name).meant)


def _model(placed: Model | Include) -> Model | None:
    """The model that has to have the frame."""
    return placed.content if isinstance(placed, Include) else placed

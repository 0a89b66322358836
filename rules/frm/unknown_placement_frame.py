from collections.abc import Iterator

from sdfcheck import REFUSES, SDF, Bad, Consumer, Diagnostic, Good, Rule, Severity, problems, replace


class UnknownPlacementFrame(Rule):
    """The frame by which a model is placed is not in the model.

    With `placement_frame` the pose of a model or include says where this frame is, instead
    of the model's own. It can be any frame, link, joint or nested model of the model
    (SDFormat 1.8). libsdformat refuses the file if it is none of them.
    """

    code = "FRM004"
    name = "unknown-placement-frame"
    severity = Severity.ERROR
    affects = {Consumer.GAZEBO: REFUSES, Consumer.DRAKE: REFUSES}
    explains = (problems.UnknownPlacementFrame,)
    scaffold = SDF

    bad = (
        Bad(
            '<model name="m" placement_frame="«foot»"><pose>0 0 1 0 0 0</pose><link name="base"/></model>',
            says="`foot` is no frame of the model that is to be placed by it",
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
    )

    def check(self, problem: problems.UnknownPlacementFrame) -> Iterator[Diagnostic]:
        value, meant = problem.value, problem.suggestion
        message = f"`{value.text.strip()}` is no frame of the model that is to be placed by it"
        if meant is None:
            yield self.diagnostic(value, message)
            return
        fix = replace(value, meant, f"write `{meant}`", unsafe=True)
        yield self.diagnostic(value, f"{message}; did you mean `{meant}`?", fix=fix)

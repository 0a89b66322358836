from collections.abc import Iterator

from sdfcheck import REFUSES, SDF, Bad, Consumer, Diagnostic, Edit, Good, Rule, Severity, make_fix, problems


class RelativeTopLevelPose(Rule):
    """The pose of a model at the top of the file is relative to a frame.

    Around such a model there is nothing to be relative to. libsdformat refuses any
    `relative_to` there, `world` too: whoever includes the model says where it goes.
    """

    code = "FRM009"
    name = "relative-top-level-pose"
    severity = Severity.ERROR
    affects = {Consumer.GAZEBO: REFUSES, Consumer.DRAKE: REFUSES}
    explains = (problems.TopLevelPose,)
    scaffold = SDF

    bad = (
        Bad(
            '<model name="m"><pose relative_to="«world»">0 0 1 0 0 0</pose><link name="base"/></model>',
            fixed='<model name="m"><pose>0 0 1 0 0 0</pose><link name="base"/></model>',
            unsafe=True,
            says="around model `m` there is no frame `world`",
        ),
    )
    good = (
        Good('<model name="m"><pose relative_to="">0 0 1 0 0 0</pose><link name="base"/></model>'),
        Good(
            '<world name="w"><model name="m"><pose relative_to="world"/><link name="base"/></model></world>'
        ),
    )

    def check(self, problem: problems.TopLevelPose) -> Iterator[Diagnostic]:
        value, pose = problem.value, problem.value.element
        model = pose.parent if pose.parent is not None else pose
        whole = pose.document.spans.attribute_whole(pose, value.attribute or "")
        fix = make_fix(f"remove `{value.attribute}`", (Edit(whole, ""),), unsafe=True)
        message = f"around {model.title} there is no frame `{value.text.strip()}`"
        yield self.diagnostic(value, message, fix=fix)

from collections.abc import Iterator

from sdfcheck import SDF, Bad, Diagnostic, FrameReference, Good, Rule, Severity, TextEdit, make_fix


class RelativeTopLevelPose(Rule):
    """The pose of a model at the top of the file is relative to a frame.

    Such a model has no frames around it. libsdformat refuses any `relative_to` there,
    `world` too: the file that includes the model places it.
    """

    code = "FRM009"
    name = "relative-top-level-pose"
    severity = Severity.ERROR
    remedy = """Remove `relative_to`: the file that includes the model places it.

    Give the pose where the model is used: as the `<pose>` of the `<include>`, which can be relative to a
    frame of the world or model there.
    """
    looks_at = (FrameReference,)
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

    @staticmethod
    def applies(reference: FrameReference) -> bool:
        return reference.scope is None and reference.owner_element.name in {"model", "include"}

    def check(self, reference: FrameReference) -> Iterator[Diagnostic]:
        pose, attribute = reference.value.element, reference.value.attribute or ""
        whole = pose.document.spans.attribute_whole(pose, attribute)
        fix = make_fix(f"remove `{attribute}`", (TextEdit(whole, ""),), unsafe=True)
        message = f"around {reference.owner_element.title} there is no frame `{reference.name}`"
        yield self.diagnostic(reference, message, fix=fix)

from collections.abc import Iterator

from sdfcheck import IN_MODEL, Bad, Diagnostic, Good, Joint, Rule, Severity


class DetachedFrame(Rule):
    """A joint ends at a frame that moves with no link.

    The own frame of a static model, and what is attached to it, belongs to no link, so there
    is nothing for a joint to hold. Drake stops at such a joint, and Gazebo's libsdformat
    refuses some of them.
    """

    code = "FRM008"
    name = "detached-frame"
    severity = Severity.ERROR
    remedy = """Name a link of the static model as the end of the joint.

    Where the static model is only a place to hold something, let the parent of the joint be `world` and
    give the joint the pose of that place. If the model has to move after all, remove its `<static>`.
    """
    looks_at = (Joint,)
    scaffold = IN_MODEL

    bad = (
        Bad(
            '<model name="stand"><static>true</static><link name="l"/></model>'
            '<joint name="j" type="fixed"><parent>«stand»</parent><child>base</child></joint>',
            says="`stand` moves with no link, because model `stand` is static",
        ),
        Bad(
            '<model name="stand"><static>true</static><link name="l"/></model>'
            '<frame name="top" attached_to="stand"/>'
            '<joint name="j" type="fixed"><parent>base</parent><child>«top»</child></joint>',
            says="`top` moves with no link",
        ),
    )
    good = (
        Good(
            '<model name="stand"><static>true</static><link name="l"/></model>'
            '<joint name="j" type="fixed"><parent>stand::l</parent><child>base</child></joint>',
            why="a link of a static model will do",
        ),
        Good(
            '<model name="stand"><link name="l"/></model>'
            '<joint name="j" type="fixed"><parent>stand</parent><child>base</child></joint>',
            why="a model that moves is placed by its canonical link",
        ),
    )

    @staticmethod
    def applies(joint: Joint) -> bool:
        parent, child = joint.parent, joint.child
        if joint.is_urdf or parent is None or child is None or joint.parent_name == joint.child_name:
            return False
        return any(end.carrier is not None and end.carrier.kind == "model" for end in (parent, child))

    def check(self, joint: Joint) -> Iterator[Diagnostic]:
        for value, end in ((joint.parent_value, joint.parent), (joint.child_value, joint.child)):
            model = end.carrier if end is not None else None
            if value is not None and model is not None and model.kind == "model":
                message = f"`{value.text}` moves with no link, because {model.title} is static"
                yield self.diagnostic(value, message)

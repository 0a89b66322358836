from collections.abc import Iterator

from sdfcheck import IN_MODEL, SDF, Bad, Diagnostic, Good, Joint, Rule, Severity


class WorldAsChild(Rule):
    """The child of a joint is the world.

    A joint moves its child, and the world does not move. libsdformat refuses the file, in
    URDF from version 17 on; Drake refuses it in SDFormat.
    """

    code = "JNT003"
    name = "world-as-child"
    severity = Severity.ERROR
    remedy = """Swap the ends: make the world the parent and the link the child.

    The position of the joint then has the opposite sign: exchange the limits and negate them, or turn the
    axis around. In SDFormat the joint is placed at its child, so the joint may need a pose to stay where it
    was.
    """
    looks_at = (Joint,)
    scaffold = IN_MODEL

    bad = (
        Bad(
            '<joint name="j" type="fixed"><parent>base</parent><child>«world»</child></joint>',
            says="the child of joint `j` is the world",
        ),
        Bad(
            '<world name="w"><model name="m"><link name="l"/></model><frame name="f"/>'
            '<joint name="j" type="fixed"><parent>m</parent><child>«f»</child></joint></world>',
            scaffold=SDF,
            says="the child `f` of joint `j` is attached to the world",
        ),
    )
    good = (Good('<joint name="j" type="fixed"><parent>world</parent><child>base</child></joint>'),)

    @staticmethod
    def applies(joint: Joint) -> bool:
        if joint.parent_value is None or joint.child_value is None:
            return False
        if joint.is_urdf:
            is_link = joint.child_name == "world" and joint.child is not None
            return is_link and joint.parent_name != "world"  # otherwise the business of self-joint
        if joint.child_name == "world":
            return True
        child = joint.child
        carrier = None if child is None or joint.parent is None else child.carrier
        return carrier is not None and carrier.kind == "world"

    def check(self, joint: Joint) -> Iterator[Diagnostic]:
        child = joint.child_value
        assert child is not None
        if child.text == "world":
            message = f"the child of {joint.title} is the world"
        else:
            message = f"the child `{child.text}` of {joint.title} is attached to the world"
        yield self.diagnostic(child, message)

from collections.abc import Iterator

from sdfcheck import IN_MODEL, IN_ROBOT, Bad, Consumer, Diagnostic, Good, Joint, Rule, Severity, drops

LOST = dict.fromkeys((Consumer.URDFDOM, Consumer.GAZEBO), drops("the link"))


class SelfJoint(Rule):
    """A joint ties a link to itself.

    Parent and child are one name, or frames that move with one link. libsdformat and
    Drake refuse the file, and in URDF the link hangs below itself, so that it is in no tree.
    """

    code = "JNT002"
    name = "self-joint"
    severity = Severity.ERROR
    remedy = """Name the link that the joint moves as its child, and another one as its parent.

    Mostly a line was copied and one of the two names was not changed. Where two frames of one link are
    named, the joint holds nothing and can be removed.
    """
    looks_at = (Joint,)
    scaffold = IN_MODEL

    bad = (
        Bad(
            '<joint name="j" type="fixed"><parent>base</parent><child>«base»</child></joint>',
            says="parent and child of joint `j` are both `base`",
        ),
        Bad(
            '<frame name="tip" attached_to="base"/>'
            '<joint name="j" type="fixed"><parent>base</parent><child>«tip»</child></joint>',
            says="parent `base` and child `tip` of joint `j` are both on link `base`",
        ),
        Bad(
            '<joint name="j" type="fixed"><parent>__model__</parent><child>«base»</child></joint>',
            says="both on link `base`",
        ),
        Bad(
            '<joint name="j" type="fixed"><parent link="base"/><child link="«base»"/></joint>',
            scaffold=IN_ROBOT,
            says="are both `base`",
        ),
    )
    good = (
        Good(
            '<link name="arm"/><frame name="tip" attached_to="arm"/>'
            '<joint name="j" type="fixed"><parent>base</parent><child>tip</child></joint>'
        ),
        Good(
            '<link name="arm"/><joint name="j" type="fixed"><parent link="base"/><child link="arm"/></joint>',
            scaffold=IN_ROBOT,
        ),
    )

    @staticmethod
    def applies(joint: Joint) -> bool:
        child, parent = joint.child_value, joint.parent_value
        if child is None or parent is None:
            return False
        if child.text == parent.text:
            return joint.is_urdf or child.text != "world"  # otherwise the business of world-as-child
        return joint.child_link is not None and joint.child_link is joint.parent_link

    def check(self, joint: Joint) -> Iterator[Diagnostic]:
        child, parent, link = joint.child_value, joint.parent_value, joint.child_link
        assert child is not None
        assert parent is not None
        if child.text == parent.text:
            message = f"parent and child of {joint.title} are both `{child.text}`"
        else:
            ends = f"parent `{parent.text}` and child `{child.text}` of {joint.title}"
            message = f"{ends} are both on link `{link.name if link is not None else ''}`"
        affects = LOST if joint.is_urdf and joint.model is not None and joint.model.tree.has_root else {}
        yield self.diagnostic(child, message, labels={parent: "the parent"}, affects=affects)

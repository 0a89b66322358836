from collections.abc import Iterator

from sdfcheck import IN_URDF_LINK, Bad, Diagnostic, Good, Link, Model, Rule, Severity
from sdfcheck_rules.muj.meshes import compiler

BOX = '<{}><geometry><box size="1 1 1"/></geometry></{}>'
SEEN, SOLID = BOX.format("«visual»", "visual"), BOX.format("collision", "collision")
KEPT = '<robot name="r"><mujoco><compiler discardvisual="false"/></mujoco><link name="a">{}</link></robot>'


class DiscardedVisual(Rule):
    """A link has visuals and no collisions, and MuJoCo does not show it.

    MuJoCo reads no visuals of URDF unless `discardvisual` is false, and shows the collisions: a link without them is
    not there to be seen, neither in its window nor in the pictures of its cameras.
    """

    code = "MUJ007"
    name = "discarded-visual"
    severity = Severity.WARNING
    remedy = """Keep the visuals with `<mujoco><compiler discardvisual="false"/></mujoco>` in the robot.

    The block is a child of `<robot>`, and other consumers of URDF ignore it. Or give the link a collision.
    """
    default = False
    looks_at = (Model,)
    needs = ("visual",)
    scaffold = IN_URDF_LINK

    bad = (Bad(SEEN, says="link `base` has visuals alone, which MuJoCo does not show"),)
    good = (
        Good(SEEN.replace("«", "").replace("»", "") + SOLID),
        Good(KEPT.format(SEEN.replace("«", "").replace("»", "")), scaffold="", why="visuals are kept"),
    )

    @staticmethod
    def applies(model: Model) -> bool:
        return bool(unseen(model))

    def check(self, model: Model) -> Iterator[Diagnostic]:
        first, *others = unseen(model)
        message = f"{first.title} has visuals alone, which MuJoCo does not show"
        message += f"; the same holds for {len(others)} more" if others else ""
        yield self.diagnostic(first.visuals[0], message)


def unseen(model: Model) -> list[Link]:
    """The links of a robot that have visuals alone, if these are not kept."""
    if not model.is_urdf or compiler(model).get("discardvisual") == "false":
        return []
    return [link for link in model.links if link.visuals and not link.collisions]

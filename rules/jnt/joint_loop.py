from collections.abc import Iterator

from sdfcheck import (
    IN_MODEL,
    IN_ROBOT,
    Bad,
    Consumer,
    Diagnostic,
    Good,
    Reaction,
    Root,
    Rule,
    Severity,
    warns,
)

SHOWN = 6
"""So many links of a loop are shown: the first ones and the last."""


class JointLoop(Rule):
    """Joints lead from a link, from parent to child, back to it.

    None of these links is the root, so nothing holds them. A URDF robot is a tree: urdfdom and
    libsdformat refuse a file without a root, and leave the ring out where there is another root; Drake
    and MuJoCo refuse both. SDFormat allows loops; Drake refuses two links that are
    each other's parents. The joint that comes last in the file is the one that is
    reported: the others made a chain before it closed them.
    """

    code = "JNT008"
    name = "joint-loop"
    severity = Severity.WARNING
    remedy = """Turn the joint around or remove it, so that one link of the ring has no parent.

    That link is the root, mostly the base. `sdfcheck graph joints FILE` shows which joint carries which
    link. A real loop of a mechanism is cut at one joint, and closed by a constraint of the simulator.
    """
    looks_at = (Root,)
    scaffold = IN_MODEL

    bad = (
        Bad(
            '<link name="arm"/><joint name="j" type="fixed"><parent>base</parent><child>arm</child></joint>'
            '<joint name="k" type="fixed"><parent>arm</parent><child>«base»</child></joint>',
            says="joints lead from link `base` back to it: `base` → `arm` → `base`",
        ),
        Bad(
            '<link name="a"/><link name="b"/>'
            '<joint name="j" type="fixed"><parent link="a"/><child link="b"/></joint>'
            '<joint name="k" type="fixed"><parent link="b"/><child link="«a»"/></joint>',
            scaffold=IN_ROBOT,
            says="joints lead from link `a` back to it",
        ),
    )
    good = (
        Good(
            '<link name="arm"/><joint name="j" type="fixed"><parent>world</parent><child>base</child></joint>'
            '<joint name="k" type="fixed"><parent>base</parent><child>arm</child></joint>'
        ),
        Good(
            '<link name="arm"/><joint name="j" type="fixed"><parent link="base"/><child link="arm"/></joint>',
            scaffold=IN_ROBOT,
        ),
    )

    @staticmethod
    def applies(root: Root) -> bool:
        return bool(root.loops)

    def check(self, root: Root) -> Iterator[Diagnostic]:
        order = {joint: number for number, joint in enumerate(root.each("Joint"))}
        for loop in root.loops:
            closing = loop.index(max(loop, key=lambda joint: order[joint]))
            ring = (*loop[closing:], *loop[:closing])
            names = [link.name for joint in ring if (link := joint.child_link) is not None]
            shown = [f"`{name}`" for name in names]
            if len(shown) > SHOWN:
                shown[SHOWN - 1 : -1] = ["…"]
            way = " → ".join((*shown, f"`{names[0]}`"))
            first, *others = [joint.child_value or joint for joint in ring]
            yield self.diagnostic(
                first,
                f"joints lead from link `{names[0]}` back to it: {way}",
                labels=dict.fromkeys(others[: SHOWN - 1], "and on from here"),
                severity=Severity.ERROR if root.is_urdf else None,
                affects=_aside(root),
            )


def _aside(root: Root) -> dict[Consumer, Reaction]:
    """The effect of a ring beside the root of a robot."""
    if not root.is_urdf or not any(model.tree.roots for model in root.models):
        return {}
    return dict.fromkeys((Consumer.GAZEBO, Consumer.URDFDOM), warns("leaves out the links of the ring"))

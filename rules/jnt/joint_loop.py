from collections.abc import Iterator

from sdfcheck import IN_MODEL, IN_ROBOT, REFUSES, Bad, Consumer, Diagnostic, Good, Root, Rule, Severity

SHOWN = 6
"""So many joints of a loop are shown."""


class JointLoop(Rule):
    """Joints lead from a link, from parent to child, back to it.

    None of these links is the root, so nothing holds them. A URDF robot is a tree, and
    urdfdom refuses the file. SDFormat allows loops; Drake refuses two links that are
    each other's parents.
    """

    code = "JNT008"
    name = "joint-loop"
    severity = Severity.WARNING
    affects = {
        Consumer.GAZEBO: {"urdf": REFUSES},
        Consumer.DRAKE: REFUSES,
        Consumer.URDFDOM: REFUSES,
        Consumer.MUJOCO: REFUSES,
    }
    looks_at = (Root,)
    scaffold = IN_MODEL

    bad = (
        Bad(
            '<link name="arm"/><joint name="j" type="fixed"><parent>base</parent><child>«arm»</child></joint>'
            '<joint name="k" type="fixed"><parent>arm</parent><child>base</child></joint>',
            says="joints lead from link `arm` back to it: `arm` → `base` → `arm`",
        ),
        Bad(
            '<link name="a"/><link name="b"/>'
            '<joint name="j" type="fixed"><parent link="a"/><child link="«b»"/></joint>'
            '<joint name="k" type="fixed"><parent link="b"/><child link="a"/></joint>',
            scaffold=IN_ROBOT,
            says="joints lead from link `b` back to it",
        ),
    )
    good = (
        Good(
            '<link name="arm"/><joint name="j" type="fixed"><parent>world</parent><child>base</child></joint>'
            '<joint name="k" type="fixed"><parent>base</parent><child>arm</child></joint>'
        ),
    )

    @staticmethod
    def applies(root: Root) -> bool:
        return bool(root.loops)

    def check(self, root: Root) -> Iterator[Diagnostic]:
        for loop in root.loops:
            names = [link.name for joint in loop if (link := joint.child_link) is not None]
            first, *others = [joint.child_value or joint for joint in loop]
            shown = [f"`{name}`" for name in names[:SHOWN]]
            more = ["…"] if len(names) > SHOWN else []
            ring = " → ".join((*shown, *more, f"`{names[0]}`"))
            yield self.diagnostic(
                first,
                f"joints lead from link `{names[0]}` back to it: {ring}",
                labels=dict.fromkeys(others[: SHOWN - 1], "and on from here"),
                severity=Severity.ERROR if root.is_urdf else None,
            )

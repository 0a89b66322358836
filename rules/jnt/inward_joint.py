from collections.abc import Iterator

from sdfcheck import Bad, Diagnostic, Good, Joint, Rule, Severity

MORE = 0.2
"""Of the surface: of 1,100 joints in public robots none moves so much more of its part into
its parent than the other way would; five of them come near, which open where fingers overlap with their palm."""
SWALLOWED = 0.9
"""Of the surface: what slides in as a whole is a drawer or a telescope."""
ALIKE = 0.9
"""The cosine of the angle between the axes of fingers of one hand."""
ARM = (
    '<robot name="r"><link name="base"><visual><origin xyz="0 0 0.2"/><geometry><box size="0.1 0.1 0.4"/></geometry>'
    '</visual></link><link name="arm"><visual><geometry><mesh filename="arm.obj"/></geometry></visual></link>'
    '<joint name="j" type="revolute"><parent link="base"/><child link="arm"/><origin xyz="0.05 0 0.35"/>'
    "{}</joint></robot>"
)
FILES = {
    "arm.obj": "v -0.03 -0.03 0\nv 0.03 -0.03 0\nv 0.03 0.03 0\nv -0.03 0.03 0\n"
    "v -0.03 -0.03 0.3\nv 0.03 -0.03 0.3\nv 0.03 0.03 0.3\nv -0.03 0.03 0.3\n"
    "f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n"
}
LIMIT = '<limit lower="{}" upper="{}" effort="1" velocity="1"/>'


class InwardJoint(Rule):
    """A joint moves its part into its parent, and would not with the opposite axis.

    Axis and limits together say where a part goes. If one of them has the wrong sign, a finger closes through the
    palm, or an elbow bends through the upper arm. Simulators do not notice, for they let neighbors pass through
    each other. Surfaces of visuals are compared, or of collisions where a link has no visual, meshes by their
    triangles, at nine positions of the joint; all other joints are at zero.
    """

    code = "JNT031"
    name = "inward-joint"
    severity = Severity.WARNING
    remedy = """Turn the axis around, or exchange and negate the limits.

    `sdfcheck view FILE` moves the joint. If the origin of the joint is too deep in its parent, move that instead.
    """
    looks_at = (Joint,)
    selects = ("urdf:robot/joint",)
    scaffold = ARM

    bad = (
        Bad(
            f'<axis xyz="«0 -1 0»"/>{LIMIT.format(0, 1.5)}',
            files=FILES,
            says="joint `j` moves 35 % of its part into `base`, and would move 9 % of it the other way",
        ),
    )
    good = (
        Good(f'<axis xyz="0 1 0"/>{LIMIT.format(0, 1.5)}', files=FILES),
        Good(f'<axis xyz="0 -1 0"/>{LIMIT.format(-1.5, 1.5)}', files=FILES, why="as far to both sides"),
        Good(
            f'<axis xyz="0 -1 0"/>{LIMIT.format(0, 1.5)}</joint>'
            + "".join(
                f'<link name="{name}"><visual><geometry><mesh filename="arm.obj"/></geometry></visual></link>'
                f'<joint name="{name}" type="revolute"><parent link="base"/><child link="{name}"/>'
                f'<origin xyz="-0.2 {place} 0.35"/><axis xyz="0 -1 0"/>{LIMIT.format(0, 1.5)}</joint>'
                for name, place in (("b", 0.5), ("c", -0.5))
            )
            + '<joint name="k" type="fixed"><parent link="base"/><child link="tip"/>',
            scaffold=ARM.replace("</robot>", '<link name="tip"/></robot>'),
            files=FILES,
            why="two more fingers of the hand close the same way and stay outside",
        ),
    )

    @staticmethod
    def applies(joint: Joint) -> bool:
        if not joint.is_one_sided or joint.model is None or not joint.model.has_mesh:
            return False
        reach = joint.reach
        if reach is None or reach.within - reach.opposite < MORE:
            return False
        return (joint.type == "revolute" or reach.within < SWALLOWED) and not is_one_of_many(joint)

    def check(self, joint: Joint) -> Iterator[Diagnostic]:
        reach, parent = joint.reach, joint.parent_link
        assert reach is not None
        assert parent is not None
        yield self.diagnostic(
            joint.axis.xyz,
            f"{joint.title} moves {reach.within:.0%} of its part into `{parent.name}`, and would move"
            f" {reach.opposite:.0%} of it the other way".replace("%", " %"),
            labels={joint.axis.limit: "its limits", parent: "the parent"},
        )


def is_one_of_many(joint: Joint) -> bool:
    """Do two more joints of its parent turn the same way as far, such as those of fingers, and stay outside?"""
    parent, own = joint.parent_link, joint.direction
    if parent is None or own is None:
        return False
    outside = 0
    for other in parent.child_joints:
        axis, link = other.direction, other.child_link
        is_like = other is not joint and other.type == joint.type and link is not None and link.visuals
        if axis is None or not is_like or other.axis.limit.range != joint.axis.limit.range:
            continue
        if sum(a * b for a, b in zip(own, axis, strict=True)) > ALIKE:
            reach = other.reach
            outside += reach is None or reach.within - reach.opposite < MORE
    return outside > 1

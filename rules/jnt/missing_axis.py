from collections.abc import Iterator

from sdfcheck import IN_MODEL, Bad, Diagnostic, Good, Joint, Rule, Severity

_ENDS = "<parent>base</parent><child>arm</child>"


class MissingAxis(Rule):
    """A joint that moves about or along an axis has none.

    Drake refuses the file. libsdformat accepts it, and Gazebo takes an axis of its own choice
    in silence. Universal joints and those of type revolute2 need two.
    """

    code = "JNT004"
    name = "missing-axis"
    severity = Severity.ERROR
    remedy = """Write the axis that the joint moves about or along, such as `<xyz>0 0 1</xyz>`.

    The axis is in the frame of the joint, of length 1, and points where a positive motion goes: along the
    axis for prismatic joints, by the rule of the right hand for those that turn. Universal and revolute2
    joints need `axis` and `axis2`. A joint without motion is of type fixed.
    """
    looks_at = (Joint,)
    scaffold = IN_MODEL

    bad = (
        Bad(
            f'<link name="arm"/><«joint» name="j" type="revolute">{_ENDS}</joint>',
            says="joint `j` of type revolute has no `axis`",
        ),
        Bad(
            f'<link name="arm"/><«joint» name="j" type="universal">{_ENDS}'
            "<axis><xyz>1 0 0</xyz></axis></joint>",
            says="joint `j` of type universal has no `axis2`",
        ),
        Bad(
            f'<link name="arm"/><«joint» name="j" type="universal">{_ENDS}</joint>',
            says="joint `j` of type universal has no `axis` and no `axis2`",
        ),
    )
    good = (
        Good(f'<link name="arm"/><joint name="j" type="ball">{_ENDS}</joint>', why="turns about all axes"),
        Good(f'<link name="arm"/><joint name="j" type="fixed">{_ENDS}</joint>'),
    )

    @staticmethod
    def applies(joint: Joint) -> bool:
        return not joint.is_urdf and bool(missing(joint))

    def check(self, joint: Joint) -> Iterator[Diagnostic]:
        names = missing(joint)
        lacks = " and no ".join(f"`{name}`" for name in names)
        cause = joint.misnamed(names[0])
        yield self.diagnostic(joint, f"{joint.title} of type {joint.type} has no {lacks}", cause=cause)


def missing(joint: Joint) -> list[str]:
    """The axes that its type needs and nobody wrote."""
    axes = zip(joint.axes, ("axis", "axis2"), strict=False)
    return [name for axis, name in axes if not axis.is_given]

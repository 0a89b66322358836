from collections.abc import Iterator

from sdfcheck import Bad, Diagnostic, Good, Rule, Semantics, Severity, suggest
from sdfcheck_rules.srd.scaffold import FILE, IN_SRDF

JOINT = '<virtual_joint name="v" type="{}" parent_frame="odom" child_link="base"/>'


class UnknownVirtualType(Rule):
    """The type of a virtual joint is not `fixed`, `floating` or `planar`.

    srdfdom takes it for `fixed`: a mobile robot cannot move in its world.
    """

    code = "SRD011"
    name = "unknown-virtual-type"
    severity = Severity.ERROR
    remedy = """Write how the robot can move in the world.

    `fixed` for an arm that is mounted, `planar` for a base that drives, `floating` for what flies or swims.
    """
    looks_at = (Semantics,)
    scaffold = IN_SRDF

    bad = (
        Bad(
            JOINT.format("«planr»"),
            fixed=JOINT.format("planar"),
            unsafe=True,
            file=FILE,
            says="`planr` is not a type of virtual joints",
        ),
    )
    good = (Good(JOINT.format("Planar"), why="srdfdom does not mind capital letters", file=FILE),)

    @staticmethod
    def applies(semantics: Semantics) -> bool:
        return any(True for _ in semantics.unknown_virtual_types)

    def check(self, semantics: Semantics) -> Iterator[Diagnostic]:
        for value in semantics.unknown_virtual_types:
            text = value.text.strip()
            near = suggest(text, ("fixed", "floating", "planar"))
            yield self.diagnostic(
                value, f"`{text}` is not a type of virtual joints, and counts as fixed", meant=near
            )

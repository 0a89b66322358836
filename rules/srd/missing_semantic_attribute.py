from collections.abc import Iterator

from sdfcheck import Bad, Diagnostic, Good, Rule, Semantics, Severity
from sdfcheck_rules.srd.scaffold import FILE, IN_SRDF


class MissingSemanticAttribute(Rule):
    """An element of SRDF lacks an attribute that it needs.

    MoveIt drops the element with a message at start. So it does with a virtual joint of which `parent_frame` is empty.
    """

    code = "SRD003"
    name = "missing-semantic-attribute"
    severity = Severity.ERROR
    remedy = "Write the attribute that the message names."
    looks_at = (Semantics,)
    scaffold = IN_SRDF

    bad = (
        Bad('<«group_state» name="home"/>', file=FILE, says="group_state `home` has no `group`"),
        Bad(
            '<group_state name="home" group="all"><«joint» name="shoulder"/></group_state>',
            file=FILE,
            says="joint `shoulder` has no `value`",
        ),
        Bad(
            '<«virtual_joint» name="v" type="fixed" parent_frame="" child_link="base"/>',
            file=FILE,
            says="virtual_joint `v` has no `parent_frame`",
        ),
    )
    good = (
        Good('<disable_collisions link1="base" link2="upper"/>', why="a reason is not needed", file=FILE),
    )

    @staticmethod
    def applies(semantics: Semantics) -> bool:
        return any(True for _ in semantics.lacking)

    def check(self, semantics: Semantics) -> Iterator[Diagnostic]:
        for element, name in semantics.lacking:
            yield self.diagnostic(element, f"{element.title} has no `{name}`")

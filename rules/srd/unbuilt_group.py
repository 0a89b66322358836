from collections.abc import Iterator

from sdfcheck import Bad, Diagnostic, Good, Rule, Semantics, Severity
from sdfcheck_rules.srd.scaffold import FILE, IN_SRDF


class UnbuiltGroup(Rule):
    """A group is empty, or a part of itself.

    MoveIt leaves it out, with every group that it is a part of: they are not in the list of groups to plan for, and a
    program that asks for them fails. So does a chain that begins and ends at one link, which has no joints.
    """

    code = "SRD017"
    name = "unbuilt-group"
    severity = Severity.WARNING
    remedy = """Give the group its joints, links, a chain, or other groups, or remove it.

    Of groups that have each other as a part, one has to name its joints itself.
    """
    looks_at = (Semantics,)
    scaffold = IN_SRDF

    bad = (
        Bad('<group name="«tool»"/>', file=FILE, says="group `tool` has no joints, and MoveIt leaves it out"),
        Bad('<group name="«tool»"><chain base_link="hand" tip_link="hand"/></group>', file=FILE),
        Bad(
            '<group name="«a»"><group name="b"/></group><group name="b"><group name="a"/></group>',
            file=FILE,
            says="group `a` is a part of itself, and MoveIt leaves it out",
        ),
    )
    good = (
        Good('<group name="tool"><link name="hand"/></group>', file=FILE),
        Good(
            '<group name="a"><group name="b"/></group><group name="b"><group name="all"/></group>', file=FILE
        ),
    )

    @staticmethod
    def applies(semantics: Semantics) -> bool:
        return any(True for _ in semantics.unbuilt_groups)

    def check(self, semantics: Semantics) -> Iterator[Diagnostic]:
        for value, why in semantics.unbuilt_groups:
            yield self.diagnostic(value, f"group `{value.text.strip()}` {why}, and MoveIt leaves it out")

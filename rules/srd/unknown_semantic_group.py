from collections.abc import Iterator

from sdfcheck import Bad, Diagnostic, Good, Rule, Semantics, Severity, suggest
from sdfcheck_rules.srd.scaffold import FILE, IN_SRDF


class UnknownSemanticGroup(Rule):
    """SRDF names a group that it does not define.

    MoveIt drops the state or end effector, and a group with such a part as a whole, with all that refer to it.
    A file without any group is for Pinocchio, which reads its states anyway: a warning.
    """

    code = "SRD002"
    name = "unknown-semantic-group"
    severity = Severity.ERROR
    remedy = 'Name a group that the file defines, or define it with `<group name="…">`.'
    looks_at = (Semantics,)
    scaffold = IN_SRDF

    bad = (
        Bad(
            '<group_state name="home" group="«al»"><joint name="shoulder" value="0"/></group_state>',
            file=FILE,
            says="there is no group `al`",
        ),
        Bad(
            '<end_effector name="e" group="«hand»" parent_link="upper"/>',
            file=FILE,
            says="there is no group `hand`",
        ),
        Bad('<group name="more"><group name="«nothing»"/></group>', file=FILE),
    )
    good = (
        Good('<group name="more"><group name="all"/></group>', file=FILE),
        Good(
            '<end_effector name="e" group="all" parent_link="upper" parent_group=""/>',
            why="MoveIt looks for a parent group itself",
            file=FILE,
        ),
    )

    @staticmethod
    def applies(semantics: Semantics) -> bool:
        return any(True for _ in semantics.unknown_groups)

    def check(self, semantics: Semantics) -> Iterator[Diagnostic]:
        for value in semantics.unknown_groups:
            near = suggest(value.text.strip(), semantics.groups)
            severity = None if semantics.groups else Severity.WARNING
            message = f"there is no group `{value.text.strip()}`"
            yield self.diagnostic(value, message, meant=near, severity=severity)

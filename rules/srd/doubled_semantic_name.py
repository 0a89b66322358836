from collections.abc import Iterator

from sdfcheck import Bad, Diagnostic, Good, Rule, Semantics, Severity
from sdfcheck_rules.srd.scaffold import FILE, IN_SRDF


class DoubledSemanticName(Rule):
    """Two groups, end effectors or states of a group have one name.

    MoveIt takes the first and warns about the other.
    """

    code = "SRD004"
    name = "doubled-semantic-name"
    severity = Severity.WARNING
    remedy = "Rename or remove one of them; the first one is in effect."
    looks_at = (Semantics,)
    scaffold = IN_SRDF

    bad = (
        Bad(
            '<group name="«all»"><link name="hand"/></group>', file=FILE, says="there is another group `all`"
        ),
    )
    good = (
        Good(
            '<group name="more"><link name="hand"/></group><group_state name="home" group="all"/>'
            '<group_state name="home" group="more"/>',
            why="of different groups",
            file=FILE,
        ),
    )

    @staticmethod
    def applies(semantics: Semantics) -> bool:
        return any(True for _ in semantics.doubled)

    def check(self, semantics: Semantics) -> Iterator[Diagnostic]:
        for value, first in semantics.doubled:
            message = f"there is another {value.element.name} `{value.text.strip()}`"
            yield self.diagnostic(value, message, labels={first: "the first one"})

from collections.abc import Iterator

from sdfcheck import Bad, Diagnostic, Good, Severity, VendorRule, VendorTag
from sdfcheck_rules.drk.scaffolds import MODEL

BALL = (
    "<drake:ball_constraint><drake:ball_constraint_body_A>a</drake:ball_constraint_body_A>"
    "<drake:ball_constraint_body_B>{}</drake:ball_constraint_body_B>"
    "<drake:ball_constraint_p_AP>0 0 0</drake:ball_constraint_p_AP>"
    "<drake:ball_constraint_p_BQ>0 0 0</drake:ball_constraint_p_BQ></drake:ball_constraint>"
)


class SelfTiedConstraint(VendorRule):
    """A constraint ties a link to itself.

    Drake wants the two bodies of a ball or distance constraint to be distinct.
    """

    code = "DRK021"
    name = "self-tied-constraint"
    severity = Severity.ERROR
    remedy = "Name two different links as the ends of the constraint."
    prefix = "drake"
    looks_at = (VendorTag,)
    scaffold = MODEL.replace("{}", BALL)

    bad = (Bad("«a»", says="both ends are `a`: Drake refuses the file"),)
    good = (Good("b"),)

    @staticmethod
    def applies(tag: VendorTag) -> bool:
        return tag.prefix == "drake" and tag.tied is not None

    def check(self, tag: VendorTag) -> Iterator[Diagnostic]:
        if tag.tied is not None:
            one, other = tag.tied
            message = f"both ends are `{one.text.strip()}`"
            yield self.report(tag, message, self.refused, at=one, labels={other: "the other end"})

from collections.abc import Iterator

from sdfcheck import Bad, Diagnostic, Good, Severity, VendorRule, VendorTag
from sdfcheck_rules.drk.scaffolds import BOX, COLLISION, ROBOT_LINK


class OutdatedDrakeTag(VendorRule):
    """One of Drake's elements has gone, or has a standard successor.

    Drake no longer reads `drake:soft_hydroelastic` and `drake:elastic_modulus`. Since SDFormat 1.8 there
    are a standard `capsule` and `ellipsoid`, which other consumers understand, too.
    """

    code = "DRK017"
    name = "outdated-drake-tag"
    severity = Severity.ERROR
    remedy = """Use the successor that the message names.

    A file for SDFormat 1.8 or later takes the standard `<capsule>` and `<ellipsoid>`.
    """
    prefix = "drake"
    looks_at = (VendorTag,)
    scaffold = BOX

    bad = (
        Bad(
            "<«drake:soft_hydroelastic»/>",
            fixed="<drake:compliant_hydroelastic/>",
            unsafe=True,
            says="is now `drake:compliant_hydroelastic`: Drake refuses the file",
        ),
        Bad(
            "<geometry><«drake:capsule»><radius>1</radius><length>1</length></drake:capsule></geometry>",
            says="is older than the standard `capsule`",
            scaffold=COLLISION,
        ),
    )
    good = (
        Good("<drake:compliant_hydroelastic/><drake:hydroelastic_modulus>1</drake:hydroelastic_modulus>"),
        Good(
            '<collision><geometry><drake:capsule radius="1" length="1"/></geometry></collision>',
            scaffold=ROBOT_LINK,
            why="URDF has no other that everybody knows",
        ),
    )

    @staticmethod
    def applies(tag: VendorTag) -> bool:
        return tag.prefix == "drake" and bool(tag.successor)

    def check(self, tag: VendorTag) -> Iterator[Diagnostic]:
        yield self.outdated(tag)

from collections.abc import Iterator

from sdfcheck import Bad, Diagnostic, Good, Severity, VendorRule, VendorTag
from sdfcheck_rules.vnd.acme import GRIPPER, MODEL, TABLE


class ConflictingVendorTags(VendorRule):
    """Elements of a vendor exclude each other, or one of them needs another.

    The table of the vendor, which a pack brings, says which.
    """

    code = "VND008"
    name = "conflicting-vendor-tags"
    severity = Severity.ERROR
    remedy = "Keep one of two that exclude each other; write the one that is needed."
    looks_at = (VendorTag,)
    scaffold = MODEL

    bad = (
        Bad(
            GRIPPER.replace("{}", "<«acme:grip»>soft</acme:grip><acme:force>2</acme:force>"),
            says="`acme:grip` and `acme:force` exclude each other: Acme refuses the file",
            files=TABLE,
        ),
    )
    good = (Good(GRIPPER.replace("{}", "<acme:force>2</acme:force>"), files=TABLE),)

    @staticmethod
    def applies(tag: VendorTag) -> bool:
        if tag.vendor.has_own_rules:
            return False
        return bool(tag.excluded or tag.idle_beside or tag.forbidden or tag.needs)

    def check(self, tag: VendorTag) -> Iterator[Diagnostic]:
        yield from self.conflicting(tag)

from collections.abc import Iterator

from sdfcheck import Bad, Diagnostic, Good, Severity, VendorRule, VendorTag
from sdfcheck_rules.vnd.acme import GRIPPER, MODEL, TABLE


class MissingVendorPart(VendorRule):
    """An element of a vendor lacks a child or an attribute that the table of the vendor asks for.

    The vendor's program, of which a pack brings the table, has no default for it.
    """

    code = "VND004"
    name = "missing-vendor-part"
    severity = Severity.ERROR
    remedy = "Write the missing part. If the whole element is not needed, remove it."
    looks_at = (VendorTag,)
    scaffold = MODEL

    bad = (
        Bad('<«acme:gripper» name="g"/>', says="acme:gripper `g` lacks `acme:finger`", files=TABLE),
        Bad(
            "<«acme:gripper»><acme:finger>a</acme:finger></acme:gripper>",
            says="lacks the attribute `name`",
            files=TABLE,
        ),
    )
    good = (Good(GRIPPER.replace("{}", ""), files=TABLE),)

    @staticmethod
    def applies(tag: VendorTag) -> bool:
        if tag.vendor.has_own_rules:
            return False
        return bool(tag.missing_values) or any(lack.misspelled is None for lack in tag.lacks)

    def check(self, tag: VendorTag) -> Iterator[Diagnostic]:
        yield from self.lacking_children(tag)
        yield from self.lacking_values(tag)

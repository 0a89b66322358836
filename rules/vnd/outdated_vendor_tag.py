from collections.abc import Iterator

from sdfcheck import Bad, Diagnostic, Good, Severity, VendorRule, VendorTag
from sdfcheck_rules.vnd.acme import MODEL, TABLE


class OutdatedVendorTag(VendorRule):
    """An element of a vendor has another name now, or a standard element takes its place.

    The table of the vendor, which a pack brings, names what to write instead.
    """

    code = "VND007"
    name = "outdated-vendor-tag"
    severity = Severity.ERROR
    remedy = "Write what the message names."
    looks_at = (VendorTag,)
    scaffold = MODEL

    bad = (
        Bad(
            "<«acme:buffer»/>",
            fixed="<acme:bumper/>",
            unsafe=True,
            says="`acme:buffer` is now `acme:bumper`: Acme ignores it",
            files=TABLE,
        ),
    )
    good = (Good("<acme:bumper/>", files=TABLE),)

    @staticmethod
    def applies(tag: VendorTag) -> bool:
        return not tag.vendor.has_own_rules and bool(tag.successor)

    def check(self, tag: VendorTag) -> Iterator[Diagnostic]:
        yield self.outdated(tag)

from collections.abc import Iterator

from sdfcheck import Bad, Diagnostic, Good, Severity, VendorRule, VendorValue
from sdfcheck_rules.vnd.acme import GRIPPER, MODEL, TABLE


class UnknownVendorReference(VendorRule):
    """An element of a vendor names a link, joint or frame that is not there.

    The table of the vendor, which a pack brings, says what each value names.
    """

    code = "VND006"
    name = "unknown-vendor-reference"
    severity = Severity.ERROR
    remedy = "Write a name that is there."
    looks_at = (VendorValue,)
    scaffold = MODEL

    bad = (
        Bad(
            GRIPPER.replace("{}", "<acme:finger>«B»</acme:finger>"),
            fixed=GRIPPER.replace("{}", "<acme:finger>b</acme:finger>"),
            unsafe=True,
            says="there is no link `B`: Acme refuses the file; did you mean `b`?",
            files=TABLE,
        ),
    )
    good = (Good(GRIPPER.replace("{}", "<acme:finger>b</acme:finger>"), files=TABLE),)

    @staticmethod
    def applies(name: VendorValue) -> bool:
        return not name.tag.vendor.has_own_rules and name.unresolved is not None

    def check(self, name: VendorValue) -> Iterator[Diagnostic]:
        yield from self.unresolved(name)

from collections.abc import Iterator

from sdfcheck import Bad, Diagnostic, Good, Severity, VendorRule, VendorTag
from sdfcheck_rules.vnd.acme import GRIPPER, JOINT, MODEL, TABLE


class UnknownVendorTag(VendorRule):
    """An element or attribute with the prefix of a vendor is not in the table of the vendor.

    A pack brings the table, and the table says whether the vendor's program refuses such a file or
    ignores the tag. Without a table, custom elements are free.
    """

    code = "VND001"
    name = "unknown-vendor-tag"
    severity = Severity.ERROR
    remedy = "Write the tag as the table has it, or remove it."
    looks_at = (VendorTag,)
    scaffold = MODEL

    bad = (
        Bad(
            "<«acme:bumpr»/>",
            fixed="<acme:bumper/>",
            unsafe=True,
            says="`acme:bumpr` is not known to Acme: Acme refuses the file; did you mean `acme:bumper`?",
            files=TABLE,
        ),
    )
    good = (
        Good(GRIPPER.replace("{}", ""), files=TABLE),
        Good("<acme:armature>1</acme:armature>", scaffold=JOINT, files=TABLE),
        Good("<acme:bumpr/>", why="there is no table"),
    )

    @staticmethod
    def applies(tag: VendorTag) -> bool:
        return not tag.vendor.has_own_rules and tag.definition is None

    def check(self, tag: VendorTag) -> Iterator[Diagnostic]:
        yield self.unknown(tag)

from collections.abc import Iterator

from sdfcheck import Bad, Diagnostic, Good, Severity, VendorRule, VendorTag, VendorValue
from sdfcheck_rules.vnd.acme import GRIPPER, JOINT, MODEL, TABLE


class RepeatedVendorTag(VendorRule):
    """An element of a vendor is given again where one counts, or two have one name.

    The table of the vendor, which a pack brings, says how often each element may be given.
    """

    code = "VND005"
    name = "repeated-vendor-tag"
    severity = Severity.ERROR
    remedy = "Remove one of the two, or give it another name."
    looks_at = (VendorTag, VendorValue)
    scaffold = MODEL

    bad = (
        Bad(
            "<acme:armature>1</acme:armature><«acme:armature»>2</acme:armature>",
            says="is given again",
            scaffold=JOINT,
            files=TABLE,
        ),
        Bad(
            GRIPPER.replace("{}", "") + GRIPPER.replace("{}", "").replace('"g"', '"«g»"'),
            says="there is a `acme:gripper` of the name `g` already: Acme refuses the file",
            also=("NAM001",),
            files=TABLE,
        ),
    )
    good = (Good(GRIPPER.replace("{}", "<acme:finger>b</acme:finger>"), files=TABLE, why="it may have many"),)

    @staticmethod
    def applies(given: VendorTag | VendorValue) -> bool:
        tag = given.tag if isinstance(given, VendorValue) else given
        return given.first is not None and not tag.vendor.has_own_rules

    def check(self, given: VendorTag | VendorValue) -> Iterator[Diagnostic]:
        yield from self.repeated(given)

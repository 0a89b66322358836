from collections.abc import Iterator

from sdfcheck import Bad, Diagnostic, Good, Severity, VendorRule, VendorTag, VendorValue
from sdfcheck_rules.vnd.acme import GRIPPER, JOINT, MODEL, ROBOT, TABLE


class MalformedVendorValue(VendorRule):
    """The value of a vendor's element or attribute is not what the table of the vendor asks for.

    It is not of its type, not one of the choices, out of its range, or not where it is read. The table,
    which a pack brings, says what the vendor's program does then.
    """

    code = "VND003"
    name = "malformed-vendor-value"
    severity = Severity.ERROR
    remedy = "Write the value where it is read, as the type and in the range of the table."
    looks_at = (VendorTag, VendorValue)
    scaffold = JOINT

    bad = (
        Bad(
            "<acme:armature>«much»</acme:armature>",
            says="should be a number, not `much`: Acme reads `0`",
            files=TABLE,
        ),
        Bad("<acme:armature>«-0.1»</acme:armature>", says="should be at least 0, not `-0.1`", files=TABLE),
        Bad(
            '<dynamics damping="1" friction="0" acme:armature="«much»"/>',
            says="Acme refuses the file",
            scaffold=ROBOT,
            files=TABLE,
        ),
        Bad(
            GRIPPER.replace("{}", "<acme:grip>«sof»</acme:grip>"),
            fixed=GRIPPER.replace("{}", "<acme:grip>soft</acme:grip>"),
            unsafe=True,
            says="cannot be `sof`: Acme refuses the file; did you mean `soft`?",
            scaffold=MODEL,
            files=TABLE,
        ),
        Bad("<«acme:armature»/>", says="`acme:armature` is empty", files=TABLE),
    )
    good = (
        Good("<acme:armature> 1e-1 </acme:armature>", files=TABLE),
        Good(GRIPPER.replace("{}", "<acme:grip>hard</acme:grip>"), scaffold=MODEL, files=TABLE),
    )

    @staticmethod
    def applies(given: VendorTag | VendorValue) -> bool:
        if isinstance(given, VendorTag):
            is_empty = given.is_empty and (given.stray is not None or given.lacks_text)
            return is_empty and not given.vendor.has_own_rules
        is_odd = given.misreading is not None or given.is_unknown_choice or given.bound is not None
        return is_odd and not given.tag.vendor.has_own_rules

    def check(self, given: VendorTag | VendorValue) -> Iterator[Diagnostic]:
        if isinstance(given, VendorTag) or given.misreading is not None or given.is_unknown_choice:
            yield self.malformed(given)
        else:
            yield self.out_of_range(given)

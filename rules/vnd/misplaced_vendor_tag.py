from collections.abc import Iterator

from sdfcheck import Bad, Diagnostic, Good, Severity, VendorRule, VendorTag
from sdfcheck_rules.vnd.acme import JOINT, MODEL, ROBOT, TABLE


class MisplacedVendorTag(VendorRule):
    """An element or attribute of a vendor is where the vendor's program does not look for it.

    The table of the vendor, which a pack brings, lists the places in SDFormat and in URDF.
    """

    code = "VND002"
    name = "misplaced-vendor-tag"
    severity = Severity.ERROR
    remedy = "Move it to the place that the table names."
    looks_at = (VendorTag,)
    scaffold = MODEL

    bad = (
        Bad(
            "<«acme:armature»>1</acme:armature>",
            says="does not belong in model `m`: Acme refuses the file; it goes into `model/joint/axis/dynamics`",
            files=TABLE,
        ),
        Bad(
            '<dynamics damping="1" friction="0"><«acme:armature»/></dynamics>',
            says="Acme ignores it; it goes into `robot/joint/dynamics/@acme:armature`",
            scaffold=ROBOT,
            files=TABLE,
        ),
    )
    good = (
        Good("<acme:armature>1</acme:armature>", scaffold=JOINT, files=TABLE),
        Good('<dynamics damping="1" friction="0" acme:armature="1"/>', scaffold=ROBOT, files=TABLE),
    )

    @staticmethod
    def applies(tag: VendorTag) -> bool:
        if tag.vendor.has_own_rules or tag.definition is None or tag.is_gone:
            return False
        return tag.place is None and not tag.is_undecided

    def check(self, tag: VendorTag) -> Iterator[Diagnostic]:
        yield self.misplaced(tag)

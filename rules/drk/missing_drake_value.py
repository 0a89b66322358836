from collections.abc import Iterator

from sdfcheck import Bad, Diagnostic, Good, Severity, VendorRule, VendorTag
from sdfcheck_rules.drk.scaffolds import COLLISION, JOINT, MODEL, ROBOT


class MissingDrakeValue(VendorRule):
    """One of Drake's elements lacks the attribute or plain child that holds its value.

    Which it is differs between the formats: a `drake:capsule` has children `radius` and `length` in SDF, and
    attributes in URDF.
    """

    code = "DRK020"
    name = "missing-drake-value"
    severity = Severity.ERROR
    remedy = """Write the value as this format has it: an attribute in URDF, mostly a child in SDF.

    `sdfcheck describe drake:NAME` shows which one.
    """
    prefix = "drake"
    looks_at = (VendorTag,)
    scaffold = JOINT

    bad = (
        Bad('<«drake:controller_gains» p="1"/>', says="lacks the attribute `d`: Drake refuses the file"),
        Bad('<«drake:mimic» jiont="j" multiplier="1" offset="0"/>', says="is `jiont` meant for it?"),
        Bad(
            "<geometry><«drake:ellipsoid»><a>1</a><b>1</b></drake:ellipsoid></geometry>",
            says="lacks the child `c`",
            scaffold=COLLISION,
        ),
        Bad(
            '<drake:collision_filter_group name="g"><«drake:member»/></drake:collision_filter_group>',
            says="lacks the attribute `link`",
            scaffold=ROBOT,
        ),
    )
    good = (
        Good('<drake:controller_gains p="1" d="0"/>'),
        Good(
            '<drake:collision_filter_group name="g"><drake:member>a</drake:member>'
            "</drake:collision_filter_group>",
            scaffold=MODEL,
        ),
    )

    @staticmethod
    def applies(tag: VendorTag) -> bool:
        return tag.prefix == "drake" and bool(tag.missing_values)

    def check(self, tag: VendorTag) -> Iterator[Diagnostic]:
        yield from self.lacking_values(tag)

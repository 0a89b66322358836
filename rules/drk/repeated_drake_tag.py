from collections.abc import Iterator

from sdfcheck import Bad, Diagnostic, Good, Severity, VendorRule, VendorTag, VendorValue
from sdfcheck_rules.drk.scaffolds import BOX, JOINT, MODEL, ROBOT


class RepeatedDrakeTag(VendorRule):
    """One of Drake's elements is given again where one counts.

    Drake reads the first and does not look at the others, not even to find them broken.
    """

    code = "DRK016"
    name = "repeated-drake-tag"
    severity = Severity.WARNING
    remedy = """Remove one of them; two groups need two names.

    The first one is in effect. In URDF and SDF alike, all members of one group are listed in one element.
    """
    prefix = "drake"
    looks_at = (VendorTag, VendorValue)
    scaffold = BOX

    bad = (
        Bad(
            "<drake:mu_dynamic>1</drake:mu_dynamic><«drake:mu_dynamic»>2</drake:mu_dynamic>",
            says="is given again: Drake reads the first only",
        ),
        Bad(
            '<drake:collision_filter_group name="g"><drake:member link="a"/></drake:collision_filter_group>'
            '<drake:collision_filter_group name="«g»"><drake:member link="b"/>'
            "</drake:collision_filter_group>",
            says="of the name `g` already: Drake refuses the file",
            scaffold=ROBOT,
        ),
    )
    good = (
        Good(
            '<drake:collision_filter_group name="g"><drake:member>a</drake:member>'
            "<drake:member>b</drake:member>"
            "</drake:collision_filter_group>",
            scaffold=MODEL,
        ),
        Good("<drake:rotor_inertia>1</drake:rotor_inertia>", scaffold=JOINT),
    )

    @staticmethod
    def applies(given: VendorTag | VendorValue) -> bool:
        return given.prefix == "drake" and given.first is not None

    def check(self, given: VendorTag | VendorValue) -> Iterator[Diagnostic]:
        yield from self.repeated(given)

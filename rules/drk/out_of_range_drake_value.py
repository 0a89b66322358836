from collections.abc import Iterator

from sdfcheck import Bad, Diagnostic, Good, Severity, VendorRule, VendorTag, VendorValue
from sdfcheck_rules.drk.effect import above
from sdfcheck_rules.drk.scaffolds import AXIS, BOX, JOINT, MODEL

TENDON = (
    '<joint name="j" type="revolute"><parent>a</parent><child>b</child><axis><xyz>0 0 1</xyz></axis></joint>'
    '<drake:tendon_constraint><drake:tendon_constraint_joint name="j" a="1"/>'
    "<drake:tendon_constraint_offset>0</drake:tendon_constraint_offset>"
    "<drake:tendon_constraint_stiffness>1</drake:tendon_constraint_stiffness>"
    "<drake:tendon_constraint_damping>0</drake:tendon_constraint_damping>{}</drake:tendon_constraint>"
)


class OutOfRangeDrakeValue(VendorRule):
    """The value of one of Drake's elements is outside the range that makes sense.

    Drake refuses most of them; some run into an assertion, which names no place in the file
    and ends a C++ program. A negative rotor inertia or gear ratio it takes.
    """

    code = "DRK019"
    name = "out-of-range-drake-value"
    severity = Severity.ERROR
    remedy = """Write a value within the range that the message names.

    `sdfcheck describe drake:NAME` shows range and unit. Lower limits come before upper ones.
    """
    prefix = "drake"
    looks_at = (VendorTag, VendorValue)
    scaffold = BOX

    bad = (
        Bad(
            "<drake:mu_dynamic>«-1»</drake:mu_dynamic>", says="should be at least 0, not `-1`: Drake refuses"
        ),
        Bad("<limit><drake:acceleration>«-3»</drake:acceleration></limit>", scaffold=AXIS),
        Bad('<drake:controller_gains p="«-1»" d="1"/>', says="Drake aborts", scaffold=JOINT),
        Bad("<drake:rotor_inertia>«-1»</drake:rotor_inertia>", says="Drake takes it anyway", scaffold=JOINT),
        Bad(
            "<drake:tendon_constraint_lower_limit>«2»</drake:tendon_constraint_lower_limit>"
            "<drake:tendon_constraint_upper_limit>1</drake:tendon_constraint_upper_limit>",
            says="is 2 and above `drake:tendon_constraint_upper_limit`, 1: Drake aborts",
            scaffold=MODEL.replace("{}", TENDON),
        ),
    )
    good = (
        Good("<drake:mesh_resolution_hint>-1</drake:mesh_resolution_hint>", why="nothing is meshed"),
        Good("<limit><drake:acceleration>inf</drake:acceleration></limit>", scaffold=AXIS),
    )

    @staticmethod
    def applies(given: VendorTag | VendorValue) -> bool:
        if given.prefix != "drake":
            return False
        if isinstance(given, VendorTag):
            return given.excess is not None and "mu_" not in given.name  # mu-order is about frictions
        return given.bound is not None

    def check(self, given: VendorTag | VendorValue) -> Iterator[Diagnostic]:
        if isinstance(given, VendorValue):
            yield self.out_of_range(given)
        elif (excess := given.excess) is not None:
            message = above(given.name, excess.low, excess.high)
            labels = {excess.high: "the value that it must not exceed"}
            yield self.report(given, message, excess.effect, at=excess.low, labels=labels)

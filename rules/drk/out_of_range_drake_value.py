from typing import Any

from sdfcheck import Bad, Consumer, Good, Severity, VendorRule, problems, refuses
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
    affects = {Consumer.DRAKE: refuses("refuses the file, or aborts")}
    prefix = "drake"
    explains = (problems.TagOutOfRange, problems.UnorderedTags)
    scaffold = BOX

    bad = (
        Bad(
            "<drake:mu_dynamic>«-1»</drake:mu_dynamic>", says="should be at least 0, not `-1`: Drake refuses"
        ),
        Bad("<limit><drake:acceleration>«-3»</drake:acceleration></limit>", scaffold=AXIS),
        Bad('<drake:controller_gains p="«-1»" d="1"/>', says="Drake aborts", scaffold=JOINT),
        Bad(
            "<drake:rotor_inertia>«-1»</drake:rotor_inertia>",
            says="Drake takes it all the same",
            scaffold=JOINT,
        ),
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

    def is_about(self, problem: Any) -> bool:
        """The order of frictions is not this rule's."""
        return not isinstance(problem, problems.UnorderedTags) or "mu_" not in problem.name

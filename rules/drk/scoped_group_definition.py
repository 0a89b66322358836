from sdfcheck import REFUSES, Bad, Consumer, Good, Severity, VendorRule, problems
from sdfcheck_rules.drk.scaffolds import MODEL


class ScopedGroupDefinition(VendorRule):
    """A collision filter group is defined under a scoped name.

    A group belongs to the model that it stands in. Scoped names are for referring to
    links and groups of nested models, never for defining something there.
    """

    code = "DRK006"
    name = "scoped-group-definition"
    severity = Severity.ERROR
    affects = {Consumer.DRAKE: REFUSES}
    prefix = "drake"
    explains = (problems.ScopedTagName,)
    scaffold = MODEL

    bad = (
        Bad(
            '<drake:collision_filter_group name="«arm::g»"><drake:member>a</drake:member>'
            "</drake:collision_filter_group>",
            says="cannot be defined under a scoped name",
        ),
    )
    good = (
        Good(
            '<drake:collision_filter_group name="arm:g"><drake:member>a</drake:member>'
            "</drake:collision_filter_group>",
            why="one colon parts nothing",
        ),
    )

from collections.abc import Iterator

from sdfcheck import Bad, Diagnostic, Good, Severity, VendorRule, VendorValue
from sdfcheck_rules.drk.scaffolds import MODEL


class ScopedGroupDefinition(VendorRule):
    """A collision filter group is defined under a scoped name.

    A group belongs to the model that it is in. Scoped names are for referring to
    links and groups of nested models, never for defining something there.
    """

    code = "DRK006"
    name = "scoped-group-definition"
    severity = Severity.ERROR
    remedy = """Define the group in the model that it belongs to, under a plain name.

    From outside, name its members by scoped names instead: `<drake:member>arm::hand</drake:member>`.
    """
    prefix = "drake"
    looks_at = (VendorValue,)
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

    @staticmethod
    def applies(name: VendorValue) -> bool:
        return name.prefix == "drake" and name.is_definition and "::" in name.text

    def check(self, name: VendorValue) -> Iterator[Diagnostic]:
        if (effect := name.slot.plain) is not None:
            yield self.report(name, f"a `{name.tag.name}` cannot be defined under a scoped name", effect)

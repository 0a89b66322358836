from collections.abc import Iterator

from sdfcheck import Bad, Diagnostic, Good, Severity, VendorRule, VendorTag
from sdfcheck_rules.drk.scaffolds import LINK, MODEL, ROBOT


class UnknownDrakeTag(VendorRule):
    """An element or attribute with the prefix `drake:` is unknown to Drake.

    In most parents of an SDF file Drake refuses what it does not know in its own
    prefix. In URDF files, and in some parents in SDF (`axis`, `inertial`, `mesh`, …), it
    ignores it in silence: the misspelled setting has no effect.
    """

    code = "DRK001"
    name = "unknown-drake-tag"
    severity = Severity.ERROR
    remedy = """Write the tag as Drake knows it, or remove it.

    `sdfcheck describe drake:NAME` and Drake's page "Model description parsing" list them. An element of
    your own needs another prefix.
    """
    prefix = "drake"
    looks_at = (VendorTag,)
    scaffold = MODEL

    bad = (
        Bad(
            '<«drake:colision_filter_group» name="g"/>',
            fixed='<drake:collision_filter_group name="g"/>',
            unsafe=True,
            says="Drake refuses the file; did you mean `drake:collision_filter_group`?",
        ),
        Bad("<«drake:spaceship»/>", says="`drake:spaceship` is not known to Drake", scaffold=ROBOT),
        Bad(
            '<drake:visual name="v"><drake:geometry><«sphere»><drake:radius>1</drake:radius></sphere>'
            "</drake:geometry></drake:visual>",
            fixed='<drake:visual name="v"><drake:geometry><drake:sphere><drake:radius>1</drake:radius></drake:sphere>'
            "</drake:geometry></drake:visual>",
            unsafe=True,
            says="`sphere` has no prefix",
            scaffold=LINK,
        ),
        Bad('<pose «drake:frame»="b">0 0 0 0 0 0</pose>', says="Drake ignores it", scaffold=LINK),
    )
    good = (
        Good(
            '<drake:visual name="v"><drake:geometry><drake:sphere><drake:radius>1</drake:radius>'
            "</drake:sphere>"
            "</drake:geometry></drake:visual>",
            scaffold=LINK,
            why="inside drake:visual everything has the prefix",
        ),
        Good('<p:spaceship xmlns:p="https://example.org/p"/>', why="another vendor's"),
        Good('<plugin name="p" filename="p"><drake:spaceship/></plugin>', why="plugins hold what they like"),
    )

    @staticmethod
    def applies(tag: VendorTag) -> bool:
        return tag.prefix == "drake" and tag.definition is None

    def check(self, tag: VendorTag) -> Iterator[Diagnostic]:
        yield self.unknown(tag)

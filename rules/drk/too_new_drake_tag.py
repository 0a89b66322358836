from collections.abc import Iterator

from sdfcheck import Bad, Diagnostic, Good, Severity, VendorRule, VendorTag, used
from sdfcheck_rules.drk.scaffolds import LINK, ROBOT_LINK


class TooNewDrakeTag(VendorRule):
    """An element is as new as the newest release of Drake.

    An SDF file with it is refused by every older release; in a URDF file older releases
    ignore it.
    """

    code = "DRK018"
    name = "too-new-drake-tag"
    severity = Severity.INFO
    remedy = """Ask for this release of Drake where the file is used, or do without the element.

    Pin the version of `drake` in the requirements of the project. For older releases, set the property in
    the program instead.
    """
    prefix = "drake"
    looks_at = (VendorTag,)
    scaffold = LINK

    bad = (
        Bad(
            "<«drake:surface_velocity_axis»>0 0 1</drake:surface_velocity_axis>",
            says="came with Drake 1.56: an older Drake refuses the file",
        ),
        Bad(
            '<«drake:surface_velocity_axis» axis="0 0 1"/>',
            says="an older Drake ignores it",
            scaffold=ROBOT_LINK,
        ),
    )
    good = (Good('<drake:visual name="v"><drake:geometry/></drake:visual>', why="read for years"),)

    @staticmethod
    def applies(tag: VendorTag) -> bool:
        return tag.prefix == "drake" and tag.alike[:1] == [tag] and tag.is_too_new

    def check(self, tag: VendorTag) -> Iterator[Diagnostic]:
        does = "refuses the file" if tag.document.kind.value == "sdf" else "ignores it"
        message = f"`{tag.name}`{used(len(tag.alike))} came with Drake {tag.since}: an older Drake {does}"
        yield self.diagnostic(tag, message)

from collections.abc import Iterator

from sdfcheck import Bad, Diagnostic, Good, Severity, VendorRule, VendorTag
from sdfcheck_rules.drk.scaffolds import AXIS, JOINT, LINK, ROBOT, ROBOT_LINK


class MisplacedDrakeTag(VendorRule):
    """One of Drake's elements is where Drake does not look for it.

    Drake reads each of its elements in few places, and not in the same ones in SDF and in
    URDF; some exist in one of the formats only. Elsewhere it refuses the file (in most
    parents of SDF) or ignores the element.
    """

    code = "DRK002"
    name = "misplaced-drake-tag"
    severity = Severity.ERROR
    remedy = """Move it to the place where Drake reads it, or write the standard element that the message names.

    `sdfcheck describe drake:NAME` lists the places in SDF and in URDF.
    """
    prefix = "drake"
    looks_at = (VendorTag,)
    scaffold = LINK

    bad = (
        Bad(
            "<«drake:proximity_properties»/>",
            says="does not belong in link `a`: Drake refuses the file; it goes into `model/link/collision`",
        ),
        Bad(
            '<«drake:rotor_inertia» value="1"/>',
            says="Drake ignores it; it goes into `robot/transmission/actuator`",
            scaffold=ROBOT_LINK,
        ),
        Bad(
            "<«drake:screw_thread_pitch»>1</drake:screw_thread_pitch>",
            says="is for URDF: in SDF Drake refuses the file; use `joint/screw_thread_pitch`",
            scaffold=JOINT,
        ),
        Bad(
            '<link name="c"><inertial><mass value="1"/>'
            '<inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/>'
            '</inertial></link><joint name="k" type="fixed"><parent link="a"/><child link="c"/>'
            '<«drake:mimic» joint="j" multiplier="1" offset="0"/></joint>',
            says="is for SDF: in URDF Drake ignores it; use `joint/mimic`",
            scaffold=ROBOT,
        ),
        Bad(
            "<limit><«drake:acceleration»>1</drake:acceleration></limit>",
            says="is read only in `model/joint[type=continuous,prismatic,revolute]/axis/limit`",
            scaffold=AXIS.replace("revolute", "screw"),
        ),
    )
    good = (
        Good("<limit><drake:acceleration>1</drake:acceleration></limit>", scaffold=AXIS),
        Good("<drake:rotor_inertia>1</drake:rotor_inertia>", scaffold=JOINT),
    )

    @staticmethod
    def applies(tag: VendorTag) -> bool:
        if tag.prefix != "drake" or tag.definition is None or tag.is_gone:
            return False
        return tag.place is None and not tag.is_undecided

    def check(self, tag: VendorTag) -> Iterator[Diagnostic]:
        yield self.misplaced(tag)

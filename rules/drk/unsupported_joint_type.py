from collections.abc import Iterator

from sdfcheck import (
    REFUSES,
    Bad,
    Consumer,
    Diagnostic,
    Good,
    Joint,
    Reaction,
    Severity,
    VendorRule,
    VendorValue,
    accepts,
)
from sdfcheck_rules.drk.effect import IGNORES, affects, does, severity
from sdfcheck_rules.drk.scaffolds import JOINT, MODEL, ROBOT, ROBOT_JOINT

REFUSED_IN_SDF = {"gearbox": "", "revolute2": "two revolute joints"}
"""Type → what to write instead."""
OWN_IN_URDF = frozenset(("ball", "curvilinear", "screw", "universal"))
"""The types that are written as `drake:joint` there."""

ENDS = '<parent link="a"/><child link="b"/>'

UNREAD_BY_PYBULLET = (Consumer.PYBULLET.value, accepts("does not read it"))
"""It warns of a joint of such a type, and not of a `drake:joint`."""


class UnsupportedJointType(VendorRule):
    """A joint is of a type that Drake does not have, or does not have in this spelling.

    In SDF Drake knows the standard types but gearbox and revolute2, and planar and
    curvilinear as `drake:joint`; a joint of a world, or of a static model, must be fixed. In URDF
    ball, screw, universal and curvilinear are types of `drake:joint`, and the standard ones of `joint`; a
    floating joint is left out, with its link free. Plain joints are judged with `--target drake` only.
    """

    code = "DRK008"
    name = "unsupported-joint-type"
    severity = Severity.ERROR
    remedy = """Use a type that Drake has, in the spelling that it has in this format.

    A gearbox is a `mimic`, a revolute2 joint two revolute ones with a light link between them. In URDF,
    `<drake:joint type="ball">` and the like are Drake's spelling of types that URDF lacks; other consumers
    ignore them.
    """
    prefix = "drake"
    looks_at = (Joint, VendorValue)
    selects = ("sdf:joint", "urdf:robot/joint")
    scaffold = ROBOT_JOINT

    bad = (
        Bad(
            f'<drake:joint name="j" type="«revolute»">{ENDS}</drake:joint>',
            says="`type` of `drake:joint` cannot be `revolute`: Drake refuses the file",
            also=("URD004",),
        ),
        Bad(
            '<joint name="j" type="«gearbox»"><parent>a</parent><child>b</child>'
            "<axis><xyz>0 0 1</xyz></axis><gearbox_reference_body>a</gearbox_reference_body></joint>",
            says="a joint of type `gearbox` is not supported: Drake refuses the file",
            also=("JNT004",),
            scaffold=MODEL,
        ),
        Bad(
            f'<joint name="j" type="«screw»">{ENDS}</joint>',
            says="Drake refuses the file; write it as drake:joint",
            also=("SCH015",),
        ),
        Bad(f'<joint name="j" type="«floating»">{ENDS}</joint>', says="Drake ignores it", also=("URD020",)),
        Bad(
            "<static>true</static>"
            '<joint name="j" type="«revolute»"><parent>a</parent><child>b</child><axis><xyz>0 0 1</xyz>'
            "</axis></joint>",
            says="a joint of a static model cannot be `revolute`",
            scaffold=MODEL,
        ),
    )
    good = (
        Good("", scaffold=JOINT),
        Good("", scaffold=ROBOT),
        Good(f'<drake:joint name="j" type="ball">{ENDS}</drake:joint>'),
    )

    def check(self, subject: Joint | VendorValue) -> Iterator[Diagnostic]:
        if isinstance(subject, VendorValue):
            yield from self._of_own(subject)
        elif (kind := subject.type_value) is not None:
            for reaction, what, instead in (_in_urdf if subject.is_urdf else _in_sdf)(subject):
                message = f"{what.format(kind.text.strip())}: {does(reaction)}"
                if instead:
                    message += f"; write it as {instead}"
                yield self.diagnostic(kind, message, severity=severity(reaction), affects=affects(reaction))

    def _of_own(self, kind: VendorValue) -> Iterator[Diagnostic]:
        """The type of a `drake:joint`."""
        if kind.prefix == "drake" and kind.tag.name == "drake:joint" and kind.is_unknown_choice:
            found = self.malformed(kind)
            yield found._replace(affects=(*found.affects, UNREAD_BY_PYBULLET))


def _in_sdf(joint: Joint) -> Iterator[tuple[Reaction, str, str]]:
    """What Drake does, about what, and what to write instead."""
    if joint.type in REFUSED_IN_SDF:
        yield REFUSES, "a joint of type `{}` is not supported", REFUSED_IN_SDF[joint.type]
    elif not joint.is_fixed and joint.model is None:
        yield REFUSES, "a joint of a world cannot be `{}`", "fixed"
    elif not joint.is_fixed and joint.scope.stands_still:
        yield REFUSES, "a joint of a static model cannot be `{}`", "fixed"


def _in_urdf(joint: Joint) -> Iterator[tuple[Reaction, str, str]]:
    if joint.type in OWN_IN_URDF:
        yield REFUSES, "a joint of type `{}` is not supported", "drake:joint"
    elif joint.type == "floating":
        yield IGNORES, "a joint of type `{}` is not supported", "a link without joint"

from collections.abc import Iterator
from typing import Any

from sdfcheck import REFUSES, Bad, Consumer, Diagnostic, Good, Severity, VendorRule, problems
from sdfcheck_rules.drk.effect import affects, consequence, severity
from sdfcheck_rules.drk.scaffolds import JOINT, MODEL, ROBOT, ROBOT_JOINT

ENDS = '<parent link="a"/><child link="b"/>'


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
    affects = {Consumer.DRAKE: REFUSES}
    prefix = "drake"
    explains = (problems.UnsupportedJoint, problems.UnknownTagChoice)
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
        Bad(
            f'<joint name="j" type="«floating»">{ENDS}</joint>',
            says="Drake ignores it",
            also=("URD020",),
        ),
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

    def check(self, problem: Any) -> Iterator[Diagnostic]:
        if isinstance(problem, problems.UnknownTagChoice):
            yield from super().check(problem)
            return
        word = problem.type.text.strip()
        does = consequence(problem.effect)
        if problem.where is not None:
            message = f"a joint of {problem.where} cannot be `{word}`: {does}"
        else:
            message = f"a joint of type `{word}` is not supported: {does}"
        if problem.instead is not None:
            message += f"; write it as {problem.instead}"
        effect = problem.effect
        yield self.diagnostic(problem.type, message, severity=severity(effect), affects=affects(effect))

    def is_about(self, problem: Any) -> bool:
        """Choices of other elements are not this rule's."""
        return bool(problem.name == "drake:joint")

from collections.abc import Iterator

from sdfcheck import (
    IN_JOINT,
    IN_URDF_JOINT,
    Bad,
    Consumer,
    Diagnostic,
    Good,
    Rule,
    Severity,
    problems,
    refuses,
    warns,
)

_SHOWN = 6
_LIMIT = '<limit lower="-1" upper="1" effort="5" velocity="2"/>'


class MimicCycle(Rule):
    """Joints mimic each other in a ring, or one mimics itself.

    None of them leads, so none has a position. libsdformat refuses an axis that mimics itself,
    and does not look at longer rings.
    """

    code = "JNT012"
    name = "mimic-cycle"
    severity = Severity.ERROR
    affects = {
        Consumer.GAZEBO: refuses("refuses a joint that mimics itself"),
        Consumer.DRAKE: refuses("refuses a joint that mimics itself"),
        Consumer.URDFDOM: warns("takes it as it is"),
        Consumer.MUJOCO: refuses("refuses a joint that mimics itself"),
    }
    explains = (problems.MimicCycle,)
    scaffold = IN_JOINT

    bad = (
        Bad(
            '<axis><xyz>0 0 1</xyz><mimic joint="«j»"><multiplier>1</multiplier></mimic></axis>',
            says="joint `j` mimics itself",
        ),
        Bad(
            '<axis><xyz>0 0 1</xyz><mimic joint="«k»"><multiplier>1</multiplier></mimic></axis></joint>'
            '<link name="hand"/><joint name="k" type="revolute"><parent>arm</parent><child>hand</child>'
            '<axis><xyz>0 0 1</xyz><mimic joint="j"><multiplier>1</multiplier></mimic></axis>',
            says="joints mimic each other in a ring: `j` → `k` → `j`",
        ),
        Bad(f'<mimic joint="«j»"/>{_LIMIT}', scaffold=IN_URDF_JOINT, says="joint `j` mimics itself"),
    )
    good = (
        Good(
            '<axis><xyz>0 0 1</xyz></axis></joint><link name="hand"/>'
            '<joint name="k" type="universal"><parent>arm</parent><child>hand</child>'
            "<axis><xyz>0 0 1</xyz></axis><axis2><xyz>1 0 0</xyz>"
            '<mimic joint="k" axis="axis"><multiplier>1</multiplier></mimic></axis2>',
            why="one axis follows the other",
        ),
    )

    def check(self, problem: problems.MimicCycle) -> Iterator[Diagnostic]:
        names, leaders = problem.joints, problem.leaders
        if len(names) == 1:
            yield self.diagnostic(leaders[0], f"joint `{names[0]}` mimics itself")
            return
        shown = [f"`{name}`" for name in names[:_SHOWN]]
        more = ["…"] if len(names) > _SHOWN else []
        ring = " → ".join((*shown, *more, f"`{names[0]}`"))
        labels = {
            leader: f"the leader of `{name}`"
            for leader, name in zip(leaders[1:_SHOWN], names[1:], strict=False)
        }
        message, affects = (
            f"joints mimic each other in a ring: {ring}",
            dict.fromkeys(Consumer, warns("takes it as it is")),
        )
        yield self.diagnostic(leaders[0], message, labels=labels, affects=affects)

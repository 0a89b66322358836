from collections.abc import Iterator

from sdfcheck import (
    IN_JOINT,
    IN_URDF_JOINT,
    Bad,
    Consumer,
    Diagnostic,
    Good,
    Mimic,
    Root,
    Rule,
    Severity,
    warns,
)

SHOWN = 6
"""So many joints of a ring are shown."""
_LIMIT = '<limit lower="-1" upper="1" effort="5" velocity="2"/>'


class MimicCycle(Rule):
    """Joints mimic each other in a ring, or one mimics itself.

    None of them leads, so none has a position. libsdformat refuses an axis that mimics itself,
    and does not look at longer rings.
    """

    code = "JNT012"
    name = "mimic-cycle"
    severity = Severity.ERROR
    remedy = """Let one joint of the ring lead: remove its `mimic`.

    That is the one with the motor. All others follow it directly: for a follower of a follower multiply the
    multipliers.
    """
    looks_at = (Root,)
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
        Good('<limit lower="-1" upper="1" effort="5" velocity="2"/>', scaffold=IN_URDF_JOINT),
    )

    @staticmethod
    def applies(root: Root) -> bool:
        return bool(_rings(root))

    def check(self, root: Root) -> Iterator[Diagnostic]:
        for ring in _rings(root):
            names = [mimic.joint.name for mimic in ring]
            first, *others = [mimic.leader_value or mimic for mimic in ring]
            if not others:
                yield self.diagnostic(first, f"joint `{names[0]}` mimics itself")
                continue
            shown = [f"`{name}`" for name in names[:SHOWN]]
            more = ["…"] if len(names) > SHOWN else []
            text = " → ".join((*shown, *more, f"`{names[0]}`"))
            leaders = zip(others[: SHOWN - 1], names[1:], strict=False)
            yield self.diagnostic(
                first,
                f"joints mimic each other in a ring: {text}",
                labels={leader: f"the leader of `{name}`" for leader, name in leaders},
                affects=dict.fromkeys(Consumer, warns("takes it as it is")),
            )


def _rings(root: Root) -> list[list[Mimic]]:
    """The mimics that lead round in a ring, each ring from where the first mimic of the file reaches it."""
    found: list[list[Mimic]] = []
    done: set[Mimic] = set()
    for start in root.each("Mimic"):
        path: dict[Mimic, None] = {}
        at = start
        while at is not None and at not in path and at not in done:
            path[at] = None
            at = at.next
        if at in path:
            members = list(path)
            found.append(members[members.index(at) :])
        done.update(path)
    return found

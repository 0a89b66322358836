from collections.abc import Iterator

from sdfcheck import Bad, Diagnostic, Good, Rule, Semantics, Severity
from sdfcheck_rules.srd.scaffold import FILE, IN_SRDF, ROBOT


class UnknownSemanticName(Rule):
    """SRDF names a link or joint that the robot does not have.

    MoveIt drops what names it with a message at start: a group loses a member, a chain is not there, a pair
    of links collides again. Robots are looked for by name in the project; where none has most of the names,
    nothing is reported. In a file without groups, as Pinocchio reads it, this is a warning.
    """

    code = "SRD001"
    name = "unknown-semantic-name"
    severity = Severity.ERROR
    remedy = """Name a link or joint of the robot, as the URDF spells it.

    `sdfcheck graph joints FILE` lists them. After names have changed, run the MoveIt Setup Assistant again,
    or rename them in the SRDF as well. In a macro, mind the prefix.
    """
    looks_at = (Semantics,)
    scaffold = IN_SRDF

    bad = (
        Bad(
            '<group name="one"><joint name="«sholder»"/></group>',
            fixed='<group name="one"><joint name="shoulder"/></group>',
            unsafe=True,
            file=FILE,
            files=ROBOT,
            says="robot `arm` has no joint `sholder`; did you mean `shoulder`?",
        ),
        Bad(
            '<disable_collisions link1="base" link2="«grip»"/>',
            file=FILE,
            files=ROBOT,
            says="robot `arm` has no link `grip`",
        ),
    )
    good = (
        Good('<disable_collisions link1="base" link2="hand"/>', file=FILE, files=ROBOT),
        Good(
            '<group name="one"><joint name="elbow"/></group>', why="no robot of the name is there", file=FILE
        ),
        Good(
            '<virtual_joint name="v" type="fixed" parent_frame="world" child_link="base"/>'
            '<group name="one"><joint name="v"/></group>',
            why="a joint of its own",
            file=FILE,
            files=ROBOT,
        ),
    )

    @staticmethod
    def applies(semantics: Semantics) -> bool:
        return bool(semantics.robots) and any(True for _ in semantics.unknown)

    def check(self, semantics: Semantics) -> Iterator[Diagnostic]:
        for part in semantics.unknown:
            name, near = part.value.text.strip(), semantics.guess(part)
            robot = semantics.robots[0].name if len(semantics.robots) == 1 else semantics.name
            message = f"robot `{robot}` has no {part.kind} `{name}`"
            is_pair = part.value.element.name.endswith("collisions")
            severity = Severity.WARNING if is_pair or not semantics.groups else None
            yield self.diagnostic(part.value, message, meant=near, severity=severity)

from collections.abc import Iterator

from sdfcheck import IN_LINK, Bad, Diagnostic, Good, Rule, Severity, problems


class ConflictingRotation(Rule):
    """The attributes of a pose contradict each other: a quaternion has no degrees.

    libsdformat refuses a pose with `degrees="true"` and `rotation_format="quat_xyzw"`,
    and with it the document.
    """

    code = "SCH017"
    name = "conflicting-rotation"
    severity = Severity.ERROR
    remedy = """Remove `degrees`, or write the rotation as three angles.

    A quaternion has the order `x y z w` and is not an angle. For angles in degrees remove
    `rotation_format`.
    """
    explains = (problems.ConflictingRotation,)
    scaffold = IN_LINK

    bad = (
        Bad(
            '<pose degrees="«true»" rotation_format="quat_xyzw">0 0 0 0 0 0 1</pose>',
            says="`degrees` cannot go with a quaternion",
        ),
    )
    good = (
        Good(
            '<pose degrees="false" rotation_format="quat_xyzw">0 0 0 0 0 0 1</pose>', why="no contradiction"
        ),
        Good('<pose degrees="true" rotation_format="euler_rpy">0 0 0 0 0 90</pose>'),
    )

    def check(self, problem: problems.ConflictingRotation) -> Iterator[Diagnostic]:
        yield self.diagnostic(
            problem.value,
            "`degrees` cannot go with a quaternion",
            labels={problem.format: "the rotation is a quaternion"},
        )

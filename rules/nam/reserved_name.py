from collections.abc import Iterator

from sdfcheck import IN_LINK, IN_MODEL, REFUSES, Bad, Consumer, Diagnostic, Good, Rule, Severity, problems

IMU = (
    '<sensor name="s" type="imu"><imu><orientation_reference_frame><localization>CUSTOM</localization>'
    "{}</orientation_reference_frame></imu></sensor>"
)


class ReservedName(Rule):
    """A name is one of those that libsdformat keeps for itself.

    `world`, and whatever begins and ends with two underscores, are names of implicit
    frames. libsdformat refuses to give them to anything (1.7 on, in files of all versions).
    """

    code = "NAM003"
    name = "reserved-name"
    severity = Severity.ERROR
    affects = {Consumer.GAZEBO: REFUSES, Consumer.DRAKE: REFUSES}
    explains = (problems.ReservedName,)
    scaffold = IN_MODEL

    bad = (
        Bad('<link name="«world»"/>', says="the name `world` is reserved"),
        Bad('<frame name="«__tip__»"/>', says="the name `__tip__` is reserved"),
        Bad(
            '<custom_rpy parent_frame="«__root__»">0 0 0</custom_rpy>',
            scaffold=IN_LINK.format(IMU),
            says="`__root__` cannot be referred to",
        ),
    )
    good = (
        Good('<frame name="__tip"/>', why="reserved are names with underscores at both ends"),
        Good('<link name="worlds"/>'),
        Good('<plugin name="__p__" filename="p"/>', why="the names of plugins are free"),
    )

    def check(self, problem: problems.ReservedName) -> Iterator[Diagnostic]:
        name = problem.value.text.strip()
        if problem.is_reference:
            yield self.diagnostic(problem.value, f"`{name}` cannot be referred to")
            return
        message = f"the name `{name}` is reserved"
        known = "reserved are `world` and names that begin and end with two underscores"
        yield self.diagnostic(problem.value, message, help=known)

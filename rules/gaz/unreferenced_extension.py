from collections.abc import Iterator

from sdfcheck import IN_ROBOT, Bad, Consumer, Diagnostic, Good, Rule, Severity, problems, warns


class UnreferencedExtension(Rule):
    """A `gazebo` block is for a link or joint that does not exist.

    libsdformat drops the whole block without a word: friction, sensors and plugins in it
    are never seen. Links and joints can be referred to, visuals, collisions and the robot
    itself cannot; a block for the robot has no reference.
    """

    code = "GAZ003"
    name = "unreferenced-extension"
    severity = Severity.ERROR
    affects = {Consumer.GAZEBO: warns("drops the block")}
    explains = (problems.UnreferencedExtension,)
    scaffold = IN_ROBOT

    bad = (
        Bad(
            '<gazebo reference="«bases»"><mu1>1</mu1></gazebo>',
            says="there is no link or joint `bases`; did you mean `base`?",
        ),
        Bad(
            '<gazebo reference="«r»"><static>true</static></gazebo>',
            says="`r` is a robot, not a link or joint",
        ),
    )
    good = (
        Good('<gazebo reference="base"><mu1>1</mu1></gazebo>'),
        Good("<gazebo><static>true</static></gazebo>", why="for the robot"),
    )

    def check(self, problem: problems.UnreferencedExtension) -> Iterator[Diagnostic]:
        name = problem.value.text
        message = f"there is no link or joint `{name}`"
        if problem.kind is not None:
            message = f"`{name}` is a {problem.kind}, not a link or joint"
        elif problem.suggestion is not None:
            message += f"; did you mean `{problem.suggestion}`?"
        yield self.diagnostic(problem.value, message)

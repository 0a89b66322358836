from collections.abc import Iterator

from sdfcheck import (
    IN_MODEL,
    IN_WORLD,
    REFUSES,
    Bad,
    Consumer,
    Diagnostic,
    Good,
    Rule,
    Severity,
    listed,
    problems,
)

ARM = '<sdf version="1.12"><model name="arm"><link name="l"/></model></sdf>'
LAMP = '<sdf version="1.12"><light name="lamp" type="point"/></sdf>'
SET = '<sdf version="1.12"><model name="set"><model name="arm"><link name="l"/></model></model></sdf>'


class InvalidMergeInclude(Rule):
    """What an include merges cannot become a part of what it is merged into.

    Only models merge, into models (from version 1.9) and worlds (from 1.10). A world has
    no links and grippers of its own, so it takes models that hold nothing but nested
    models, frames and joints. libsdformat refuses everything else.
    """

    code = "RES009"
    name = "invalid-merge-include"
    severity = Severity.ERROR
    affects = {Consumer.GAZEBO: REFUSES, Consumer.DRAKE: REFUSES}
    explains = (problems.InvalidMerge,)
    scaffold = IN_WORLD

    bad = (
        Bad(
            '<include merge="«true»"><uri>arm.sdf</uri></include>',
            files={"arm.sdf": ARM},
            says="a world cannot take link `l`",
        ),
        Bad(
            '<include merge="«true»"><uri>lamp.sdf</uri></include>',
            files={"lamp.sdf": LAMP},
            says="a light cannot be merged",
        ),
        Bad(
            '<frame name="f"><include merge="«true»"><uri>arm.sdf</uri></include></frame>',
            scaffold=IN_MODEL,
            files={"arm.sdf": ARM},
            says="nothing can be merged into frame `f`",
            also=("SCH003",),
        ),
    )
    good = (
        Good('<include merge="true"><uri>arm.sdf</uri></include>', scaffold=IN_MODEL, files={"arm.sdf": ARM}),
        Good('<include merge="true"><uri>set.sdf</uri></include>', files={"set.sdf": SET}),
        Good('<include merge="false"><uri>lamp.sdf</uri></include>', files={"lamp.sdf": LAMP}),
    )

    def check(self, problem: problems.InvalidMerge) -> Iterator[Diagnostic]:
        article = "an" if problem.kind == "actor" else "a"
        if problem.kind != "model":
            message = f"{article} {problem.kind} cannot be merged, only a model can"
        elif problem.parts:
            message = f"a world cannot take {listed(problem.parts, most=3)} from a merged model"
        else:
            message = f"nothing can be merged into {problem.parent.title}"
        yield self.diagnostic(problem.merge, message)

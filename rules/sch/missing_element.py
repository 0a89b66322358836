from collections.abc import Iterator

from sdfcheck import (
    IN_COLLISION,
    IN_LINK,
    IN_MODEL,
    IN_VISUAL,
    REFUSES,
    Bad,
    Consumer,
    Diagnostic,
    Good,
    Rule,
    Severity,
    lacking,
    problems,
    warns,
)


class MissingElement(Rule):
    """A required element is missing.

    Without its parent or child a joint is refused, and so are an include without uri and
    a material script without uri and name. For all else libsdformat takes a default and
    says nothing: a box without a size is a cube of one metre, an axis without direction
    points along z. Those get a warning.
    """

    code = "SCH004"
    name = "missing-element"
    severity = Severity.ERROR
    affects = dict.fromkeys(Consumer, REFUSES)
    explains = (problems.MissingElement,)
    scaffold = IN_COLLISION

    bad = (
        Bad("<geometry><«box»/></geometry>", says="`box` has no `size`, so 1 1 1 is taken"),
        Bad(
            '<«joint» name="j" type="fixed"><parent>base</parent></joint>',
            scaffold=IN_MODEL,
            says="joint `j` has no `child`",
        ),
        Bad(
            "<«inertial»><inertia><ixx>1</ixx><iyy>1</iyy><izz>1</izz></inertia></inertial>",
            scaffold=IN_LINK,
            says="`inertial` has no `mass`, so 1 is taken",
        ),
        Bad(
            "<geometry><mesh><uri>model://arm/arm.dae</uri><«submesh»/></mesh></geometry>",
            says="`submesh` has no `name`",
        ),
        Bad(
            "<geometry><box><size>1 1 1</size></box></geometry>"
            '<material><«shader» type="normal_map_object_space"/></material>',
            scaffold=IN_VISUAL,
            says="`shader` has no `normal_map`",
        ),
    )
    good = (
        Good("<geometry><box><size>2 1 1</size></box></geometry>"),
        Good(
            '<world name="w"><physics type="ode"/></world>',
            why="what a world leaves out is as people expect it",
            scaffold='<sdf version="1.12">{}</sdf>',
        ),
        Good(
            '<joint name="j" type="fixed"><parent>world</parent><child>base</child></joint>',
            scaffold=IN_MODEL,
        ),
    )

    def check(self, problem: problems.MissingElement) -> Iterator[Diagnostic]:
        message = f"{problem.element.title} has no `{problem.child}`"
        if problem.refused:
            yield self.diagnostic(problem.element, message, affects=lacking(problem.element, problem.child))
            return
        if problem.default is not None:
            message += f", so {problem.default} is taken"
        affects = dict.fromkeys(Consumer, warns("takes a default"))
        yield self.diagnostic(problem.element, message, severity=Severity.WARNING, affects=affects)

from collections.abc import Iterator

from sdfcheck import Bad, Diagnostic, Good, Rule, Severity, problems
from sdfcheck_rules.xac.scaffold import FILE, IN_XACRO

MACRO = (
    '<xacro:macro name="m" params="**frame"><link name="a"><xacro:insert_block name="frame"/></link>'
    "</xacro:macro>"
)


class EmptiedBlock(Rule):
    """A macro takes the content of a block, and the call gives an element without content.

    A parameter `*origin` inserts the element that the call gives, `**origin` what is inside of it: of
    `<origin xyz="…"/>` nothing is left.
    """

    code = "XAC026"
    name = "emptied-block"
    severity = Severity.WARNING
    remedy = """Write `*name` to insert the element of the call whole, in the parameters of the macro.

    `**name` inserts what is inside of the element: then give it content, `<frame><origin …/></frame>`.
    """
    explains = (problems.EmptiedBlock,)
    scaffold = IN_XACRO

    bad = (
        Bad(
            MACRO + '<xacro:m><«pose» degrees="true"/></xacro:m>',
            file=FILE,
            says="`**frame` inserts what is in `<pose>`, which is empty; `*frame` inserts it whole",
        ),
    )
    good = (Good(MACRO + "<xacro:m><content><pose/></content></xacro:m>", file=FILE),)

    def check(self, problem: problems.EmptiedBlock) -> Iterator[Diagnostic]:
        labels = {problem.other: "the parameter"} if problem.other else None
        whole = f"`{(problem.near or '')[1:]}` inserts it whole"
        message = f"`{problem.near}` inserts what is in `<{problem.name}>`, which is empty; {whole}"
        yield self.diagnostic(problem.span, message, labels=labels)

from collections.abc import Iterator

from sdfcheck import IN_WORLD, Bad, Diagnostic, Good, Rule, Severity, TextEdit, make_fix, problems

INCLUDE = (
    "<include{}><uri>https://fuel.gazebosim.org/1.0/a/models/b</uri><pose{}>0 0 0 0 0 90</pose></include>"
)


class MisplacedDegrees(Rule):
    """`degrees` is an attribute of what a pose belongs to, not of the pose.

    libsdformat looks for it on `<pose>` only: the angles are read as radians. Drake refuses the file.
    SDFormat has the attribute since version 1.9.
    """

    code = "FRM010"
    name = "misplaced-degrees"
    severity = Severity.ERROR
    remedy = """Move `degrees` to the `<pose>` whose angles are in degrees.

    It concerns one pose only, so each pose with degrees needs an attribute of its own, and so does the file
    `version="1.9"` or later. Otherwise write radians; `sdfcheck print --radians FILE` converts.
    """
    explains = (problems.UnknownAttribute,)
    scaffold = IN_WORLD

    bad = (
        Bad(
            INCLUDE.format(' «degrees»="true"', ""),
            fixed=INCLUDE.format("", ' degrees="true"'),
            unsafe=True,
            says="`degrees` belongs to `pose`, not to `include`: the angles are read as radians",
        ),
    )
    good = (
        Good(INCLUDE.format("", ' degrees="true"')),
        Good(
            '<include degrees="true"><uri>https://fuel.gazebosim.org/1.0/a/models/b</uri></include>',
            why="unknown-attribute owns this one: nothing has a pose",
        ),
    )

    def check(self, problem: problems.UnknownAttribute) -> Iterator[Diagnostic]:
        element = problem.element
        value, pose = element.attribute("degrees"), element.find("pose")
        if problem.attribute != "degrees" or value is None or pose is None:
            return
        message = f"`degrees` belongs to `pose`, not to `{element.name}`: the angles are read as radians"
        source, start, end = value.span.source, value.name_span.start, value.span.end
        edits = (
            TextEdit(source.span(start - 1, end + 1), ""),
            TextEdit(pose.span, f'pose degrees="{value.text}"'),
        )
        yield self.diagnostic(value.name_span, message, fix=make_fix("move it to `pose`", edits, unsafe=True))

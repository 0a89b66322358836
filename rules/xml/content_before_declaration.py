from collections.abc import Iterator

from sdfcheck import Bad, Consumer, Diagnostic, Good, Rule, Severity, TextEdit, accepts, make_fix, problems
from sdfcheck_rules.xml.strict import unless_xacro


class ContentBeforeDeclaration(Rule):
    """Something is before the XML declaration.

    `<?xml …?>` must be the very first thing in the file. A comment before it makes
    libsdformat, Drake and MuJoCo refuse the file. They take an empty line, which is a
    warning because strict XML parsers refuse that, too; in a xacro file it is an error,
    as xacro uses such a parser.
    """

    code = "XML004"
    name = "content-before-declaration"
    severity = Severity.ERROR
    remedy = """Move it after the declaration, or leave the declaration out.

    `<?xml version="1.0"?>` has to be the first bytes of the file. A license as a comment goes on the second
    line. A declaration is optional for UTF-8.
    """
    explains = (problems.LateDeclaration,)

    bad = (
        Bad(
            '\n«<?xml version="1.0"?>»\n<sdf version="1.12"><world name="w"/></sdf>',
            fixed='<?xml version="1.0"?>\n<sdf version="1.12"><world name="w"/></sdf>',
            says="must be the first thing",
        ),
        Bad(
            '<!-- my world -->\n«<?xml version="1.0"?>»\n<sdf version="1.12"><world name="w"/></sdf>',
            fixed='<?xml version="1.0"?>\n<!-- my world -->\n<sdf version="1.12"><world name="w"/></sdf>',
        ),
        Bad(
            '\n«<?xml version="1.0"?>»\n<robot name="r"><link name="a"/></robot>',
            file="robot.urdf.xacro",
            fixed='<?xml version="1.0"?>\n<robot name="r"><link name="a"/></robot>',
            says="xacro refuses the file",
        ),
    )
    good = (
        Good('<!-- no declaration -->\n<sdf version="1.12"><world name="w"/></sdf>'),
        Good('<?xml version="1.0"?>\n<!-- my world -->\n<sdf version="1.12"><world name="w"/></sdf>'),
    )

    def check(self, problem: problems.LateDeclaration) -> Iterator[Diagnostic]:
        before, declaration = problem.span, problem.declaration
        source = before.source
        if before.text.strip():
            # The line end after the declaration moves along with it.
            end = (
                declaration.end
                + len(source.text[declaration.end :][:2])
                - len(source.text[declaration.end :][:2].lstrip("\r\n"))
            )
            moved = source.span(declaration.start, end)
            first = source.span(0, 0)
            edits = (TextEdit(first, moved.text), TextEdit(moved, ""))
            fix = make_fix("move the declaration to the front", edits)
        else:
            fix = make_fix("remove what is before it", (TextEdit(before, ""),))
        message = "the XML declaration must be the first thing in the file"
        if before.text.strip():
            yield self.diagnostic(declaration, message, fix=fix)
            return
        affects = dict.fromkeys(Consumer, accepts("takes the blank"))
        own = unless_xacro(declaration, message, severity=Severity.WARNING, affects=affects)
        yield self.diagnostic(declaration, fix=fix, **own)

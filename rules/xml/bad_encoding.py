from collections.abc import Iterator

from sdfcheck import Bad, Diagnostic, Good, Rule, Severity, problems, replace

Kind = problems.EncodingKind


class BadEncoding(Rule):
    """The bytes of the file are not in the encoding that it declares, or in none that XML knows.

    Without a declaration XML is UTF-8. Strict parsers refuse other bytes; the
    simulators pass them on, so that names with umlauts no longer match. UTF-16 they
    cannot read at all.
    """

    code = "XML005"
    name = "bad-encoding"
    severity = Severity.ERROR
    remedy = """Save the file as UTF-8.

    The declaration says `encoding="UTF-8"` or nothing. Editors offer it as "save with encoding";
    `iconv -f LATIN1 -t UTF-8 old.urdf >new.urdf` converts.
    """
    explains = (problems.EncodingDefect,)

    bad = (
        Bad(
            '<?xml version="1.0" encoding="«utf-16»"?><sdf version="1.12"><world name="w"/></sdf>',
            fixed='<?xml version="1.0" encoding="UTF-8"?><sdf version="1.12"><world name="w"/></sdf>',
            says="declared as utf-16, and is UTF-8",
        ),
        Bad(
            '<?xml version="1.0" encoding="«utf8mb4»"?><sdf version="1.12"><world name="w"/></sdf>',
            fixed='<?xml version="1.0" encoding="UTF-8"?><sdf version="1.12"><world name="w"/></sdf>',
            says="`utf8mb4` is not an encoding",
        ),
    )
    good = (
        Good('<?xml version="1.0" encoding="ascii"?><sdf version="1.12"><world name="w"/></sdf>'),
        Good('<sdf version="1.12"><world name="Wörld"/></sdf>', why="UTF-8 needs no declaration"),
    )

    def check(self, problem: problems.EncodingDefect) -> Iterator[Diagnostic]:
        kind, declared, actual = problem.kind, problem.declared, problem.actual
        if kind is Kind.WIDE:
            yield self.diagnostic(problem.span, f"the file is {actual}, and simulators read UTF-8 only")
        elif kind is Kind.UNDECODABLE:
            message = f"bytes that are not {declared}"
            if actual:
                message = f"`{problem.span.text}` is not stored as {declared}; the file looks like {actual}"
            yield self.diagnostic(problem.span, message)
        else:
            message = f"the file is declared as {declared}, and is {actual}"
            if kind is Kind.UNKNOWN_ENCODING:
                message = f"`{declared}` is not an encoding that XML parsers know; the text is {actual}"
            yield self.diagnostic(
                problem.span, message, fix=replace(problem.span, actual, f"declare {actual}")
            )

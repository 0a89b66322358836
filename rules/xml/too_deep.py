from collections.abc import Iterator

from sdfcheck import Bad, Diagnostic, Good, Rule, Severity, problems


class TooDeep(Rule):
    """Elements are nested deeper than XML parsers follow.

    libxml2 stops at 256 levels; tinyxml2, with which the simulators read, at 500, and in some
    distributions (Debian 12) at 100. Deeper elements are not checked.
    """

    code = "XML010"
    name = "too-deep"
    severity = Severity.ERROR
    remedy = """Close the elements earlier: a description has some ten levels.

    Look for a tag without end that repeats, such as a generator in a loop or a macro that wraps its own
    result. Nested models can be included from files instead.
    """
    explains = (problems.TooDeep,)

    bad = (
        Bad(
            '<sdf version="1.12"><world name="w"><plugin name="p" filename="p">'
            + "<a>" * 253
            + "<«a»/>"
            + "</a>" * 253
            + "</plugin></world></sdf>",
            says="more than 256 elements deep",
        ),
    )
    good = (
        Good(
            '<sdf version="1.12"><world name="w"><plugin name="p" filename="p">'
            + "<a>" * 253
            + "</a>" * 253
            + "</plugin></world></sdf>"
        ),
    )

    def check(self, problem: problems.TooDeep) -> Iterator[Diagnostic]:
        message = f"`{problem.span.text}` is nested more than {problem.limit} elements deep"
        yield self.diagnostic(problem.span, message)

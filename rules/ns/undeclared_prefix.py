from collections.abc import Iterator

from sdfcheck import Bad, Diagnostic, Edit, Fix, Good, Rule, Severity, make_fix, problems, used

# Prefixes whose namespace names their vendors have settled.
WELL_KNOWN = {
    "drake": "http://drake.mit.edu",
    "experimental": "http://sdformat.org/schemas/experimental",
    "gz": "http://gazebosim.org/schema",
    "ignition": "http://ignitionrobotics.org/schema",
}


class UndeclaredPrefix(Rule):
    """A prefix is used where no declaration of it is in scope.

    A declaration holds from its own start tag to the matching end tag, no further. The
    custom-elements proposal asks for declared prefixes and advises to declare them on
    the root element. libsdformat and Drake read prefixes as plain text and do not mind,
    but every namespace-aware XML parser (Python's among them) refuses the file: an error,
    though a simulator may never meet it.
    """

    code = "NS003"
    name = "undeclared-prefix"
    severity = Severity.ERROR
    explains = (problems.UndeclaredPrefix,)

    bad = (
        Bad(
            '<sdf version="1.12"><world name="w"><«gz»:note>hello</gz:note></world></sdf>',
            fixed='<sdf version="1.12" xmlns:gz="http://gazebosim.org/schema">'
            '<world name="w"><gz:note>hello</gz:note></world></sdf>',
            says="prefix `gz` is not declared",
        ),
        Bad(
            '<sdf version="1.12"><world name="w">'
            '<model name="a" xmlns:flatland="https://example.org/f"><link name="l"/>'
            "<flatland:kind>a</flatland:kind></model>"
            '<model name="b"><link name="l"/><«flatland»:kind>b</flatland:kind></model></world></sdf>',
            fixed='<sdf version="1.12" xmlns:flatland="https://example.org/f"><world name="w">'
            '<model name="a" xmlns:flatland="https://example.org/f"><link name="l"/>'
            "<flatland:kind>a</flatland:kind></model>"
            '<model name="b"><link name="l"/><flatland:kind>b</flatland:kind></model></world></sdf>',
            says="not declared here",
        ),
        Bad(
            '<sdf version="1.12"><model name="m">'
            '<link name="l" «mine»:colour="red" mine:size="2"/></model></sdf>',
            says="used 2 times",
        ),
    )
    good = (
        Good(
            '<sdf version="1.12" xmlns:p="https://example.org/p"><model name="m">'
            '<link name="l" p:x="1"/></model></sdf>',
            why="declared on the root",
        ),
        Good(
            '<sdf version="1.12"><model name="m" xml:lang="en"><link name="l"/></model></sdf>',
            why="xml needs no declaration",
        ),
    )

    def check(self, problem: problems.UndeclaredPrefix) -> Iterator[Diagnostic]:
        prefix, times = problem.prefix, used(len(problem.uses))
        namespace = problem.namespace or WELL_KNOWN.get(prefix, "")
        fix: Fix | None = None
        advice: str | None = f'declare it on the root element: xmlns:{prefix}="…"'
        if namespace:
            advice = None
            declaration = Edit(problem.root, f' xmlns:{prefix}="{namespace}"')
            fix = make_fix("declare it on the root element", (declaration,))
        if problem.elsewhere is None or problem.scope_end is None:
            message = f"prefix `{prefix}` is not declared{times}"
            yield self.diagnostic(problem.span, message, fix=fix, help=advice)
            return
        line = problem.scope_end.begin.line
        labels = {problem.elsewhere: f"declared here, in scope until line {line}"}
        message = f"prefix `{prefix}` is not declared here{times}"
        yield self.diagnostic(problem.span, message, labels=labels, fix=fix, help=advice)

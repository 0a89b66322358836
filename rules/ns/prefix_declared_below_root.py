from collections.abc import Iterator

from sdfcheck import Bad, Diagnostic, Edit, Fix, Good, Rule, Severity, make_fix, problems


class PrefixDeclaredBelowRoot(Rule):
    """A prefix is declared on another element than the root.

    It is allowed. The custom-elements proposal advises to declare prefixes on the root
    only, where they are found at once and hold for the whole file.
    """

    code = "NS006"
    name = "prefix-declared-below-root"
    severity = Severity.INFO
    explains = (problems.DeclaredBelowRoot,)

    bad = (
        Bad(
            '<sdf version="1.12"><world name="w" «xmlns:p»="https://example.org/p">'
            "<p:kind>2d</p:kind></world></sdf>",
            fixed='<sdf version="1.12" xmlns:p="https://example.org/p"><world name="w">'
            "<p:kind>2d</p:kind></world></sdf>",
            says="prefix `p` is declared below the root",
        ),
        Bad(
            '<sdf version="1.12"><world name="w">'
            '<light name="a" type="point" «xmlns:p»="https://example.org/p" p:kind="1"/>'
            '<light name="b" type="point" xmlns:p="https://example.org/p" p:kind="2"/></world></sdf>',
            fixed='<sdf version="1.12" xmlns:p="https://example.org/p"><world name="w">'
            '<light name="a" type="point" p:kind="1"/>'
            '<light name="b" type="point" p:kind="2"/></world></sdf>',
            says="2 times",
        ),
    )
    good = (
        Good('<sdf version="1.12" xmlns:p="https://example.org/p"><world name="w" p:kind="2d"/></sdf>'),
        Good(
            '<sdf version="1.12"><world name="w">'
            '<light name="a" type="point" xmlns:p="https://example.org/p" p:x="1"/>'
            '<light name="b" type="point" p:x="1"/></world></sdf>',
            why="undeclared-prefix tells of the scope that is too small",
        ),
    )

    def check(self, problem: problems.DeclaredBelowRoot) -> Iterator[Diagnostic]:
        message = f"prefix `{problem.prefix}` is declared below the root element"
        if len(problem.wholes) > 1:
            message += f" {len(problem.wholes)} times"
        fix: Fix | None = None
        if problem.wholes:
            removed = tuple(Edit(whole, "") for whole in problem.wholes)
            if problem.declaration:
                added = Edit(problem.root, f" {problem.declaration}")
                fix = make_fix("declare it on the root element", (added, *removed))
            else:
                fix = make_fix("remove it, the root element has it", removed)
        yield self.diagnostic(problem.span, message, fix=fix)

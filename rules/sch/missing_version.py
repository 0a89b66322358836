from collections.abc import Iterator

from sdfcheck import REFUSES, Bad, Consumer, Diagnostic, Edit, Good, Rule, Severity, make_fix, problems


class MissingVersion(Rule):
    """The root element does not say which version of the format the file is written in.

    libsdformat, and with it Gazebo and Drake, refuses a file without a version: it does
    not know how to convert it. The rest of the file is checked as the newest version.
    """

    code = "SCH001"
    name = "missing-version"
    severity = Severity.ERROR
    affects = {Consumer.GAZEBO: REFUSES, Consumer.DRAKE: REFUSES}
    explains = (problems.MissingVersion,)

    bad = (
        Bad(
            '<«sdf»><model name="m"><link name="base"/></model></sdf>',
            fixed='<sdf version="1.12"><model name="m"><link name="base"/></model></sdf>',
            unsafe=True,
            says="`sdf` has no `version`",
        ),
        Bad(
            '<sdf «version»=""><model name="m"><link name="base"/></model></sdf>',
            fixed='<sdf version="1.12"><model name="m"><link name="base"/></model></sdf>',
            unsafe=True,
            says="is empty",
        ),
    )
    good = (Good('<sdf version="1.6"><model name="m"><link name="base"/></model></sdf>'),)

    def check(self, problem: problems.MissingVersion) -> Iterator[Diagnostic]:
        root, assumed = problem.element, problem.assumed
        spans = root.document.spans
        title = f"declare version {assumed}, as which the file was checked"
        if problem.empty:
            whole = spans.attribute_whole(root, "version")
            fix = make_fix(title, (Edit(whole, f' version="{assumed}"'),), unsafe=True)
            name = spans.attribute_name(root, "version")
            yield self.diagnostic(name, f"`version` of `{root.name}` is empty", fix=fix)
            return
        behind = root.span._replace(start=root.span.end)
        fix = make_fix(title, (Edit(behind, f' version="{assumed}"'),), unsafe=True)
        yield self.diagnostic(root, f"`{root.name}` has no `version`", fix=fix)

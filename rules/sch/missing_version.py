from collections.abc import Iterator

from sdfcheck import Bad, Diagnostic, Good, Root, Rule, Severity, TextEdit, make_fix


class MissingVersion(Rule):
    """The root element does not say which version of the format the file is written in.

    libsdformat, and with it Gazebo and Drake, refuses a file without a version: it does
    not know how to convert it. The rest of the file is checked as the newest version.
    """

    code = "SCH001"
    name = "missing-version"
    severity = Severity.ERROR
    remedy = """Declare the version that the file is written in: `<sdf version="1.9">`.

    1.9 suits Gazebo Fortress and later, 1.6 Gazebo Classic. The lowest version that has all elements of the
    file serves the most consumers; `sdfcheck lint` reports elements that are newer than the version
    declared.
    """
    looks_at = (Root,)

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

    @staticmethod
    def applies(root: Root) -> bool:
        if root.is_urdf or root.element.name != "sdf":
            return False
        return not (root.version or "").strip()

    def check(self, root: Root) -> Iterator[Diagnostic]:
        element, assumed = root.element, root.read_as
        spans = root.document.spans
        title = f"declare version {assumed}, as which the file was checked"
        if root.version is not None:
            whole = spans.attribute_whole(element, "version")
            fix = make_fix(title, (TextEdit(whole, f' version="{assumed}"'),), unsafe=True)
            name = spans.attribute_name(element, "version")
            yield self.diagnostic(name, f"`version` of `{element.name}` is empty", fix=fix)
            return
        after = element.span._replace(start=element.span.end)
        fix = make_fix(title, (TextEdit(after, f' version="{assumed}"'),), unsafe=True)
        cause = root.misnamed("version")
        yield self.diagnostic(element, f"`{element.name}` has no `version`", fix=fix, cause=cause)

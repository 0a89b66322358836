from collections.abc import Iterator

from sdfcheck import REFUSES, Bad, Consumer, Diagnostic, Edit, Fix, Good, Root, Rule, Severity, make_fix

OLD = "gazebo"
"""The root of SDFormat before it was called so."""
FORGOTTEN = frozenset({"model", "world", OLD})


class MissingRoot(Rule):
    """The root element `sdf` is missing, or has the name that it had before SDFormat 1.3.

    libsdformat looks for `sdf` at the top of the file and refuses anything else, and so do Gazebo
    and Drake. The file begins with what belongs into it.
    """

    code = "XML011"
    name = "missing-root"
    severity = Severity.ERROR
    affects = {Consumer.GAZEBO: REFUSES, Consumer.DRAKE: REFUSES}
    looks_at = (Root,)

    bad = (
        Bad(
            '<«world» name="w"/>',
            fixed='<sdf version="1.12"><world name="w"/></sdf>',
            unsafe=True,
            file="example.sdf",
            says="`world` stands in no `sdf`",
        ),
        Bad(
            '<«gazebo» version="1.2"><model name="m"><link name="base"/></model></gazebo>',
            fixed='<sdf version="1.2"><model name="m"><link name="base"/></model></sdf>',
            unsafe=True,
            file="example.sdf",
            says="the root is called `sdf`, not `gazebo` any more",
        ),
    )
    good = (Good('<sdf version="1.12"><model name="m"><link name="base"/></model></sdf>'),)

    @staticmethod
    def applies(root: Root) -> bool:
        return not root.is_urdf and root.element.name in FORGOTTEN and root.document.kind.value == "sdf"

    def check(self, root: Root) -> Iterator[Diagnostic]:
        name = root.element.name
        if name == OLD:
            message = "the root is called `sdf`, not `gazebo` any more: readers refuse the file"
        else:
            message = f"`{name}` stands in no `sdf`: readers refuse the file"
        yield self.diagnostic(root.element, message, fix=_fix(root))


def _fix(root: Root) -> Fix | None:
    element, name = root.element, root.element.span
    end = root.document.spans.end_name(element)
    if element.name == OLD:
        edits = [Edit(name, "sdf")] + ([] if end is None else [Edit(end, "sdf")])
        return make_fix("rename it to `sdf`", tuple(edits), unsafe=True)
    text = root.document.source.text
    close = text.find(">", name.end if end is None else end.end) + 1
    if not close or (end is None and ">" in "".join(element.attributes.values())):
        return None
    before = name._replace(start=name.start - 1, end=name.start - 1)
    after = name._replace(start=close, end=close)
    edits = [Edit(before, f'<sdf version="{root.read_as}">'), Edit(after, "</sdf>")]
    return make_fix("put it into `sdf`", tuple(edits), unsafe=True)

from collections.abc import Iterator

from sdfcheck import Bad, Diagnostic, Good, Root, Rule, Severity

OLD = "gazebo"
"""The root of SDFormat before it was called so."""
FORGOTTEN = frozenset({"model", "world", OLD})


class MissingRoot(Rule):
    """The root element `sdf` is missing, or has the name that it had before SDFormat 1.3.

    libsdformat looks for `sdf` at the top of the file and refuses anything else, and so do Gazebo
    and Drake. The file begins with what belongs into it. Where the `model.config` beside it names another file for
    newer versions, this is a hint.
    """

    code = "XML011"
    name = "missing-root"
    severity = Severity.ERROR
    remedy = """Put `<sdf version="…">` around the content, or rename the root to `sdf`.

    For the version take that of the program that wrote the file; 1.9 suits Gazebo Fortress and later.
    """
    looks_at = (Root,)

    bad = (
        Bad('<«world» name="w"/>', file="example.sdf", says="`world` is not inside `sdf`"),
        Bad(
            '<«gazebo» version="1.2"><model name="m"><link name="base"/></model></gazebo>',
            file="example.sdf",
            says="the root is called `sdf`, no longer `gazebo`",
        ),
        Bad(
            '<«gazebo» version="1.2"><model name="m"><link name="base"/></model></gazebo>',
            file="old.sdf",
            files={
                "model.config": '<model><name>m</name><sdf version="1.2">old.sdf</sdf>'
                '<sdf version="1.12">m.sdf</sdf></model>',
                "m.sdf": '<sdf version="1.12"><model name="m"><link name="base"/></model></sdf>',
            },
        ),
    )
    good = (Good('<sdf version="1.12"><model name="m"><link name="base"/></model></sdf>'),)

    @staticmethod
    def applies(root: Root) -> bool:
        return not root.is_urdf and root.element.name in FORGOTTEN and root.document.kind.value == "sdf"

    def check(self, root: Root) -> Iterator[Diagnostic]:
        name = root.element.name
        if name == OLD:
            message = "the root is called `sdf`, no longer `gazebo`: simulators refuse the file"
        else:
            message = f"`{name}` is not inside `sdf`: simulators refuse the file"
        advice = "rename it to `sdf`" if name == OLD else "put `<sdf version=…>` around it"
        severity = Severity.INFO if root.is_superseded else None
        yield self.diagnostic(root.element, message, help=advice, severity=severity)

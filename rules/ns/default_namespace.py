from collections.abc import Iterator

from sdfcheck import Bad, Diagnostic, Good, PrefixDeclaration, Rule, Severity, TextEdit, make_fix


class DefaultNamespace(Rule):
    """A default namespace is declared: `xmlns="…"`.

    The custom-elements proposal does not permit it: libsdformat reads names as plain
    text and knows no default namespace. To a namespace-aware parser every element is
    then another one than the specification's.
    """

    code = "NS005"
    name = "default-namespace"
    severity = Severity.ERROR
    remedy = """Remove it, or declare a prefix instead: `xmlns:mine="…"`.

    The standard elements need no namespace at all.
    """
    looks_at = (PrefixDeclaration,)

    bad = (
        Bad(
            '<sdf version="1.12" «xmlns»="http://sdformat.org/schemas"><world name="w"/></sdf>',
            fixed='<sdf version="1.12"><world name="w"/></sdf>',
            unsafe=True,
            says="a default namespace is not permitted",
        ),
        Bad('<sdf version="1.12"><world name="w" «xmlns»=""/></sdf>'),
    )
    good = (
        Good(
            '<robot name="r" xmlns="http://www.ros.org"><link name="a"/></robot>', why="nobody minds in URDF"
        ),
        Good(
            '<sdf version="1.12" xmlns:p="https://example.org/p"><world name="w" p:kind="2d"/></sdf>',
            why="it has a prefix",
        ),
    )

    @staticmethod
    def applies(declaration: PrefixDeclaration) -> bool:
        return declaration.name == "xmlns" and declaration.document.kind.value == "sdf"

    def check(self, declaration: PrefixDeclaration) -> Iterator[Diagnostic]:
        fix = make_fix("remove it", (TextEdit(declaration.whole, ""),), unsafe=True)
        yield self.diagnostic(
            declaration, "a default namespace is not permitted; declare a prefix (`xmlns:…`)", fix=fix
        )

from collections.abc import Iterator

from sdfcheck import Bad, Diagnostic, Good, PrefixDeclaration, Rule, Severity
from sdfcheck_rules.ns.soundness import is_reserved


class EmptyNamespaceName(Rule):
    """A prefix is declared with an empty name.

    "Namespaces in XML 1.0" forbids it for a prefix. libsdformat does not look at the
    name; namespace-aware XML parsers refuse the file.
    """

    code = "NS012"
    name = "empty-namespace-name"
    severity = Severity.WARNING
    remedy = """Give the declaration a name: customary is a URI that you control.

    Nothing is fetched from it: `https://example.org/robot` serves as well as any. To be rid of a prefix,
    remove the declaration.
    """
    looks_at = (PrefixDeclaration,)

    bad = (
        Bad(
            '<sdf version="1.12" «xmlns:p»=""><world name="w" p:kind="2d"/></sdf>',
            says="prefix `p` is declared with an empty name",
        ),
    )
    good = (
        Good(
            '<sdf version="1.12" xmlns:p="p"><world name="w" p:kind="2d"/></sdf>',
            why="any text is a name, though a URI is customary",
        ),
    )

    @staticmethod
    def applies(declaration: PrefixDeclaration) -> bool:
        if declaration.namespace.strip() or not declaration.is_qualified:
            return False
        return declaration.first is None and not is_reserved(declaration)

    def check(self, declaration: PrefixDeclaration) -> Iterator[Diagnostic]:
        message = f"prefix `{declaration.prefix}` is declared with an empty name"
        yield self.diagnostic(declaration, message)

from collections.abc import Iterator

from sdfcheck import Bad, Diagnostic, Good, PrefixDeclaration, Rule, Severity


class RedeclaredPrefix(Rule):
    """One element declares the same prefix twice.

    This breaks the uniqueness rule of "Namespaces in XML", which the custom-elements
    proposal asks to comply with. It is an attribute given twice as well, for which
    every consumer refuses the file.
    """

    code = "NS004"
    name = "redeclared-prefix"
    severity = Severity.ERROR
    remedy = """Remove one of the two declarations.

    If both names are needed, give one of them another prefix.
    """
    looks_at = (PrefixDeclaration,)

    bad = (
        Bad(
            '<sdf version="1.12">'
            '<model name="m" xmlns:p="https://example.org/p" «xmlns:p»="https://example.org/q">'
            '<link name="l" p:color="red"/></model></sdf>',
            says="prefix `p` is declared twice",
        ),
    )
    good = (
        Good(
            '<sdf version="1.12"><world name="w">'
            '<light name="a" type="point" xmlns:p="https://example.org/p" p:kind="1"/>'
            '<light name="b" type="point" xmlns:p="https://example.org/p" p:kind="2"/></world></sdf>',
            why="on two elements, with scopes of their own",
        ),
    )

    @staticmethod
    def applies(declaration: PrefixDeclaration) -> bool:
        return declaration.first is not None

    def check(self, declaration: PrefixDeclaration) -> Iterator[Diagnostic]:
        message = f"prefix `{declaration.prefix}` is declared twice on one element"
        yield self.diagnostic(declaration, message, labels={declaration.first: "first declared here"})

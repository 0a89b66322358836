from collections.abc import Iterator

from sdfcheck import Bad, Diagnostic, Good, PrefixDeclaration, Rule, Severity
from sdfcheck_rules.ns.soundness import is_sound


class ShadowedPrefix(Rule):
    """A prefix is bound to another name inside its own scope, or two prefixes to one name.

    XML allows both. libsdformat and Drake go by the prefix alone, so that two meanings
    of one prefix, or two spellings of one meaning, are a mistake in waiting.
    """

    code = "NS011"
    name = "shadowed-prefix"
    severity = Severity.WARNING
    remedy = "Bind each prefix to one name, and each name to one prefix, on the root element."
    looks_at = (PrefixDeclaration,)

    bad = (
        Bad(
            '<sdf version="1.12" xmlns:p="https://example.org/p"><world name="w" p:kind="2d">'
            '<light name="l" type="point" «xmlns:p»="https://example.org/q" p:kind="2d"/></world></sdf>',
            says="prefix `p` gets another name inside its own scope",
        ),
        Bad(
            '<sdf version="1.12" xmlns:p="https://example.org/p" «xmlns:q»="https://example.org/p">'
            '<world name="w" p:kind="2d" q:size="3"/></sdf>',
            says="prefix `q` is bound to the same namespace as `p`",
        ),
    )
    good = (
        Good(
            '<sdf version="1.12" xmlns:p="https://example.org/p"><world name="w" p:kind="2d">'
            '<light name="l" type="point" xmlns:p="https://example.org/p" p:kind="2d"/></world></sdf>',
            why="declared again with the same name",
        ),
    )

    @staticmethod
    def applies(declaration: PrefixDeclaration) -> bool:
        outer = declaration.outer
        is_rival = declaration.twin is not None if outer is None else outer.namespace != declaration.namespace
        return is_rival and is_sound(declaration)

    def check(self, declaration: PrefixDeclaration) -> Iterator[Diagnostic]:
        outer, twin, prefix = declaration.outer, declaration.twin, declaration.prefix
        if outer is not None:
            message = f"prefix `{prefix}` gets another name inside its own scope"
            yield self.diagnostic(declaration, message, labels={outer: "declared with another name here"})
        elif twin is not None:
            message = f"prefix `{prefix}` is bound to the same namespace as `{twin.prefix}`"
            yield self.diagnostic(declaration, message, labels={twin: "the other prefix"})

from collections.abc import Iterator

from sdfcheck import Bad, Diagnostic, Good, PrefixDeclaration, PrefixedName, Rule, Severity
from sdfcheck_rules.ns.soundness import is_reserved


class ReservedPrefix(Rule):
    """The prefix `xml` or `xmlns`, or its name, is used for something else.

    "Namespaces in XML" reserves both prefixes and their names: `xml` need not be
    declared, `xmlns` must not. Namespace-aware XML parsers refuse the file.
    """

    code = "NS013"
    name = "reserved-prefix"
    severity = Severity.ERROR
    remedy = """Choose another prefix, and a name of your own for it.

    `xml:lang` and the like need no declaration: remove it.
    """
    looks_at = (PrefixDeclaration, PrefixedName)

    bad = (
        Bad(
            '<sdf version="1.12" «xmlns:xml»="https://example.org/p"><world name="w"/></sdf>',
            says="prefix `xml` is reserved",
        ),
        Bad(
            '<sdf version="1.12" «xmlns:xmlns»="https://example.org/p"><world name="w"/></sdf>',
            says="prefix `xmlns` is reserved",
        ),
        Bad(
            '<sdf version="1.12" «xmlns:p»="http://www.w3.org/2000/xmlns/">'
            '<world name="w" p:kind="2d"/></sdf>',
            says="the name of prefix `p` is reserved",
        ),
        Bad(
            '<sdf version="1.12"><world name="w"><«xmlns»:kind/></world></sdf>',
            says="prefix `xmlns` is reserved",
        ),
    )
    good = (
        Good(
            '<sdf version="1.12" xmlns:xml="http://www.w3.org/XML/1998/namespace"><world name="w"/></sdf>',
            why="superfluous, and right",
        ),
    )

    @staticmethod
    def applies(named: PrefixDeclaration | PrefixedName) -> bool:
        if not named.is_qualified:
            return False
        if isinstance(named, PrefixedName):
            return named.prefix == "xmlns"
        return is_reserved(named) and named.first is None

    def check(self, named: PrefixDeclaration | PrefixedName) -> Iterator[Diagnostic]:
        prefix = named.prefix
        what = f"prefix `{prefix}`" if prefix in {"xml", "xmlns"} else f"the name of prefix `{prefix}`"
        place = named.prefix_span if isinstance(named, PrefixedName) else named.span
        yield self.diagnostic(place, f"{what} is reserved for XML itself")

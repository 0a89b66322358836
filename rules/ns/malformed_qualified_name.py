from collections.abc import Iterator

from sdfcheck import Bad, Diagnostic, Good, PrefixDeclaration, PrefixedName, Rule, Severity


class MalformedQualifiedName(Rule):
    """A name has more than one colon, or no name before or after it.

    A prefixed name is a prefix, one colon and a local part. libsdformat takes whatever
    has a colon for somebody's own; namespace-aware XML parsers refuse the file.
    """

    code = "NS008"
    name = "malformed-qualified-name"
    severity = Severity.ERROR
    remedy = """Write one prefix, one colon and one name: `mine:color`.

    Deeper structure is expressed by elements within each other, not by more colons.
    """
    looks_at = (PrefixDeclaration, PrefixedName)

    bad = (
        Bad(
            '<sdf version="1.12" xmlns:p="https://example.org/p"><world name="w"><«p:a:b»/></world></sdf>',
            says="`p:a:b` has 2 colons",
        ),
        Bad(
            '<sdf version="1.12" «xmlns:p:q»="https://example.org/p"><world name="w"/></sdf>',
            says="`xmlns:p:q` has 2 colons",
        ),
        Bad('<sdf version="1.12"><world name="w" «:kind»="2d"/></sdf>', says="has nothing before its colon"),
        Bad('<sdf version="1.12"><world name="w"><«p:»/></world></sdf>', says="has nothing after its colon"),
        Bad(
            '<sdf version="1.12" xmlns:p="https://example.org/p"><world name="w"><«p:1a»/></world></sdf>',
            says="`p:1a` has `1` after its colon, where a name cannot begin",
        ),
    )
    good = (
        Good('<sdf version="1.12" xmlns:p="https://example.org/p"><world name="w"><p:a.b-c/></world></sdf>'),
        Good(
            '<sdf version="1.12"><world name="w"><plugin name="p" filename="p">'
            "<gz::system_priority>1</gz::system_priority>"
            "</plugin></world></sdf>",
            why="gz-sim reads this setting by just that name",
        ),
    )

    @staticmethod
    def applies(named: PrefixDeclaration | PrefixedName) -> bool:
        if isinstance(named, PrefixedName):
            return not named.is_qualified and not named.is_in_plugin
        return not named.is_qualified and named.name != "xmlns"

    def check(self, named: PrefixDeclaration | PrefixedName) -> Iterator[Diagnostic]:
        name = named.name
        if name.count(":") > 1:
            fault = f"has {name.count(':')} colons, and one is allowed"
        elif ":" in name.strip(":"):
            fault = f"has `{name.partition(':')[2][0]}` after its colon, where a name cannot begin"
        else:
            fault = f"has nothing {'before' if name.startswith(':') else 'after'} its colon"
        yield self.diagnostic(named, f"`{name}` {fault}")

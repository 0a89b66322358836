from collections.abc import Iterator

from sdfcheck import Bad, Diagnostic, Good, PrefixedName, Rule, Severity


class AmbiguousAttribute(Rule):
    """An element has the same attribute twice, by two prefixes of one namespace.

    "Namespaces in XML" forbids it: both names mean the same, and nobody can know which value
    counts. libsdformat, Drake, MuJoCo and urdfdom compare names as they are written and read the
    file, but every namespace-aware XML parser (Python's and lxml among them) refuses it.
    """

    code = "NS014"
    name = "ambiguous-attribute"
    severity = Severity.ERROR
    remedy = "Remove one of the two attributes, and one of the two prefixes."
    looks_at = (PrefixedName,)

    bad = (
        Bad(
            '<sdf version="1.12" xmlns:p="https://example.org/p"><world name="w">'
            '<light xmlns:q="https://example.org/p" name="l" type="point" p:kind="1" «q:kind»="2"/></world></sdf>',
            says="`q:kind` is the same attribute as `p:kind`",
            also=("NS011",),
        ),
    )
    good = (
        Good(
            '<sdf version="1.12" xmlns:p="https://example.org/p" xmlns:q="https://example.org/q">'
            '<world name="w"><light name="l" type="point" p:kind="1" q:kind="2" kind="3"/></world></sdf>',
            why="the namespaces differ",
        ),
        Good(
            '<sdf version="1.12" xmlns:p="https://example.org/p"><world name="w">'
            '<light xmlns:q="https://example.org/p" name="l" type="point" p:kind="1"/><light name="m" type="point" '
            'p:kind="2"/></world></sdf>',
            why="on two elements",
        ),
    )

    @staticmethod
    def applies(named: PrefixedName) -> bool:
        return named.first is not None

    def check(self, named: PrefixedName) -> Iterator[Diagnostic]:
        first = named.first
        if first is not None:
            message = (
                f"`{named.name}` is the same attribute as `{first.name}`: the prefixes name one namespace"
            )
            yield self.diagnostic(named, message, labels={first: "given here as well"})

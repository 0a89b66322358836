from collections.abc import Iterator

from sdfcheck import Bad, Diagnostic, Good, Prefix, PrefixDeclaration, Rule, Severity, TextEdit, make_fix


class PrefixDeclaredBelowRoot(Rule):
    """A prefix is declared on another element than the root.

    It is allowed. The custom-elements proposal advises to declare prefixes on the root
    only, where they are found at once and hold for the whole file.
    """

    code = "NS006"
    name = "prefix-declared-below-root"
    severity = Severity.INFO
    remedy = "Move the declaration to the root element."
    looks_at = (Prefix,)

    bad = (
        Bad(
            '<sdf version="1.12"><world name="w" «xmlns:p»="https://example.org/p">'
            "<p:kind>2d</p:kind></world></sdf>",
            fixed='<sdf version="1.12" xmlns:p="https://example.org/p"><world name="w">'
            "<p:kind>2d</p:kind></world></sdf>",
            says="prefix `p` is declared below the root",
        ),
        Bad(
            '<sdf version="1.12"><world name="w">'
            '<light name="a" type="point" «xmlns:p»="https://example.org/p" p:kind="1"/>'
            '<light name="b" type="point" xmlns:p="https://example.org/p" p:kind="2"/></world></sdf>',
            fixed='<sdf version="1.12" xmlns:p="https://example.org/p"><world name="w">'
            '<light name="a" type="point" p:kind="1"/>'
            '<light name="b" type="point" p:kind="2"/></world></sdf>',
            says="2 times",
        ),
    )
    good = (
        Good('<sdf version="1.12" xmlns:p="https://example.org/p"><world name="w" p:kind="2d"/></sdf>'),
        Good(
            '<sdf version="1.12"><world name="w">'
            '<light name="a" type="point" xmlns:p="https://example.org/p" p:x="1"/>'
            '<light name="b" type="point" p:x="1"/></world></sdf>',
            why="undeclared-prefix reports the scope that is too small",
        ),
        Good(
            '<sdf version="1.12"><world name="w" xmlns:p="https://example.org/p" xmlns:p="https://example.org/q">'
            "<p:kind>2d</p:kind></world></sdf>",
            why="redeclared-prefix reports it, and which of the two is meant is open",
        ),
    )

    @staticmethod
    def applies(prefix: Prefix) -> bool:
        return not prefix.undeclared and bool(_below(prefix))

    def check(self, prefix: Prefix) -> Iterator[Diagnostic]:
        message = f"prefix `{prefix.name}` is declared below the root element"
        below = _below(prefix)
        if len({declaration.namespace for declaration in prefix.declarations}) > 1:
            for declaration in below:
                yield self.diagnostic(declaration, message)
            return
        edits = [TextEdit(declaration.whole, "") for declaration in below]
        title = "remove it, the root element has it"
        if not prefix.declarations[0].is_on_root:
            edits.insert(0, TextEdit(prefix.insertion, f" {below[0].whole.text.strip()}"))
            title = "declare it on the root element"
        if len(below) > 1:
            message += f" {len(below)} times"
        yield self.diagnostic(below[0], message, fix=make_fix(title, tuple(edits)))


def _below(prefix: Prefix) -> list[PrefixDeclaration]:
    """The declarations below the root that something uses."""
    below = [each for each in prefix.declarations if each.is_used and not each.is_on_root]
    return [] if any(each.is_repeated for each in prefix.declarations) else below

from collections.abc import Iterator

from sdfcheck import Bad, Diagnostic, Good, PrefixDeclaration, Rule, Severity, TextEdit, make_fix, named
from sdfcheck_rules.ns.soundness import is_sound


class UnusedPrefix(Rule):
    """A prefix is declared and not used.

    It does no harm, but says that the file holds something that it does not. In SDFormat a prefix of xacro is a
    warning: nobody expands the file, and libsdformat before version 9 warns of the attribute, which it does not know.
    """

    code = "NS007"
    name = "unused-prefix"
    severity = Severity.INFO
    remedy = """Remove the declaration.

    If the prefix was meant for something, write it before the names of those elements.
    """
    looks_at = (PrefixDeclaration,)

    bad = (
        Bad(
            '<sdf version="1.12" «xmlns:p»="https://example.org/p"><world name="w"/></sdf>',
            fixed='<sdf version="1.12"><world name="w"/></sdf>',
            says="prefix `p` is declared and not used",
        ),
        Bad(
            '<robot name="r" «xmlns:xacro»="http://www.ros.org/wiki/xacro"><link name="l"/></robot>',
            fixed='<robot name="r"><link name="l"/></robot>',
        ),
        Bad(
            '<sdf version="1.6" «xmlns:xacro»="http://www.ros.org/wiki/xacro"><world name="w"/></sdf>',
            fixed='<sdf version="1.6"><world name="w"/></sdf>',
        ),
        Bad(
            '<robot name="r" «xmlns:controller»="https://example.org/c" xmlns:sensor="https://example.org/s"'
            ' xmlns:interface="https://example.org/i"><link name="l"/></robot>',
            fixed='<robot name="r"><link name="l"/></robot>',
            says="prefixes `controller`, `sensor` and `interface` are declared and not used",
        ),
    )
    good = (
        Good(
            '<sdf version="1.12" xmlns:p="https://example.org/p"><world name="w" p:kind="2d"/></sdf>',
            why="an attribute uses it",
        ),
        Good(
            '<sdf version="1.12" xmlns:p="https://example.org/p"><world name="w" xmlns:p="https://example.org/p">'
            "<p:kind>2d</p:kind></world></sdf>",
            why="prefix-declared-below-root reports the second declaration, which says the same",
        ),
    )

    @staticmethod
    def applies(declaration: PrefixDeclaration) -> bool:
        # The files that an xacro file includes may use what it declares.
        if declaration.is_used or declaration.document.kind.value == "xacro":
            return False
        return _unused(declaration)[:1] == [declaration]

    def check(self, declaration: PrefixDeclaration) -> Iterator[Diagnostic]:
        unused = _unused(declaration)
        removed = tuple(TextEdit(each.whole, "") for each in unused)
        prefixes = named([each.prefix for each in unused], most=5)
        if len(removed) == 1:
            what, title = f"prefix {prefixes} is", "remove the declaration"
        else:
            what, title = f"prefixes {prefixes} are", "remove the declarations"
        document = declaration.document
        is_foreign = document.kind.value == "sdf" and any(each.prefix == "xacro" for each in unused)
        yield self.diagnostic(
            declaration,
            f"{what} declared and not used",
            severity=Severity.WARNING if is_foreign and not document.is_made_by_xacro else self.severity,
            fix=make_fix(title, removed),
        )


def _unused(declaration: PrefixDeclaration) -> list[PrefixDeclaration]:
    """The declarations of an element that nothing uses."""
    return [each for each in declaration.beside if not each.is_used and is_sound(each)]

from collections.abc import Iterator

from sdfcheck import IN_MODEL, Bad, Diagnostic, Good, Name, Root, Rule, Severity, replace


class BlankAroundName(Rule):
    """A name in SDFormat begins or ends with a space.

    libsdformat takes it off from the name and from what refers to it. Plugins, scripts and
    other programs that compare names as they are written find nothing.
    """

    code = "NAM007"
    name = "blank-around-name"
    severity = Severity.WARNING
    remedy = """Remove the space from the name.

    If it comes from an expression of xacro, remove it in the property or argument that the name is made of.
    """
    looks_at = (Root,)
    scaffold = IN_MODEL

    bad = (
        Bad('<link name="« tip»"/>', fixed='<link name="tip"/>', says="a space before the name `tip`"),
        Bad('<frame name="«tool »"/>', fixed='<frame name="tool"/>', says="a space after the name `tool`"),
    )
    good = (
        Good('<link name="left tip"/>', why="a space inside a name belongs to it"),
        Good('<robot name="r"><link name=" a"/></robot>', scaffold="", why="consumers of URDF keep it"),
    )

    @staticmethod
    def applies(root: Root) -> bool:
        return any(map(_is_standard, root.names.padded))

    def check(self, root: Root) -> Iterator[Diagnostic]:
        for given in filter(_is_standard, root.names.padded):
            where = "before" if given.value.text[0].isspace() else "after"
            fix = replace(given.value, given.name, f"write `{given.name}`")
            yield self.diagnostic(given.value, f"a space {where} the name `{given.name}`", fix=fix)


def _is_standard(name: Name) -> bool:
    """The names of custom elements are free."""
    return ":" not in name.kind

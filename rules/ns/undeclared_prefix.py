from collections.abc import Iterator

from sdfcheck import Bad, Diagnostic, Fix, Good, Prefix, Rule, Severity, TextEdit, make_fix, used

# Prefixes whose namespace names their vendors have settled.
WELL_KNOWN = {
    "drake": "http://drake.mit.edu",
    "experimental": "http://sdformat.org/schemas/experimental",
    "gz": "http://gazebosim.org/schema",
    "ignition": "http://ignitionrobotics.org/schema",
}
MASS = '<inertial><mass value="1"/><inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial>'


class UndeclaredPrefix(Rule):
    """A prefix is used where no declaration of it is in scope.

    A declaration holds from its own start tag to the matching end tag, no further. The
    custom-elements proposal asks for declared prefixes and advises to declare them on
    the root element. libsdformat and Drake read prefixes as plain text and do not mind,
    but every namespace-aware XML parser (Python's among them) refuses the file: an error,
    though a simulator may never meet it.
    """

    code = "NS003"
    name = "undeclared-prefix"
    severity = Severity.ERROR
    remedy = """Declare the prefix on the root element: `xmlns:mine="…"`.

    The value is a name that nobody else uses, customarily a URI that you control; nothing is fetched from
    it. A fragment that is included as text needs the declaration itself.
    """
    looks_at = (Prefix,)

    bad = (
        Bad(
            '<sdf version="1.12"><world name="w"><«gz»:note>hello</gz:note></world></sdf>',
            fixed='<sdf version="1.12" xmlns:gz="http://gazebosim.org/schema">'
            '<world name="w"><gz:note>hello</gz:note></world></sdf>',
            says="prefix `gz` is not declared",
        ),
        Bad(
            '<sdf version="1.12"><world name="w">'
            '<model name="a" xmlns:flatland="https://example.org/f"><link name="l"/>'
            "<flatland:kind>a</flatland:kind></model>"
            '<model name="b"><link name="l"/><«flatland»:kind>b</flatland:kind></model></world></sdf>',
            fixed='<sdf version="1.12" xmlns:flatland="https://example.org/f"><world name="w">'
            '<model name="a" xmlns:flatland="https://example.org/f"><link name="l"/>'
            "<flatland:kind>a</flatland:kind></model>"
            '<model name="b"><link name="l"/><flatland:kind>b</flatland:kind></model></world></sdf>',
            says="not declared here",
        ),
        Bad(
            '<sdf version="1.12"><model name="m">'
            '<link name="l" «mine»:color="red" mine:size="2"/></model></sdf>',
            says="used 2 times",
        ),
        Bad(
            f'<robot name="r"><link name="l">{MASS}</link><«gz»:note/></robot>',
            fixed=f'<robot name="r" xmlns:gz="http://gazebosim.org/schema"><link name="l">{MASS}</link>'
            "<gz:note/></robot>",
            says="prefix `gz` is not declared",
        ),
    )
    good = (
        Good(
            '<sdf version="1.12" xmlns:p="https://example.org/p"><model name="m">'
            '<link name="l" p:x="1"/></model></sdf>',
            why="declared on the root",
        ),
        Good(
            '<sdf version="1.12"><model name="m" xml:lang="en"><link name="l"/></model></sdf>',
            why="xml needs no declaration",
        ),
    )

    @staticmethod
    def applies(prefix: Prefix) -> bool:
        # Without its own prefix xacro does nothing, which is another matter.
        return bool(prefix.undeclared) and (prefix.name != "xacro" or prefix.document.kind.value != "xacro")

    def check(self, prefix: Prefix) -> Iterator[Diagnostic]:
        name, times = prefix.name, used(len(prefix.undeclared))
        elsewhere = prefix.declarations[0] if prefix.declarations else None
        namespace = (elsewhere.namespace if elsewhere else "") or WELL_KNOWN.get(name, "")
        fix: Fix | None = None
        advice: str | None = f'declare it on the root element: xmlns:{name}="…"'
        if namespace:
            advice = None
            declaration = TextEdit(prefix.insertion, f' xmlns:{name}="{namespace}"')
            fix = make_fix("declare it on the root element", (declaration,))
        if elsewhere is None:
            message = f"prefix `{name}` is not declared{times}"
            yield self.diagnostic(prefix.undeclared[0], message, fix=fix, help=advice)
            return
        labels = {elsewhere: f"declared here, in scope until line {elsewhere.scope_end.begin.line}"}
        message = f"prefix `{name}` is not declared here{times}"
        yield self.diagnostic(prefix.undeclared[0], message, labels=labels, fix=fix, help=advice)

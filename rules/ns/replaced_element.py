from collections.abc import Iterator

from sdfcheck import IN_COLLISION, IN_JOINT, IN_MODEL, Bad, Custom, Diagnostic, Good, Rule, Severity


class ReplacedElement(Rule):
    """A custom element replaces a required standard one.

    Custom elements may add information, and may not replace any: a shape with
    `<p:diameter>` must have `<radius>` as well (custom-elements proposal). Consumers
    that do not know the prefix take the default. `sdf` is a prefix as all others: nobody reads `<sdf:model>`.
    """

    code = "NS010"
    name = "replaced-element"
    severity = Severity.ERROR
    remedy = """Write the standard element as well, beside your own.

    Consumers that know your prefix may prefer it; all others read the standard one. Keep both equal, for
    example with a property of xacro.
    """
    looks_at = (Custom,)
    scaffold = IN_COLLISION

    bad = (
        Bad(
            '<geometry><cylinder><«p:diameter» xmlns:p="https://example.org/p">2</p:diameter>'
            "<length>1</length></cylinder></geometry>",
            says="`cylinder` has no `radius`; `p:diameter` cannot replace it",
        ),
        Bad(
            '<sdf version="1.7" xmlns:sdf="http://sdformat.org"><«sdf:model» name="m"/></sdf>',
            scaffold="",
            says="`sdf` has no `model`; `sdf:model` cannot replace it",
        ),
        Bad(
            '<axis><«p:xyz» xmlns:p="https://example.org/p">0 1 0</p:xyz></axis>',
            scaffold=IN_JOINT,
            says="`axis` has no `xyz`",
        ),
        Bad(
            '<include xmlns:experimental="http://sdformat.org/schemas/experimental"><uri>model://arm</uri>'
            '<experimental:params><joint element_id="j"><axis action="replace">'
            '<«p:xyz» xmlns:p="https://example.org/p">0 1 0</p:xyz></axis></joint></experimental:params></include>',
            scaffold=IN_MODEL,
            says="`axis` has no `xyz`",
        ),
    )
    good = (
        Good(
            '<geometry><cylinder><p:diameter xmlns:p="https://example.org/p">2</p:diameter>'
            "<radius>1</radius><length>1</length></cylinder></geometry>",
            why="it only adds",
        ),
    )

    @staticmethod
    def applies(custom: Custom) -> bool:
        return bool(custom.replaced)

    def check(self, custom: Custom) -> Iterator[Diagnostic]:
        element = custom.element.parent
        if element is None:
            return
        for name in custom.replaced:
            yield self.diagnostic(
                custom,
                f"{element.title} has no `{name}`; `{custom.tag}` cannot replace it",
                labels={element: f"`{name}` is missing here"},
            )

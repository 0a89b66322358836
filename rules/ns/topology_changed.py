from collections.abc import Iterator

from sdfcheck import IN_MODEL, Bad, Custom, Diagnostic, Good, Rule, Severity


class TopologyChanged(Rule):
    """A standard element is inside a custom one, where no simulator looks for it.

    Custom elements add to a document; the custom-elements proposal does not permit that
    they change which standard element is whose child. Links that are wrapped in
    `<p:group>` are lost to every simulator in silence, and so are a mass or a shape. A setting that the
    format does not require counts if it says something else than its default, is not given beside the
    custom element as well, and the custom element is a mere wrapper: then it is a warning. Content that
    only borrows a name, beside content or attributes of a custom element's own, is free.
    """

    code = "NS009"
    name = "topology-changed"
    severity = Severity.ERROR
    remedy = """Move the standard element out of the custom one, into the element that it belongs to.

    To group links, keep them in the model and let the custom element name them:
    `<mine:group links="upper lower"/>`.
    """
    looks_at = (Custom,)
    scaffold = IN_MODEL

    bad = (
        Bad(
            '<p:kinematic_links xmlns:p="https://example.org/p"><«link» name="L1"/></p:kinematic_links>',
            says="link `L1` is inside the custom element `p:kinematic_links`, where no simulator finds it",
        ),
        Bad(
            '<p:a xmlns:p="https://example.org/p"><p:b><«frame» name="f" attached_to="base"/></p:b></p:a>',
            says="frame `f` is inside the custom element `p:a`",
        ),
        Bad(
            '<p:a xmlns:p="https://example.org/p"><«static»>true</static></p:a>',
            says="`static` is inside the custom element `p:a`",
        ),
        Bad(
            '<link name="l"><collision name="c"><geometry><p:a xmlns:p="https://example.org/p">'
            "<«sphere»><radius>2</radius></sphere></p:a></geometry></collision></link>",
            says="`sphere` is inside",
            also=("FRM012",),
        ),
        Bad(
            '<robot name="r" xmlns:p="https://example.org/p"><link name="a"/>'
            '<p:a><«link» name="b"/></p:a></robot>',
            scaffold="",
            says="link `b` is inside",
        ),
        Bad(
            '<robot name="r" xmlns:p="https://example.org/p"><link name="a"/><link name="b"/>'
            '<joint name="j" type="prismatic"><parent link="a"/><child link="b"/>'
            '<p:a><«axis» xyz="0 0 1"/></p:a><limit lower="0" upper="1" effort="1" velocity="1"/></joint></robot>',
            scaffold="",
            says="`axis` is inside",
        ),
        Bad(
            '<include xmlns:experimental="http://sdformat.org/schemas/experimental"><uri>model://arm</uri>'
            '<experimental:params><link name="a" element_id="" action="add">'
            '<p:g xmlns:p="https://example.org/p"><«collision» name="c"><geometry><empty/></geometry></collision>'
            "</p:g></link></experimental:params></include>",
            says="collision `c` is inside the custom element `p:g`",
        ),
    )
    good = (
        Good(
            '<f:transmission xmlns:f="https://example.org/f" name="t"><f:joint name="j">'
            "<f:interface>effort</f:interface>"
            "</f:joint></f:transmission>",
            why="the names have prefixes of their own",
        ),
        Good(
            '<p:drive xmlns:p="https://example.org/p"><joint gear="3">left_wheel</joint></p:drive>',
            why="it borrows only the name",
        ),
        Good(
            '<p:grasp xmlns:p="https://example.org/p"><link name="base"/></p:grasp>',
            why="a reference to a link",
        ),
        Good(
            '<p:motor xmlns:p="https://example.org/p"><static>true</static><gain>3</gain></p:motor>',
            why="a setting of the custom element, beside another one",
        ),
        Good(
            '<p:a xmlns:p="https://example.org/p"><static>false</static></p:a>', why="says what holds anyway"
        ),
    )

    @staticmethod
    def applies(custom: Custom) -> bool:
        return bool(custom.displaced)

    def check(self, custom: Custom) -> Iterator[Diagnostic]:
        parent = custom.element.parent
        for element, is_needed in custom.displaced if parent is not None else ():
            place = parent.title if parent is not None else ""
            yield self.diagnostic(
                element,
                f"{element.title} is inside the custom element `{custom.tag}`, where no simulator finds it",
                severity=None if is_needed else Severity.WARNING,
                labels={custom: f"`{element.name}` belongs directly in {place}"},
            )

from collections.abc import Iterator

from sdfcheck import IN_MODEL, Bad, Consumer, Custom, Diagnostic, Good, Rule, Severity, warns


class TopologyChanged(Rule):
    """A standard element stands inside a custom one, where no reader looks for it.

    Custom elements add to a document; the custom-elements proposal does not permit that
    they change which standard element is whose child. Links that are wrapped in
    `<p:group>` are lost to libsdformat and Drake without a word. Content that only
    borrows a name, with a custom element's own attributes, is free.
    """

    code = "NS009"
    name = "topology-changed"
    severity = Severity.ERROR
    affects = {
        Consumer.GAZEBO: warns("does not see the element"),
        Consumer.DRAKE: warns("does not see the element"),
    }
    looks_at = (Custom,)
    scaffold = IN_MODEL

    bad = (
        Bad(
            '<p:kinematic_links xmlns:p="https://example.org/p"><«link» name="L1"/></p:kinematic_links>',
            says="link `L1` stands in the custom element `p:kinematic_links`, where no reader finds it",
        ),
        Bad(
            '<p:a xmlns:p="https://example.org/p"><p:b><«frame» name="f" attached_to="base"/></p:b></p:a>',
            says="frame `f` stands in the custom element `p:a`",
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
    )

    @staticmethod
    def applies(custom: Custom) -> bool:
        return bool(custom.displaced)

    def check(self, custom: Custom) -> Iterator[Diagnostic]:
        parent = custom.element.parent
        for element in custom.displaced if parent is not None else ():
            yield self.diagnostic(
                element,
                f"{element.title} stands in the custom element `{custom.tag}`, where no reader finds it",
                labels={
                    custom: f"`{element.name}` belongs directly in {parent.title if parent is not None else ''}"
                },
            )

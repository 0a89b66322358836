from collections.abc import Iterator

from sdfcheck import IN_ROBOT, Bad, Diagnostic, Good, Joint, Link, Rule, Severity


class BlankInName(Rule):
    """The name of a link or joint has a space in it.

    The consumers of URDF take it, and names of frames, topics and parameters are made of it later, where a
    blank is not allowed or separates two names.
    """

    code = "URD022"
    name = "blank-in-name"
    severity = Severity.INFO
    remedy = """Replace the space by an underscore, in the name and in all that refers to it.

    Editors with the language server of sdfcheck rename both at once.
    """
    sources = ("https://design.ros2.org/articles/topic_and_service_names.html",)
    looks_at = (Link, Joint)
    selects = ("urdf:robot/link", "urdf:robot/joint")
    scaffold = IN_ROBOT

    bad = (
        Bad(
            '<link name="«big arm»"/><joint name="j" type="fixed"><parent link="base"/>'
            '<child link="big arm"/></joint>',
            says="the name of link `big arm` has a space in it",
        ),
    )
    good = (
        Good(
            '<link name="big_arm"/><joint name="j" type="fixed"><parent link="base"/><child link="big_arm"/></joint>'
        ),
    )

    @staticmethod
    def applies(node: Link | Joint) -> bool:
        return " " in node.name

    def check(self, node: Link | Joint) -> Iterator[Diagnostic]:
        yield self.diagnostic(node.name_value or node, f"the name of {node.title} has a space in it")

from collections.abc import Iterator

from sdfcheck import IN_ROBOT, Bad, Diagnostic, Good, Joint, Link, Rule, Severity, write_instead


class BlankInName(Rule):
    """The name of a link or joint has a space in it.

    The consumers of URDF take it, and names of frames, topics and parameters are made of it later, where a
    blank is not allowed or separates two names. One before or after the name is seldom meant: it is part of the
    name, and what looks for the name without it finds nothing.
    """

    code = "URD022"
    name = "blank-in-name"
    severity = Severity.INFO
    remedy = """Remove the space, or replace one inside the name by an underscore, and so in all that refers to it.

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
        Bad(
            '<link name="arm"/><joint name="«j »" type="fixed"><parent link="base"/><child link="arm"/></joint>',
            fixed='<link name="arm"/><joint name="j" type="fixed"><parent link="base"/><child link="arm"/></joint>',
            unsafe=True,
            says="a space after the name `j`, which is part of it in URDF",
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
        value, name = node.name_value, node.name.strip()
        if value is None or not name or name == node.name:
            yield self.diagnostic(value or node, f"the name of {node.title} has a space in it")
            return
        where = "before" if node.name[0].isspace() else "after"
        message = f"a space {where} the name `{name}`, which is part of it in URDF"
        yield self.diagnostic(value, message, fix=write_instead(name, value), severity=Severity.WARNING)

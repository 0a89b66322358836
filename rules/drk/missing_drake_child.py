from collections.abc import Iterator

from sdfcheck import Bad, Diagnostic, Good, Severity, VendorRule, VendorTag
from sdfcheck_rules.drk.scaffolds import LINK, MODEL, ROBOT

PLANAR = '<drake:joint name="j" type="planar"><drake:parent>a</drake:parent><drake:child>b</drake:child>'


class MissingDrakeChild(VendorRule):
    """One of Drake's elements lacks a child that Drake asks for.

    Drake knows no defaults for these: it refuses the file, or aborts in an assertion that names no place.
    """

    code = "DRK004"
    name = "missing-drake-child"
    severity = Severity.ERROR
    remedy = """Write the missing child: Drake has no default for it.

    `sdfcheck describe drake:NAME` lists the children. If the whole element is not needed, remove it.
    """
    prefix = "drake"
    looks_at = (VendorTag,)
    scaffold = MODEL

    bad = (
        Bad(
            PLANAR.replace("<drake:joint", "<«drake:joint»") + "</drake:joint>",
            says="drake:joint `j` lacks `drake:damping`: Drake refuses the file",
        ),
        Bad(
            PLANAR.replace("<drake:child>", "<«child»>").replace("</drake:child>", "</child>")
            + "<drake:damping>0 0 0</drake:damping></drake:joint>",
            fixed=PLANAR + "<drake:damping>0 0 0</drake:damping></drake:joint>",
            unsafe=True,
            says="did you mean `drake:child`?",
        ),
        Bad(
            '<«drake:collision_filter_group» name="g"/>', says="lacks `drake:member` or `drake:member_group`"
        ),
        Bad('<«drake:visual» name="v"/>', says="lacks `drake:geometry`: Drake aborts", scaffold=LINK),
        Bad(
            '<«drake:joint» name="s" type="screw"><parent link="a"/><child link="b"/></drake:joint>',
            says="lacks `drake:screw_thread_pitch`",
            scaffold=ROBOT,
        ),
    )
    good = (
        Good(PLANAR + "<drake:damping>0 0 0</drake:damping></drake:joint>"),
        Good(
            '<drake:joint name="j" type="curvilinear"><drake:parent>a</drake:parent>'
            "<drake:child>b</drake:child>"
            "<drake:curves><drake:line_segment><drake:length>1</drake:length></drake:line_segment>"
            "</drake:curves></drake:joint>",
            why="only a planar joint needs damping",
        ),
        Good('<drake:collision_filter_group name="g" ignore="true"/>', why="Drake skips it"),
    )

    @staticmethod
    def applies(tag: VendorTag) -> bool:
        # One that is only misspelled is reported as such.
        return tag.prefix == "drake" and any(lack.misspelled is None for lack in tag.lacks)

    def check(self, tag: VendorTag) -> Iterator[Diagnostic]:
        yield from self.lacking_children(tag)

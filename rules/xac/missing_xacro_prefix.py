from collections.abc import Iterator

from sdfcheck import (
    Bad,
    Consumer,
    Diagnostic,
    Good,
    Rule,
    Severity,
    TextEdit,
    make_fix,
    problems,
    refuses,
    used,
)
from sdfcheck_rules.xac.scaffold import FILE, IN_XACRO
from sdfcheck_rules.xac.undefined import SHOWN

FATAL = refuses("gets no robot description")
MISSED = refuses("refuses the joint to a link that it would bring")
BARE = {Consumer.GAZEBO: refuses("refuses the file, as no link has a mass without it")}


class MissingXacroPrefix(Rule):
    """An element of xacro, or the call of a macro, lacks the prefix `xacro:`.

    Since ROS Noetic xacro leaves it in the description as it is, where no consumer knows
    it: the property is not defined, the macro not called, the block not inserted. A call is
    an element that URDF does not know, with the name and the parameters of a macro.
    """

    code = "XAC012"
    name = "missing-xacro-prefix"
    severity = Severity.ERROR
    remedy = """Write the prefix: `xacro:property`, `xacro:macro`, `xacro:wheel`.

    It belongs in the end tag as well. Files of the time before ROS Noetic lack it often.
    """
    explains = (problems.MissingXacroPrefix,)
    scaffold = IN_XACRO

    bad = (
        Bad(
            '<«property» name="w" value="1"/><link name="a${w}"/>',
            fixed='<xacro:property name="w" value="1"/><link name="a${w}"/>',
            unsafe=True,
            file=FILE,
            says="`property` without the prefix `xacro:` is left as it is",
        ),
        Bad(
            '<«property» name="w" value="1"/><property name="v" value="2"/><link name="a"/>',
            fixed='<xacro:property name="w" value="1"/><xacro:property name="v" value="2"/><link name="a"/>',
            unsafe=True,
            file=FILE,
            says="is left as it is (used 2 times)",
        ),
        Bad(
            '<xacro:macro name="leg" params="side"><link name="${side}"/></xacro:macro><«leg» side="left"/>',
            fixed='<xacro:macro name="leg" params="side"><link name="${side}"/></xacro:macro><xacro:leg side="left"/>',
            unsafe=True,
            file=FILE,
            says="`leg` without the prefix",
        ),
        Bad(
            '<«if» value="1"><link name="a"/></if><xacro:if value="1"><link name="b"/></xacro:if>',
            fixed='<xacro:if value="1"><link name="a"/></xacro:if><xacro:if value="1"><link name="b"/></xacro:if>',
            unsafe=True,
            file=FILE,
        ),
    )
    good = (
        Good(
            '<xacro:macro name="leg" params="side"><link name="${side}"/></xacro:macro>'
            '<xacro:leg side="a"/><gazebo><leg side="left"/></gazebo>',
            why="the settings of a plugin may have the name of a macro",
            file=FILE,
        ),
        Good("<include><uri>model://a</uri></include>", why="SDFormat's own", file=FILE),
        Good(
            '<plugin name="p" filename="p"><property name="w" value="1"/></plugin>',
            why="the content of a plugin is the plugin's",
            file=FILE,
        ),
    )

    def check(self, problem: problems.MissingXacroPrefix) -> Iterator[Diagnostic]:
        name = problem.name
        edits = tuple(TextEdit(span, f"xacro:{name}") for span in problem.edits)
        which = "each of them" if problem.others else "it"
        fix = make_fix(f"make {which} `xacro:{name}`", edits, unsafe=True)
        affects = BARE if problem.is_bare else None
        if problem.is_fatal or problem.is_missed:
            affects = dict.fromkeys(Consumer, FATAL if problem.is_fatal else MISSED)
        yield self.diagnostic(
            problem.span,
            f"`{name}` without the prefix `xacro:` is left as it is{used(1 + len(problem.others))}",
            labels=dict.fromkeys(problem.others[:SHOWN], "also here"),
            fix=fix,
            affects=affects,
        )

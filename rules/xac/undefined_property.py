from collections.abc import Iterator

from sdfcheck import Bad, Diagnostic, Good, Rule, Severity, problems
from sdfcheck_rules.xac.scaffold import FILE, IN_XACRO
from sdfcheck_rules.xac.undefined import report

LIBRARY = '<robot xmlns:xacro="http://www.ros.org/wiki/xacro">{}</robot>'
ARM = (
    '<robot name="arm" xmlns:xacro="http://www.ros.org/wiki/xacro"><xacro:include filename="part.urdf.xacro"/>{}'
    '<link name="base"/></robot>'
)
PACKAGE = {
    ".git/HEAD": "",
    "package.xml": "<package><name>arm</name></package>",
    "part.urdf.xacro": LIBRARY.format(""),
}


class UndefinedProperty(Rule):
    """An expression uses a name that is not a property, macro parameter or function of xacro.

    Properties are evaluated when they are first used, so a misspelled name may lie
    dormant until a macro is called in another way. The diagnostic is in the
    expression that has the name, not where its value is used. In a macro library a
    name is reported only if no file of the project defines it, and a known name is close to it or the library and
    all files that include it include nothing of other projects.
    """

    code = "XAC004"
    name = "undefined-property"
    severity = Severity.ERROR
    remedy = """Define the property before it is read, or include the file that defines it.

    `<xacro:property name="size" value="0.2"/>`. Inside a macro a value can be a parameter with a default,
    `params="size:=0.2"`. A property that a macro defines ends with it, unless it has `scope="parent"` or
    `scope="global"`. An argument is `$(arg size)`, not `${size}`.
    """
    explains = (problems.UndefinedProperty, problems.UndefinedBlock)
    scaffold = IN_XACRO

    bad = (
        Bad(
            '<xacro:property name="length" value="1"/><link name="l${«lenght»}"/>',
            fixed='<xacro:property name="length" value="1"/><link name="l${length}"/>',
            unsafe=True,
            file=FILE,
            says="did you mean `length`?",
        ),
        Bad(
            '<xacro:property name="half" value="${«size» / 2}"/><link name="l${half}"/>',
            file=FILE,
            says="`size`",
        ),
        Bad(
            '<xacro:macro name="m" params="side"><link name="${side}${«sied»}"/></xacro:macro>',
            fixed='<xacro:macro name="m" params="side"><link name="${side}${side}"/></xacro:macro>',
            unsafe=True,
            file=FILE,
            says="did you mean `side`?",
        ),
        Bad(
            '<link name="l${«size»}"/><link name="k${size}"/>',
            file=FILE,
            says="property `size` is not defined (used 2 times)",
        ),
        Bad(
            '<xacro:macro name="m" params="side"><link name="${side}${«offset»}"/></xacro:macro>',
            file="part.urdf.xacro",
            scaffold=LIBRARY,
            files={**PACKAGE, "arm.urdf.xacro": ARM.format("")},
            says="property `offset` is not defined here: macro `m` takes no such parameter",
        ),
        Bad(
            '<xacro:macro name="m" params="side"><link name="${side}${«M_PI»}"/></xacro:macro>',
            fixed='<xacro:macro name="m" params="side"><link name="${side}${pi}"/></xacro:macro>',
            unsafe=True,
            file="part.urdf.xacro",
            scaffold=LIBRARY,
            files=PACKAGE,
            says="did you mean `pi`?",
        ),
        Bad(
            '<xacro:macro name="m" params="*origin"><xacro:insert_block name="«orign»"/></xacro:macro>',
            fixed='<xacro:macro name="m" params="*origin"><xacro:insert_block name="origin"/></xacro:macro>',
            unsafe=True,
            file=FILE,
            says="block `orign` is not defined; did you mean `origin`?",
        ),
        Bad(
            '<link name="l${«size»}"/>',
            file="arm.urdf.xacro",
            files={
                **PACKAGE,
                "sizes.xacro": LIBRARY.format('<xacro:property name="size" value="1"/>'),
                "old.xacro": LIBRARY.format('<!-- <xacro:property name="size" value="1"/> -->'),
            },
            says="`sizes.xacro` defines it, and is not included",
        ),
        Bad(
            '<link name="l${«size»}"/>',
            file="arm.urdf.xacro",
            files={
                **PACKAGE,
                "wheel.xacro": LIBRARY.format(
                    '<xacro:macro name="wheel" params=""><xacro:property name="size" value="1"/></xacro:macro>'
                ),
            },
            says="property `size` is not defined",
        ),
        Bad(
            '<xacro:property name="logs" value="false"/><xacro:if value="${logs}"><link name="l${«size»}"/></xacro:if>',
            file=FILE,
            says="xacro needs it if `logs` is not `false`",
        ),
    )
    good = (
        Good('<xacro:property name="r" value="1"/><link name="l${sin(r * pi) + max(r, 2)}"/>', file=FILE),
        Good('<link name="l${[x * x for x in range(3)][0]}"/>', why="bound inside the expression", file=FILE),
        Good('<link name="l$${later}"/>', why="escaped", file=FILE),
        Good(
            '<xacro:macro name="m" params="side"><link name="${side}${offset}"/></xacro:macro>',
            why="the file that includes it defines it",
            file="part.urdf.xacro",
            scaffold=LIBRARY,
            files={**PACKAGE, "arm.urdf.xacro": ARM.format('<xacro:property name="offset" value="1"/>')},
        ),
        Good(
            '<xacro:macro name="m" params="side"><link name="${side}${offset}"/></xacro:macro>',
            why="another package, which its includer reads, may define it",
            file="part.urdf.xacro",
            scaffold=LIBRARY,
            files={
                **PACKAGE,
                "arm.urdf.xacro": ARM.format('<xacro:include filename="$(find sizes)/all.xacro"/>'),
            },
        ),
    )

    def check(self, problem: problems.UndefinedProperty | problems.UndefinedBlock) -> Iterator[Diagnostic]:
        yield report(self, problem, "block" if isinstance(problem, problems.UndefinedBlock) else "property")

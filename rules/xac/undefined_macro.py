from collections.abc import Iterator

from sdfcheck import Bad, Consumer, Diagnostic, Good, Rule, Severity, ignores, problems
from sdfcheck_rules.xac.scaffold import FILE, IN_XACRO
from sdfcheck_rules.xac.undefined import report

LIBRARY = '<robot xmlns:xacro="http://www.ros.org/wiki/xacro">{}</robot>'
STOPS = ("error", "fatal")
"""They stop xacro, as is meant: it knows none of them."""
_IGNORES = ignores("the element, unless xacro comes before it")


class UndefinedMacro(Rule):
    """A macro is called that is defined neither here nor in an included file.

    xacro stops at an element with its prefix that is neither its own nor a macro. In
    a macro library a call is reported only if no file of the project defines the macro
    and a known name that takes what the call gives is close to it: who includes the library may bring the rest.
    Where the name of the file ends in `.urdf`, simulators read it without xacro, and ignore the element.
    `xacro:error` and `xacro:fatal`, which stop xacro only as they are no macros, are a warning.
    """

    code = "XAC003"
    name = "undefined-macro"
    severity = Severity.ERROR
    remedy = """Define the macro, include the file that defines it, or call it by its right name.

    The include has to come before the call. `<xacro:include filename="$(find PACKAGE)/urdf/wheel.xacro"/>`
    is the common form.
    """
    explains = (problems.UndefinedMacro,)
    scaffold = IN_XACRO

    bad = (
        Bad(
            '<xacro:macro name="wheel" params="side"><link name="${side}"/></xacro:macro>'
            '<xacro:«weel» side="left"></xacro:weel>',
            fixed='<xacro:macro name="wheel" params="side"><link name="${side}"/></xacro:macro>'
            '<xacro:wheel side="left"></xacro:wheel>',
            unsafe=True,
            file=FILE,
            says="did you mean `wheel`?",
        ),
        Bad(
            '<xacro:«proprety» name="w" value="1"/>',
            fixed='<xacro:property name="w" value="1"/>',
            unsafe=True,
            file=FILE,
            says="did you mean `property`?",
        ),
        Bad('<xacro:«error» msg="which arm?"/>', file=FILE, says="write `${xacro.fatal('…')}` to stop"),
        Bad("<xacro:«grey»/><xacro:grey/>", file=FILE, says="macro `grey` is not defined (used 2 times)"),
        Bad(
            '<xacro:include filename="base.xacro"/><xacro:«wheel»/>',
            file="arm.urdf.xacro",
            files={
                ".git/HEAD": "",
                "base.xacro": LIBRARY.format(""),
                "parts/wheel.xacro": LIBRARY.format('<xacro:macro name="wheel" params=""/>'),
            },
            says="macro `wheel` is not defined here: `parts/wheel.xacro` defines it, and is not included",
        ),
    )
    good = (
        Good(
            '<xacro:macro name="wheel" params="side"><link name="${side}"/></xacro:macro>'
            '<xacro:wheel side="left"/>',
            file=FILE,
        ),
        Good(
            '<root xmlns:xacro="http://www.ros.org/wiki/xacro"><xacro:macro name="cart" params="">'
            "<xacro:wheel_of_somebody/></xacro:macro></root>",
            why="a library: who includes it may define the macro",
            file=FILE,
            scaffold="{}",
        ),
        Good(
            '<root xmlns:xacro="http://www.ros.org/wiki/xacro"><xacro:macro name="finger_joint" params="prefix"/>'
            '<xacro:macro name="hand" params=""><xacro:finger_joints prefix="l_" reflect="-1"/></xacro:macro></root>',
            why="the macro of a like name takes no `reflect`",
            file=FILE,
            scaffold="{}",
        ),
    )

    def check(self, problem: problems.UndefinedMacro) -> Iterator[Diagnostic]:
        found = report(self, problem, "macro")
        if problem.name in STOPS:
            advice = "give it the arguments that it asks for"
            found = found._replace(severity=Severity.WARNING, help=advice)
        if problem.span.source.path.suffix.lower() == ".urdf":
            found = found._replace(affects=tuple((consumer.value, _IGNORES) for consumer in Consumer))
        yield found

from collections.abc import Iterator

from sdfcheck import Bad, Diagnostic, Good, Rule, Severity, problems, replace
from sdfcheck_rules.xac.scaffold import FILE, IN_XACRO


class DeprecatedXacroFunction(Rule):
    """A function is called by its bare name, which xacro is about to drop.

    `load_yaml` and its like are in the module `xacro`, `sorted` and `range` in `python`. xacro warns
    at every call without the module.
    """

    code = "XAC017"
    name = "deprecated-xacro-function"
    severity = Severity.WARNING
    remedy = """Call it through its module: `xacro.load_yaml(…)`, `python.range(…)`.

    For ROS Melodic and before, which lack the modules, keep the bare name and ignore this.
    """
    explains = (problems.DeprecatedFunction,)
    scaffold = IN_XACRO

    bad = (
        Bad(
            '<link name="l${«range»(3)[1]}"/>',
            fixed='<link name="l${python.range(3)[1]}"/>',
            file=FILE,
            says="`range` is deprecated; call `python.range`",
        ),
    )
    good = (
        Good('<link name="l${python.range(3)[1]}"/>', file=FILE),
        Good('<link name="l${[range for range in (1, 2)][0]}"/>', why="no call", file=FILE),
    )

    def check(self, problem: problems.DeprecatedFunction) -> Iterator[Diagnostic]:
        name = f"{problem.near}.{problem.name}"
        fix = replace(problem.span, name, f"write `{name}`")
        yield self.diagnostic(problem.span, f"`{problem.name}` is deprecated; call `{name}`", fix=fix)

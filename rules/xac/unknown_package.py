from collections.abc import Iterator

from sdfcheck import (
    Bad,
    Diagnostic,
    Good,
    Missing,
    MissingKind,
    Origin,
    Rule,
    Severity,
    problems,
    write_instead,
)
from sdfcheck_rules.xac.scaffold import FILE, IN_XACRO

PART = '<robot xmlns:xacro="http://www.ros.org/wiki/xacro"/>'


class UnknownPackage(Rule):
    """``$(find …)`` names a package that is nowhere to be found.

    Packages are found without ROS: by ``packages`` in the configuration or
    ``--package name=path``, by the ``package.xml`` files of the project and of
    ``package-paths``, and in ROS_PACKAGE_PATH and AMENT_PREFIX_PATH. A warning, since
    the package may exist on the computer that the file is meant for; what depends on it
    is not checked.
    """

    code = "XAC007"
    name = "unknown-package"
    severity = Severity.WARNING
    remedy = """Say where the package is: `packages` in the configuration, or `--package NAME=PATH`.

    `package-paths` names a folder of many packages, such as `src` of a workspace. A sourced workspace is
    found through `AMENT_PREFIX_PATH` without any setting.
    """
    explains = (problems.UnknownPackage,)
    scaffold = IN_XACRO

    bad = (
        Bad(
            '<xacro:include filename="$(find «no_such_description»)/urdf/arm.xacro"/>',
            file=FILE,
            says="package `no_such_description`",
        ),
        Bad(
            '<xacro:include filename="$(find «old_description»)/urdf/arm.xacro"/>',
            fixed='<xacro:include filename="$(find arm_description)/urdf/arm.xacro"/>',
            unsafe=True,
            file=FILE,
            files={"package.xml": "<package><name>arm_description</name></package>", "urdf/arm.xacro": PART},
            says="package `old_description` is not found; did you mean `arm_description`?",
        ),
    )
    good = (
        Good(
            '<xacro:if value="false"><xacro:include filename="$(find no_such)/a.xacro"/></xacro:if>',
            why="never looked for",
            file=FILE,
        ),
        Good('<link name="$$(find escaped)"/>', why="escaped", file=FILE),
    )

    def check(self, problem: problems.UnknownPackage) -> Iterator[Diagnostic]:
        guess = f"; did you mean `{problem.near}`?" if problem.near else ""
        yield self.diagnostic(
            problem.span,
            f"package `{problem.name}` is not found{guess}",
            fix=write_instead(problem.near, problem.span) if problem.span.text == problem.name else None,
            help=f"say where it is with `packages` in the configuration or `--package {problem.name}=PATH`",
            origins=tuple(Origin(*step) for step in problem.origins),
            missing=None if problem.near else Missing(MissingKind.PACKAGE, problem.name),
        )

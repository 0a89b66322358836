from collections.abc import Iterator

from sdfcheck import Bad, Diagnostic, Good, Root, Rule, Severity

PACKAGE = {
    "package.xml": "<package><name>bot</name><buildtool_depend>ament_cmake</buildtool_depend></package>"
}
PARAMETERS = "ekf_node:\n  ros__parameters:\n{}frequency: 30.0\n"


class TabsInParameters(Rule):
    """A file of parameters in the robot's package has a tab before an entry, and cannot be read for it.

    YAML takes blanks alone there: the node that is given the file ends with an error. Looked at are files with
    `ros__parameters`.
    """

    code = "R2C046"
    name = "tabs-in-parameters"
    severity = Severity.WARNING
    remedy = "Write blanks instead, as many as before the entries around it."
    looks_at = (Root,)

    bad = (
        Bad(
            '<«robot» name="r"><link name="a"/></robot>',
            files=PACKAGE | {"config/ekf.yaml": PARAMETERS.format("\t")},
            says="`ekf.yaml` has a tab before an entry in line 3, and YAML takes blanks alone",
        ),
    )
    good = (
        Good(
            '<robot name="r"><link name="a"/></robot>',
            files=PACKAGE | {"config/ekf.yaml": PARAMETERS.format("    ")},
        ),
        Good(
            '<robot name="r"><link name="a"/></robot>',
            files=PACKAGE | {"config/ekf.yaml": PARAMETERS.format("    a: [1,\n\t2]\n    ")},
            why="between brackets a tab is a blank",
        ),
    )

    @staticmethod
    def applies(root: Root) -> bool:
        return bool(root.tabs_in_parameters)

    def check(self, root: Root) -> Iterator[Diagnostic]:
        for span in root.tabs_in_parameters:
            source = span.source
            line = source.text.count("\n", 0, span.start) + 1
            message = (
                f"`{source.path.name}` has a tab before an entry in line {line}, and YAML takes blanks alone"
            )
            yield self.diagnostic(root.element, message, labels={span: "a tab is here"})

from collections.abc import Iterator

from sdfcheck import IN_MODEL, Bad, Diagnostic, Good, Rule, Severity, problems
from sdfcheck_rules.sch.newer import report


class TooNewAttribute(Rule):
    """An attribute is younger than the version that the file declares.

    A new consumer reads every file as the newest version and goes by the attribute. A consumer
    of the declared version ignores it: a pose that is `relative_to` something is then
    relative to the default, and the robot falls apart.
    """

    code = "SCH019"
    name = "too-new-attribute"
    severity = Severity.WARNING
    remedy = """Declare the version that has the attribute, or do without it.

    `relative_to` needs version 1.7, `degrees` 1.9. `sdfcheck convert sdf-to-sdf --sdf-version VERSION`
    raises the version of the file; for an older one, write poses relative to the default, which
    `sdfcheck graph poses FILE` helps with.
    """
    explains = (problems.TooNewAttribute,)

    bad = (
        Bad(
            '<sdf version="1.6"><model name="m"><link name="base"/>'
            '<link name="arm"><pose «relative_to»="base">0 0 1 0 0 0</pose></link></model></sdf>',
            fixed='<sdf version="1.7"><model name="m"><link name="base"/>'
            '<link name="arm"><pose relative_to="base">0 0 1 0 0 0</pose></link></model></sdf>',
            unsafe=True,
            says="`relative_to` came with version 1.7, and the file declares 1.6",
        ),
        Bad(
            '<sdf version="1.8"><model name="m"><pose «degrees»="true">0 0 1 0 0 90</pose><link name="base">'
            '<pose degrees="true">0 0 1 0 0 90</pose></link></model></sdf>',
            unsafe=True,
            says="`degrees` (used 2 times) came with version 1.9",
        ),
        Bad(
            '<sdf version="1.4"><model name="m"><pose «frame»="">0 0 1 0 0 0</pose><link name="l"/></model></sdf>',
            fixed='<sdf version="1.5"><model name="m"><pose frame="">0 0 1 0 0 0</pose><link name="l"/></model></sdf>',
            unsafe=True,
            says="`frame` came with version 1.5, and the file declares 1.4",
        ),
    )
    good = (
        Good('<link name="arm"><pose relative_to="base">0 0 1 0 0 0</pose></link>', scaffold=IN_MODEL),
        Good(
            '<sdf version="1.6"><model name="m"><link name="base" p:relative_to="x" xmlns:p="https://example.org/p"/></model></sdf>',
            why="a custom attribute has no version",
        ),
    )

    def check(self, problem: problems.TooNewAttribute) -> Iterator[Diagnostic]:
        spans = problem.element.document.spans
        uses = tuple(spans.attribute_name(use, problem.attribute) for use in problem.uses)
        yield report(self, problem, problem.attribute, uses)

from collections.abc import Iterator

from sdfcheck import IN_COLLISION, Bad, Diagnostic, Good, Rule, Severity, problems
from sdfcheck_rules.sch.newer import report


class TooNewElement(Rule):
    """An element is younger than the version that the file declares.

    A new consumer reads every file as the newest version and takes the element. A consumer
    of the declared version does not know it and leaves it out: the same file gives
    another robot there.
    """

    code = "SCH007"
    name = "too-new-element"
    severity = Severity.WARNING
    remedy = """Declare the version that has the element, or do without it.

    Raise the version with `sdfcheck convert sdf-to-sdf --sdf-version VERSION`, which carries over what
    changed in between. If the file must run in an older simulator, use what was there: a cylinder for a
    capsule, for example.
    """
    explains = (problems.TooNewElement,)

    bad = (
        Bad(
            '<sdf version="1.7"><model name="m"><link name="base"><collision name="c"><geometry>'
            "<«capsule»><radius>1</radius><length>2</length></capsule></geometry></collision></link></model></sdf>",
            fixed='<sdf version="1.8"><model name="m"><link name="base"><collision name="c"><geometry>'
            "<capsule><radius>1</radius><length>2</length></capsule></geometry></collision></link></model></sdf>",
            unsafe=True,
            says="`capsule` came with version 1.8, and the file declares 1.7",
        ),
        Bad(
            '<sdf version="1.5"><model name="m"><«enable_wind»>true</enable_wind><link name="a"/>'
            '<model name="n"><enable_wind>true</enable_wind><link name="a"/></model></model></sdf>',
            unsafe=True,
            says="`enable_wind` (used 2 times) came with version 1.6",
        ),
    )
    good = (
        Good(
            "<geometry><capsule><radius>1</radius><length>2</length></capsule></geometry>",
            scaffold=IN_COLLISION,
        ),
        Good(
            '<sdf version="1.5"><model name="m"><link name="a"/><p:enable_wind xmlns:p="https://example.org/p"/></model></sdf>',
            why="a custom element has no version",
        ),
        Good(
            '<sdf version="1.4"><model name="m"><include><uri>part.sdf</uri></include><link name="a"/></model></sdf>',
            files={"part.sdf": '<sdf version="1.4"><model name="part"><link name="a"/></model></sdf>'},
            why="it was read before the schema had it",
        ),
    )

    def check(self, problem: problems.TooNewElement) -> Iterator[Diagnostic]:
        uses = tuple(use.span for use in problem.uses)
        yield report(self, problem, problem.element.name, uses)

from collections.abc import Iterator

from sdfcheck import (
    IN_LINK,
    IN_URDF_LINK,
    REFUSES,
    SDF,
    Bad,
    Consumer,
    Diagnostic,
    Good,
    Rule,
    Severity,
    problems,
    repeating,
)

SHOWN = 3
"""Further ones that are pointed at."""
MOMENTS = '<inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/>'


class RepeatedElement(Rule):
    """An element that may occur once is given again.

    Consumers take the first one; what the others say is lost in silence. A second
    model, light or actor at the top of the file is an error, because libsdformat takes
    one entity from a file, and refuses it otherwise.
    """

    code = "SCH006"
    name = "repeated-element"
    severity = Severity.WARNING
    remedy = """Remove one of them, or put them together in one.

    The first one is in effect now, so that removing the later ones changes nothing. For a second model in a
    file, use a file each, or a `<world>` around both.
    """
    explains = (problems.RepeatedElement,)
    scaffold = IN_LINK

    bad = (
        Bad(
            "<inertial><mass>1</mass><«mass»>2</mass></inertial>",
            says="`mass` is given again in `inertial`; only the first counts",
        ),
        Bad(
            "<inertial><mass>1</mass><«mass»>2</mass><mass>3</mass></inertial>",
            says="`mass` is given 3 times in `inertial`; only the first counts",
        ),
        Bad(
            '<model name="a"><link name="l"/></model><«model» name="b"><link name="l"/></model>',
            scaffold=SDF,
            says="model `b` cannot be beside model `a`",
        ),
        Bad(
            '<model name="a"><link name="l"/></model><«light» name="b" type="point"/>',
            scaffold=SDF,
            says="light `b` cannot be beside model `a`",
        ),
        Bad(
            f'<inertial><mass value="1"/><«mass» value="2"/>{MOMENTS}</inertial>',
            scaffold=IN_URDF_LINK,
            says="`mass` is given again in `inertial`",
        ),
    )
    good = (
        Good(
            '<sensor name="s" type="contact"><contact><collision>a</collision><collision>b</collision>'
            "</contact></sensor>",
            why="a contact sensor listens to several",
            scaffold=IN_LINK,
        ),
        Good(
            "<gravity>false</gravity><p:gravity xmlns:p='https://example.org/p'>true</p:gravity>",
            why="the second is another element",
        ),
        Good(
            '<world name="a"/><world name="b"/><model name="m"><link name="l"/></model>',
            why="worlds may be several, and be beside an entity",
            scaffold=SDF,
        ),
        Good(f'<inertial><mass value="1"/>{MOMENTS}</inertial>', scaffold=IN_URDF_LINK),
    )

    def check(self, problem: problems.RepeatedElement) -> Iterator[Diagnostic]:
        element, first = problem.element, problem.first
        if problem.refused:
            yield self.diagnostic(
                element,
                f"{element.title} cannot be beside {first.title}: a file holds one model, light or actor",
                labels={first: "the first one"},
                help="put each into a file of its own, or both into a `<world>`",
                severity=Severity.ERROR,
                affects=dict.fromkeys(Consumer, REFUSES),
            )
            return
        often = f"{2 + len(problem.others)} times" if problem.others else "again"
        message = f"`{element.name}` is given {often} in {problem.parent.title}; only the first counts"
        labels = {first: "the first one", **dict.fromkeys(problem.others[:SHOWN], "and again")}
        yield self.diagnostic(element, message, labels=labels, affects=repeating(element))

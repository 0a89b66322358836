from collections.abc import Iterator

from sdfcheck import (
    IN_LINK,
    IN_MODEL,
    IN_VISUAL,
    REFUSES,
    Bad,
    Consumer,
    Diagnostic,
    Element,
    Fix,
    Good,
    Inertial,
    Root,
    Rule,
    Severity,
    problems,
    refuses,
    rename,
    rewrite,
)

PLACED = frozenset(("collision", "inertial", "link", "model", "sensor", "visual"))
"""Elements whose `pose` says what an `origin` of URDF would; that of a joint is in the link that it carries."""


class UnknownElement(Rule):
    """An element without prefix is in no version of the specification.

    The custom-elements proposal keeps names without prefix for the standard; elements of
    one's own are given a prefix. libsdformat warns and keeps the element as somebody's
    own, so that a misspelled one is as good as absent; Drake refuses the file. It is a warning,
    because Gazebo, for which most files are written, ignores it. For Drake, set it to `error` under `[severity]`.
    """

    code = "NS002"
    name = "unknown-element"
    severity = Severity.WARNING
    remedy = """Write the element as the specification has it, or give it a declared prefix.

    `sdfcheck describe model` and the like list what an element holds. An element of your own is
    `<mine:paint>`, with `xmlns:mine="…"` on the root element. Settings of a plugin go into its `<plugin>`,
    where names are free.
    """
    explains = (problems.UnknownElement,)
    scaffold = IN_MODEL

    bad = (
        Bad(
            '<link name="arm"><«inertail»><mass>2</mass></inertail></link>',
            fixed='<link name="arm"><inertial><mass>2</mass></inertial></link>',
            unsafe=True,
            says="unknown element `inertail` in link `arm`; did you mean `inertial`?",
        ),
        Bad("<«self_colide»/>", fixed="<self_collide/>", unsafe=True, says="did you mean `self_collide`?"),
        Bad(
            '<link name="arm"><«origin» xyz="0 0 1" rpy="0 1.57 0"/></link>',
            fixed='<link name="arm"><pose>0 0 1 0 1.57 0</pose></link>',
            unsafe=True,
            says="unknown element `origin` in link `arm`, which is `pose` in SDFormat",
        ),
        Bad(
            "<geometry><sphere><radius>1</radius></sphere></geometry><material><script>"
            "<uri>m.material</uri><«n»>Paint</n></script></material>",
            fixed="<geometry><sphere><radius>1</radius></sphere></geometry><material><script>"
            "<uri>m.material</uri><name>Paint</name></script></material>",
            unsafe=True,
            scaffold=IN_VISUAL,
            files={"m.material": ""},
            says="did you mean `name`?",
        ),
        Bad(
            "<geometry><sphere><radius>1</radius></sphere></geometry><material><pbr><«glass»/></pbr></material>",
            scaffold=IN_VISUAL,
            says="unknown element `glass` in `pbr`",
        ),
        Bad("<«paint»>red</paint>", says="unknown element `paint` in model `m`"),
        Bad(
            '<«modle» name="arm"><link name="hand"/></modle>'
            '<joint name="j" type="fixed"><parent>base</parent><child>arm::hand</child></joint>',
            fixed='<model name="arm"><link name="hand"/></model>'
            '<joint name="j" type="fixed"><parent>base</parent><child>arm::hand</child></joint>',
            unsafe=True,
            says="did you mean `model`?",
        ),
        Bad(
            '<«plugins» filename="gz-sim-imu-system" name="gz::sim::systems::Imu"/>',
            fixed='<plugin filename="gz-sim-imu-system" name="gz::sim::systems::Imu"/>',
            unsafe=True,
            says="did you mean `plugin`?",
        ),
    )
    good = (
        Good('<p:color xmlns:p="https://example.org/p">red</p:color>', why="it has a prefix"),
        Good(
            '<p:wheel xmlns:p="https://example.org/p"><tyre>soft</tyre></p:wheel>',
            why="custom elements may hold what they like",
        ),
        Good(
            '<sensor name="s" type="custom"><plugin name="p" filename="p">'
            "<topic_name>/scan</topic_name></plugin></sensor>",
            why="the content of a plugin is the plugin's",
            scaffold=IN_LINK,
        ),
        Good(
            '<sensor name="s" type="rotating_sonar"><increment>1</increment></sensor>',
            why="unknown-choice owns the type, and the plugin that has such a type reads the rest",
            scaffold=IN_LINK,
        ),
    )

    def check(self, problem: problems.UnknownElement) -> Iterator[Diagnostic]:
        element, guess = problem.element, problem.suggestion
        message = f"unknown element `{element.name}` in {problem.parent.title}"
        is_refused = problem.refused or is_moment(problem)
        severity = Severity.ERROR if is_refused else None
        if element.name == "origin" and problem.parent.name in PLACED and not problem.parent.has("pose"):
            message += ", which is `pose` in SDFormat"
            yield self.diagnostic(element, message, fix=as_pose(element), severity=severity)
            return
        advice = "give it a prefix if it is your own" if guess is None else None
        if (element.name, problem.parent.name) == ("origin", "joint"):
            advice = "place its child link instead, by a `pose` that is `relative_to` the parent link"
        fix = rename(guess, element)
        affects = {}
        if is_refused:
            affects = {Consumer.GAZEBO: REFUSES}
        elif holds_delimiter(element):
            affects = {Consumer.GAZEBO: refuses("refuses the file for `::` in a name")}
            severity = Severity.ERROR
        elif repeats_name(element):
            affects = {
                Consumer.GAZEBO: refuses(
                    "its checker refuses the file for a repeated name; simulators read it"
                )
            }
        yield self.diagnostic(
            element, message, meant=guess, fix=fix, help=advice, severity=severity, affects=affects
        )


def is_moment(problem: problems.UnknownElement) -> bool:
    """Is it a moment of inertia, in whose place libsdformat takes 1, which no body has beside the others?"""
    around = problem.parent.parent
    if problem.parent.name != "inertia" or around is None:
        return False
    inertial = problem.element.document.view(Root).part_of(around)
    return isinstance(inertial, Inertial) and (inertial.tensor.is_indefinite or inertial.tensor.is_impossible)


def holds_delimiter(element: Element) -> bool:
    """Has it a name with `::`, or an element in it? From 1.8 on libsdformat refuses that but in custom elements."""
    if element.document.view(Root).is_older_than("1.8"):
        return False
    return any("::" in each.attributes.get("name", "") for each in checked(element))


def repeats_name(element: Element) -> bool:
    """Have two elements that are side by side in it one name?"""
    for each in checked(element):
        named = [one for one in each.children() if one.name != "plugin" and "name" in one.attributes]
        if len({one.attributes["name"] for one in named}) < len(named):
            return True
    return False


def checked(element: Element) -> Iterator[Element]:
    """It and those in it whose names the checker of libsdformat looks at: not what a prefix or a plugin has."""
    waiting = [element]
    while waiting:
        each = waiting.pop()
        if ":" not in each.name and each.name != "plugin":
            yield each
            waiting += each.children()


def as_pose(origin: Element) -> Fix | None:
    """The fix that writes an `origin` of URDF as a `pose`."""
    given = origin.attributes
    numbers = [*given.get("xyz", "0 0 0").split(), *given.get("rpy", "0 0 0").split()]
    if len(numbers) != 6 or not given.keys() <= {"xyz", "rpy"} or origin.nodes:
        return None
    return rewrite("write `pose`", {origin: f"<pose>{' '.join(numbers)}</pose>"})

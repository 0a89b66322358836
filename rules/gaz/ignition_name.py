from collections.abc import Iterator

from sdfcheck import (
    IN_MODEL,
    IN_ROBOT,
    Bad,
    Consumer,
    Diagnostic,
    Element,
    Good,
    Plugin,
    Root,
    Rule,
    Severity,
    Span,
    TextEdit,
    Value,
    ignores,
    make_fix,
    warns,
)
from sdfcheck_rules.gaz.ignition import new_class, new_file

PREFIX = "ignition:"
NEW_PREFIX = "gz:"
GUI = "ignition-gui"
NEW_GUI = "gz-gui"
SYSTEM = "ignition-gazebo"
LOADED = ("ignition-gazebo-", "gz-sim", "libgz-sim")
"""How the file of a plugin begins that is found, whatever its class is called."""
NAMESPACE = "ignition::"

OLD, NEW = "http://ignitionrobotics.org/schema", "http://gazebosim.org/schema"


class IgnitionName(Rule):
    """A plugin, element or prefix is called after Ignition, as Gazebo was up to Fortress.

    Gazebo Garden still took the old names, with a warning. From Harmonic on the elements are ignored, from Ionic
    on files that begin with `libignition-` are not found; `ignition-gazebo-…` and classes are still taken, which
    is a hint. Fortress takes the new names of plugins as well, but not those of elements.
    """

    code = "GAZ001"
    name = "ignition-name"
    severity = Severity.WARNING
    remedy = """Rename it as Gazebo calls it since Garden: `ignition` is `gz` there.

    The library of a system is `gz-sim-…-system`, its class `gz::sim::systems::…`. Keep the old name of a
    plugin only if the file has to run in Ignition Citadel or Edifice, that of an element also for Fortress.
    """
    looks_at = (Plugin, Root)
    scaffold = IN_MODEL

    bad = (
        Bad(
            '<plugin filename="«libignition-gazebo-diff-drive-system.so»" '
            'name="ignition::gazebo::systems::DiffDrive"/>',
            fixed='<plugin filename="gz-sim-diff-drive-system" name="gz::sim::systems::DiffDrive"/>',
            says="`libignition-gazebo-diff-drive-system.so` is now called `gz-sim-diff-drive-system`",
            also=("RES021",),
        ),
        Bad(
            '<plugin filename="gz-sim-imu-system" name="«ignition::gazebo::systems::Imu»"/>',
            fixed='<plugin filename="gz-sim-imu-system" name="gz::sim::systems::Imu"/>',
        ),
        Bad(
            '<gazebo><plugin filename="«ignition-gazebo6-imu-system»" name="imu"/></gazebo>',
            fixed='<gazebo><plugin filename="gz-sim-imu-system" name="imu"/></gazebo>',
            scaffold=IN_ROBOT,
            also=("RES016",),
        ),
        Bad(
            '<plugin filename="MinimalScene" name="3D View"><«ignition-gui»><title>3D View</title>'
            "</ignition-gui></plugin>",
            fixed='<plugin filename="MinimalScene" name="3D View"><gz-gui><title>3D View</title></gz-gui></plugin>',
            unsafe=True,
        ),
        Bad(
            f'<sdf version="1.9" xmlns:ignition="{OLD}"><model name="m"><link name="l">'
            "<«ignition»:note>a</ignition:note><ignition:note/></link></model></sdf>",
            fixed=f'<sdf version="1.9" xmlns:gz="{NEW}"><model name="m"><link name="l">'
            "<gz:note>a</gz:note><gz:note/></link></model></sdf>",
            unsafe=True,
            says="`ignition` is now called `gz`",
            scaffold="{}",
        ),
        Bad(
            f'<sdf version="1.9" xmlns:gz="{NEW}" xmlns:ignition="{OLD}"><model name="m" gz:a="1">'
            '<link name="l" «ignition»:kind="a"/></model></sdf>',
            fixed=f'<sdf version="1.9" xmlns:gz="{NEW}"><model name="m" gz:a="1">'
            '<link name="l" gz:kind="a"/></model></sdf>',
            unsafe=True,
            scaffold="{}",
        ),
    )
    good = (
        Good('<plugin filename="gz-sim-diff-drive-system" name="gz::sim::systems::DiffDrive"/>'),
        Good(
            '<plugin filename="own-system" name="my::ignition::Spark"/>',
            why="the ignition of one's own engine",
        ),
        Good(
            '<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro"><xacro:arg name="ignition" default="false"/>'
            '<xacro:if value="$(arg ignition)"><gazebo><plugin filename="ignition-gazebo-imu-system" name="imu"/>'
            '</gazebo></xacro:if><link name="base"/></robot>',
            why="only where somebody asks for Ignition",
            file="robot.xacro",
            scaffold="{}",
        ),
    )

    @staticmethod
    def applies(part: Plugin | Root) -> bool:
        if isinstance(part, Root):
            return PREFIX in part.document.source.text and any(map(is_prefixed, all_elements(part)))
        return (is_of_ignition(part) or part.has(GUI)) and not is_for_ignition(part)

    def check(self, part: Plugin | Root) -> Iterator[Diagnostic]:
        if isinstance(part, Root):
            uses = [TextEdit(span, NEW_PREFIX + span.text[len(PREFIX) :]) for span in _prefixed(part)]
            first = uses[0].span
            place = first.source.span(first.start, first.start + len(PREFIX) - 1)
            yield self._unread(place, PREFIX[:-1], NEW_PREFIX[:-1], [*uses, *_declarations(part)])
            return
        if changes := _changes(part):
            yield self._of_plugin(changes, is_loaded=part.filename.startswith(LOADED))
        for element in part.children(GUI):
            yield self._unread(
                element.span, GUI, NEW_GUI, [TextEdit(span, NEW_GUI) for span in _names(element)]
            )

    def _of_plugin(self, changes: list[tuple[Value, str]], *, is_loaded: bool) -> Diagnostic:
        value, new = changes[0]
        return self.diagnostic(
            value,
            f"`{value.text}` is now called `{new}`",
            fix=make_fix(f"rename it to `{new}`", tuple(TextEdit(old.span, name) for old, name in changes)),
            severity=Severity.INFO if is_loaded else None,
            affects={Consumer.GAZEBO: warns("takes it, with a warning")} if is_loaded else None,
        )

    def _unread(self, place: Span, old: str, new: str, edits: list[TextEdit]) -> Diagnostic:
        fix = make_fix(f"rename it to `{new}`", tuple(dict.fromkeys(edits)), unsafe=True)
        reaction = ignores("it, from Harmonic on")
        return self.diagnostic(
            place, f"`{old}` is now called `{new}`", fix=fix, affects={Consumer.GAZEBO: reaction}
        )


def is_of_ignition(plugin: Plugin) -> bool:
    """Is a plugin called after Ignition?"""
    return plugin.filename.removeprefix("lib").startswith(SYSTEM) or plugin.name.startswith(NAMESPACE)


def _changes(plugin: Plugin) -> list[tuple[Value, str]]:
    """The present names of file and class: one name in two spellings, changed together."""
    renamed = ((plugin.filename_value, new_file), (plugin.name_value, new_class))
    found = [(value, rename(value.text)) for value, rename in renamed if value is not None]
    return [(value, new) for value, new in found if new is not None]


def all_elements(root: Root) -> Iterator[Element]:
    """The root element and all in it."""
    yield root.element
    yield from root.all_elements()


def is_for_ignition(plugin: Plugin) -> bool:
    """Does xacro write it where a condition asks for Ignition?"""
    return any(
        each.name == "xacro:if" and "ign" in each.attributes.get("value", "").lower()
        for each in plugin.element.around
    )


def is_prefixed(element: Element) -> bool:
    """Do the names of an element or its attributes have the prefix of Ignition?"""
    return element.name.startswith(PREFIX) or any(name.startswith(PREFIX) for name in element.attributes)


def _prefixed(root: Root) -> Iterator[Span]:
    """The names with the prefix."""
    for element in filter(is_prefixed, all_elements(root)):
        if element.name.startswith(PREFIX):
            yield from _names(element)
        spans = element.document.spans
        yield from (
            spans.attribute_name(element, name) for name in element.attributes if name.startswith(PREFIX)
        )


def _names(element: Element) -> Iterator[Span]:
    """The names in the start tag and in the end tag, if there is one."""
    yield element.span
    end = element.document.spans.end_name(element)
    if end is not None:
        yield end


def _declarations(root: Root) -> Iterator[TextEdit]:
    """The changes to declarations of the prefix; one goes where its successor has one."""
    old, new = f"xmlns:{PREFIX[:-1]}", f"xmlns:{NEW_PREFIX[:-1]}"
    if old not in root.document.source.text:
        return
    spans = root.document.spans
    for element in all_elements(root):
        given = {attribute.name for attribute in spans.start_tag(element).attributes}
        if old not in given:
            continue
        if new in given or NEW_PREFIX[:-1] in element.namespaces:
            yield TextEdit(spans.attribute_whole(element, old), "")
            continue
        yield TextEdit(spans.attribute_name(element, old), new)
        if (value := spans.attribute_value(element, old)).text == OLD:
            yield TextEdit(value, NEW)

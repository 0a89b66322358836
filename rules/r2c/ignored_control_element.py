from collections.abc import Iterator

from sdfcheck import Bad, Diagnostic, Element, Good, Ros2Control, Rule, Severity, Value, rename, suggest
from sdfcheck_rules.r2c.scaffold import IN_BLOCK, IN_LIFT, IN_ROBOT

PARAMETERS = ("initial_value", "max", "min")
GENERIC = (
    "mock_components/GenericSystem",
    "gz_ros2_control/GazeboSimSystem",
    "ign_ros2_control/IgnitionSystem",
    "gazebo_ros2_control/GazeboSystem",
)
OF_HARDWARE = {"ethercat_driver/EthercatDriver": "ec_module"}
"""Hardware that reads an element of its own in the text of the description."""
INITIAL = frozenset({"initial_effort", "initial_position", "initial_velocity"})
"""Read by some hardware of older releases."""


class IgnoredControlElement(Rule):
    """An element in a joint, interface or other part of `ros2_control` that nothing reads.

    The parser takes the elements that it knows and ignores all others in silence, so that a misspelled
    interface is not there and a misspelled reduction stays at 1. So it is with attributes that it does not know, such
    as a parameter whose value is an attribute, and with a parameter of an interface that is nearly `min`, `max` or
    `initial_value`. The hardware of Gazebo and mock hardware read `initial_value` of interfaces alone. Of two plugins
    in one `hardware` it takes the first. That of EtherCAT reads its modules by itself.
    """

    code = "R2C006"
    name = "ignored-control-element"
    severity = Severity.WARNING
    remedy = """Write it as the parser knows it, or as a `<param name="…">`, or remove it.

    An interface holds `<param>`, in jazzy also `<limits>`; a joint holds `<command_interface>`,
    `<state_interface>` and `<param>`. Hardware reads its own settings from `<param>` elements.
    """
    looks_at = (Ros2Control,)
    scaffold = IN_LIFT

    bad = (
        Bad(
            '<«comand_interface» name="position"/>',
            fixed='<command_interface name="position"/>',
            unsafe=True,
            says="ros2_control ignores `comand_interface` in joint `lift`; did you mean `command_interface`?",
        ),
        Bad(
            '<state_interface name="position"><«initial_value»>1</initial_value></state_interface>',
            says='write it as `<param name="initial_value">`',
        ),
        Bad(
            '<transmission name="t"><plugin>transmission_interface/SimpleTransmission</plugin>'
            '<joint name="lift" role="joint1"><«mechanicalReduction»>5</mechanicalReduction></joint>'
            '</transmission><joint name="lift"/>',
            fixed='<transmission name="t"><plugin>transmission_interface/SimpleTransmission</plugin>'
            '<joint name="lift" role="joint1"><mechanical_reduction>5</mechanical_reduction></joint>'
            '</transmission><joint name="lift"/>',
            unsafe=True,
            scaffold=IN_BLOCK,
        ),
        Bad(
            '<state_interface name="position"><param name="initial_value" «value»="1"/></state_interface>',
            says="ros2_control takes the text of `param`, and not its `value`",
        ),
        Bad(
            '<state_interface name="position" «initial_value»="1"/>',
            says="ros2_control ignores the attribute `initial_value` of `state_interface`",
        ),
        Bad(
            '<state_interface name="position"><param name="«initial_position»">1</param></state_interface>',
            fixed='<state_interface name="position"><param name="initial_value">1</param></state_interface>',
            unsafe=True,
            says="nothing reads `initial_position` of interface `position`; did you mean `initial_value`?",
        ),
        Bad(
            '<state_interface name="position"/><param name="«initial_value»">1</param>',
            says="nothing reads `initial_value` of joint `lift` beside its interfaces",
        ),
        Bad(
            '<ros2_control name="arm" type="system"><hardware><plugin>a/B</plugin><«plugin»>c/D</plugin></hardware>'
            '<joint name="lift"/></ros2_control>',
            scaffold=IN_ROBOT,
            says="the hardware is `a/B`; this second plugin is ignored",
        ),
    )
    good = (
        Good('<state_interface name="torque"><param name="initial_value">1</param></state_interface>'),
        Good('<state_interface name="torque"><param name="filter">1</param></state_interface>', why="free"),
        Good('<vendor:gain name="k"/>', why="a prefix makes it free"),
        Good(
            '<ros2_control name="arm" type="system"><hardware><plugin>ethercat_driver/EthercatDriver</plugin>'
            '</hardware><joint name="lift"><ec_module name="drive"><plugin>ethercat_generic_plugins/Drive</plugin>'
            '<param name="alias">0</param></ec_module></joint></ros2_control>',
            scaffold=IN_ROBOT,
            why="its hardware reads them",
        ),
    )

    @staticmethod
    def applies(block: Ros2Control) -> bool:
        return bool(
            second_plugins(block) or any(unread_parameters(block)) or any(unread_attributes(block))
        ) or any(
            holder is not block.element and not is_read(child, block) for child, holder, _ in block.foreign
        )

    def check(self, block: Ros2Control) -> Iterator[Diagnostic]:
        for element, holder, place in block.foreign:
            if holder is block.element or is_read(element, block):
                continue
            near = block.nearest(element.name, place.children)
            lacks_plugin = "plugin" in place.children and not holder.has("plugin")
            if lacks_plugin and (near == "plugin" or element.name == "type"):
                continue  # the missing plugin is reported there
            message = f"ros2_control ignores `{element.name}` in {holder.title}"
            if not near and element.name in PARAMETERS and "param" in place.children:
                message += f'; write it as `<param name="{element.name}">`'
            yield self.diagnostic(element, message, meant=near, fix=rename(near, element))
        for plugin in second_plugins(block):
            first = block.plugin_value
            name = "" if first is None else first.text.strip()
            yield self.diagnostic(plugin, f"the hardware is `{name}`; this second plugin is ignored")
        for value in unread_attributes(block):
            message = f"ros2_control ignores the attribute `{value.attribute}` of `{value.element.name}`"
            advice = (
                f'write it as `<param name="{value.attribute}">` in it'
                if value.attribute in PARAMETERS
                else None
            )
            yield self.diagnostic(value.name_span, message, help=advice)
        for value in unread_parameters(block):
            interface = value.element.parent
            if interface is not None and interface.name == "joint":
                where = f"joint `{interface.attributes.get('name', '')}` beside its interfaces"
                advice = "write it between `<state_interface …>` and `</state_interface>`"
                yield self.diagnostic(value, f"nothing reads `{value.text}` of {where}", help=advice)
            elif value.attribute == "value" or interface is None:
                message = "ros2_control takes the text of `param`, and not its `value`"
                advice = "write the value between `<param>` and `</param>`"
                yield self.diagnostic(value.name_span, message, help=advice)
            else:
                message = (
                    f"nothing reads `{value.text}` of interface `{interface.attributes.get('name', '')}`"
                )
                yield self.diagnostic(value, message, meant=meant(value.text))


def is_read(element: Element, block: Ros2Control) -> bool:
    """Is an element that ros2_control does not know somebody's own, or read by the hardware itself?"""
    plugin = block.plugin_value
    own = None if plugin is None else OF_HARDWARE.get(plugin.text.strip())
    return ":" in element.name or element.name == own


def second_plugins(block: Ros2Control) -> list[Element]:
    """The plugins of its hardware after the first."""
    return [] if block.hardware is None else list(block.hardware.children("plugin"))[1:]


def meant(parameter: str) -> str | None:
    """The parameter of an interface that was probably meant."""
    return "initial_value" if parameter in INITIAL else suggest(parameter, PARAMETERS)


def unread_attributes(block: Ros2Control) -> Iterator[Value]:
    """The attributes that its parser does not look for; those of parameters are looked at elsewhere."""
    for element, definition in block.known:
        names = () if element.name == "param" else element.attributes
        for name in names:
            value = element.attribute(name)
            if name not in definition.attributes and ":" not in name and value is not None:
                yield value


def is_generic(block: Ros2Control) -> bool:
    """Is its hardware simulated or mock, which reads no parameters of its own?"""
    plugin = block.plugin_value
    return plugin is not None and plugin.text.strip() in GENERIC


def unread_parameters(block: Ros2Control) -> Iterator[Value]:
    """The values of parameters that are attributes, and the names in interfaces that are nearly known ones."""
    for element, _ in block.known:
        if element.name != "param":
            continue
        value, name, holder = element.attribute("value"), element.attribute("name"), element.parent
        if value is not None and not element.content:
            yield value
        elif name is None or holder is None:
            continue
        elif holder.name == "joint" and name.text == "initial_value" and is_generic(block):
            yield name
        elif not holder.name.endswith("_interface"):
            continue
        elif name.text not in PARAMETERS and meant(name.text) is not None:
            yield name

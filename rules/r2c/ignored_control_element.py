from collections.abc import Iterator

from sdfcheck import Bad, Diagnostic, Good, Ros2Control, Rule, Severity, rename
from sdfcheck_rules.r2c.scaffold import IN_BLOCK, IN_LIFT

PARAMETERS = ("initial_value", "max", "min")


class IgnoredControlElement(Rule):
    """An element in a joint, interface or other part of `ros2_control` that nothing reads.

    The parser takes the elements that it knows and ignores all others in silence, so that a misspelled
    interface is not there and a misspelled reduction stays at 1.
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
    )
    good = (
        Good('<state_interface name="torque"/>'),
        Good('<vendor:gain name="k"/>', why="a prefix makes it free"),
    )

    @staticmethod
    def applies(block: Ros2Control) -> bool:
        return any(
            holder is not block.element and ":" not in child.name for child, holder, _ in block.foreign
        )

    def check(self, block: Ros2Control) -> Iterator[Diagnostic]:
        for element, holder, place in block.foreign:
            if holder is block.element or ":" in element.name:
                continue
            near = block.nearest(element.name, place.children)
            lacks_plugin = "plugin" in place.children and not holder.has("plugin")
            if lacks_plugin and (near == "plugin" or element.name == "type"):
                continue  # the missing plugin is reported there
            message = f"ros2_control ignores `{element.name}` in {holder.title}"
            if not near and element.name in PARAMETERS and "param" in place.children:
                message += f'; write it as `<param name="{element.name}">`'
            yield self.diagnostic(element, message, meant=near, fix=rename(near, element))

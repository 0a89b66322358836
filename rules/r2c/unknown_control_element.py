from collections.abc import Iterator

from sdfcheck import Bad, Diagnostic, Good, Ros2Control, Rule, Severity, rename
from sdfcheck_rules.r2c.scaffold import HARDWARE, IN_BLOCK, IN_ROBOT, REFUSED


class UnknownControlElement(Rule):
    """A `ros2_control` block holds an element that its parser does not know.

    Directly in the block, the parser throws on anything but `hardware`, `properties`, `joint`, `sensor`,
    `gpio` and `transmission`, elements of other namespaces included, and the whole description is lost.
    """

    code = "R2C005"
    name = "unknown-control-element"
    severity = Severity.ERROR
    remedy = """Remove the element, or write it as one that the parser knows.

    Those are `hardware`, `properties`, `joint`, `sensor`, `gpio` and `transmission`. Settings of the
    hardware are `<param name="…">` in `<hardware>`; a camera is a `<sensor>`, if the hardware reads it at
    all.
    """
    looks_at = (Ros2Control,)
    scaffold = IN_BLOCK

    bad = (
        Bad(
            '<«joints» name="lift"/>',
            fixed='<joint name="lift"/>',
            unsafe=True,
            says="did you mean `joint`?",
        ),
        Bad("<«camera»/>", says="unknown element `camera` in ros2_control `arm`"),
        Bad(
            '<ros2_control name="arm" type="system"><«hardwre»><plugin>a/B</plugin></hardwre></ros2_control>',
            fixed='<ros2_control name="arm" type="system">'
            "<hardware><plugin>a/B</plugin></hardware></ros2_control>",
            unsafe=True,
            scaffold=IN_ROBOT,
        ),
    )
    good = (Good(f'<sensor name="imu"><!-- {HARDWARE.replace("--", "")} --></sensor>'),)

    @staticmethod
    def applies(block: Ros2Control) -> bool:
        return any(holder is block.element for _, holder, _ in block.foreign)

    def check(self, block: Ros2Control) -> Iterator[Diagnostic]:
        for element, holder, place in block.foreign:
            if holder is block.element and not element.name.startswith("xacro:"):
                near = block.nearest(element.name, place.children)
                message = f"unknown element `{element.name}` in {block.title}: {REFUSED}"
                yield self.diagnostic(element, message, meant=near, fix=rename(near, element))

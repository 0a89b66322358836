from collections.abc import Iterator

from sdfcheck import REFUSES, Bad, Consumer, Diagnostic, Element, GazeboBlock, Good, Rule, Severity
from sdfcheck_rules.r2c.scaffold import HARDWARE, IN_ROBOT

BLOCK = f'<{{}} name="arm" type="system">{HARDWARE}</ros2_control>'


class MisplacedControlBlock(Rule):
    """A `ros2_control` block is inside a `gazebo` block, where nothing reads it.

    ros2_control looks for its blocks directly in `robot`, also when Gazebo runs it; a description
    without any such block is refused.
    """

    code = "R2C004"
    name = "misplaced-control-block"
    severity = Severity.ERROR
    remedy = """Move the block out of `gazebo`, directly into `robot`.

    Only the `<plugin>` that starts the controller manager stays in the `<gazebo>` block.
    """
    looks_at = (GazeboBlock,)
    selects = ("urdf:robot/gazebo",)
    scaffold = IN_ROBOT

    bad = (
        Bad(
            f"<gazebo>{BLOCK.replace('{}', '«ros2_control»')}</gazebo>",
            says="ros2_control `arm` is read directly in `robot` only, not in `gazebo`",
        ),
    )
    good = (
        Good(BLOCK.replace("{}", "ros2_control")),
        Good("<gazebo><plugin><ros2_control/></plugin></gazebo>", why="a plugin's own parameter"),
    )

    @staticmethod
    def applies(block: GazeboBlock) -> bool:
        return block.has("ros2_control")

    def check(self, block: GazeboBlock) -> Iterator[Diagnostic]:
        for element in block.children("ros2_control"):
            message = f"{element.title} is read directly in `robot` only, not in `gazebo`"
            affects = {Consumer.GAZEBO: REFUSES} if is_copied(block) and names_twice(element) else {}
            yield self.diagnostic(element, message, affects=affects)


def is_copied(block: GazeboBlock) -> bool:
    """Does libsdformat copy what is in a block into the model?"""
    return block.element.attribute("reference") is None


def names_twice(element: Element) -> bool:
    """Have two elements in one of the block's the same name, as interfaces for a command and a state do?"""
    for each in element.walk():
        names = [child.text_of("name") for child in each.children() if child.attribute("name") is not None]
        if len(names) != len(set(names)):
            return True
    return False

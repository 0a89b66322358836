from collections.abc import Iterator

from sdfcheck import IN_ROBOT, Bad, Diagnostic, GazeboBlock, Good, Rule, Severity

OTHERS = ("visual", "collision", "material", "robot")
"""Other parts whose name may be taken for a reference."""


class UnreferencedExtension(Rule):
    """A `gazebo` block is for a link or joint that does not exist.

    libsdformat drops the whole block in silence: friction, sensors and plugins in it
    are never seen. Links and joints can be referred to, visuals, collisions and the robot
    itself cannot; a block for the robot has no reference.
    """

    code = "GAZ003"
    name = "unreferenced-extension"
    severity = Severity.ERROR
    remedy = """Name a link or joint of the robot in `reference`, or leave `reference` out for the robot itself.

    With xacro the prefix of the link belongs into the reference as well: `reference="${prefix}base"`. A
    block for a link that another file brings can stay there if that file is included.
    """
    looks_at = (GazeboBlock,)
    scaffold = IN_ROBOT

    bad = (
        Bad(
            '<gazebo reference="«bases»"><mu1>1</mu1></gazebo>',
            fixed='<gazebo reference="base"><mu1>1</mu1></gazebo>',
            unsafe=True,
            says="there is no link or joint `bases`; did you mean `base`?",
        ),
        Bad(
            '<gazebo reference="«r»"><static>true</static></gazebo>',
            says="`r` is a robot, not a link or joint",
        ),
    )
    good = (
        Good('<gazebo reference="base"><mu1>1</mu1></gazebo>'),
        Good("<gazebo><static>true</static></gazebo>", why="for the robot"),
    )

    @staticmethod
    def applies(block: GazeboBlock) -> bool:
        return block.is_unresolved

    def check(self, block: GazeboBlock) -> Iterator[Diagnostic]:
        name, model = block.reference, block.model
        message = f"there is no link or joint `{name}`"
        kind = next((kind for kind in OTHERS if _has(block, kind, name)), None)
        known = {*model.tree.links, *model.joints_by_name}
        meant, place = None, block.reference_value or block
        if kind is not None:
            message = f"`{name}` is a {kind}, not a link or joint"
        else:
            meant = block.nearest(name, known)
        yield self.diagnostic(place, message, meant=meant)


def _has(block: GazeboBlock, kind: str, name: str) -> bool:
    """Is there an element of that kind and name in the file?"""
    return any(element.text_of("name") == name for element in block.root.elements.get(kind, ()))

from collections.abc import Iterator

from sdfcheck import Bad, Diagnostic, Element, GazeboBlock, Good, Rule, Severity, Value, named

HANDED_ON = {
    "collision": frozenset("collision fdir1 kd kp laserRetro maxContacts maxVel minDepth mu1 mu2".split()),
    "visual": frozenset(("material", "visual")),
}
"""The settings that libsdformat hands on to the collisions or visuals of the link."""

BOX = '<geometry><box size="1 1 1"/></geometry>'
ROBOT = f'<robot name="r"><link name="base"><collision name="hull">{BOX}</collision></link>{{}}</robot>'


class ExtensionLostByName(Rule):
    """Settings for a link in a `gazebo` block do not reach a shape that has a name.

    libsdformat hands friction, contact and laser settings on to the collisions of the link,
    and materials to its visuals, by comparing names. A collision or visual with a name of its own
    is ignored in silence, unless the name begins with that of the link.
    """

    code = "GAZ004"
    name = "extension-lost-by-name"
    severity = Severity.WARNING
    remedy = """Remove the name of the collision or visual, or let it begin with the name of the link.

    Nothing refers to such names in a URDF but contact sensors, so removing them costs little. In SDFormat,
    write friction and material directly into the `<collision>` and the `<visual>`.
    """
    looks_at = (GazeboBlock,)
    scaffold = ROBOT

    bad = (
        Bad(
            '<gazebo reference="base"><«mu1»>0.2</mu1><mu2>0.2</mu2></gazebo>',
            says="`mu1` and `mu2` do not reach collision `hull` of link `base`, because it has a name",
        ),
        Bad(
            '<gazebo reference="base"><«material»>Gazebo/Red</material></gazebo>',
            says="visual `shell`",
            scaffold=ROBOT.replace(
                "</link>", f'<visual name="shell">{BOX}<material name="red"/></visual></link>'
            ).replace("{}", '<material name="red"><color rgba="1 0 0 1"/></material>{}'),
        ),
    )
    good = (
        Good('<gazebo reference="base"><selfCollide>true</selfCollide></gazebo>', why="for the link itself"),
        Good(
            '<gazebo reference="base"><mu1>0.2</mu1></gazebo>',
            why="the name begins with the link's",
            scaffold=ROBOT.replace("hull", "base_hull"),
        ),
        Good('<gazebo reference="base"><mu1>0.2</mu1></gazebo>', scaffold=ROBOT.replace(' name="hull"', "")),
    )

    @staticmethod
    def applies(block: GazeboBlock) -> bool:
        return any(lost(block))

    def check(self, block: GazeboBlock) -> Iterator[Diagnostic]:
        for settings, hidden in lost(block):
            names = dict.fromkeys(setting.name for setting in settings)
            verb = "do" if len(names) > 1 else "does"
            shape, link = hidden[0].element.title, block.reference
            others = f" and {len(hidden) - 1} more" if len(hidden) > 1 else ""
            yield self.diagnostic(
                settings[0],
                f"{named(names)} {verb} not reach {shape}{others} of link `{link}`, because it has a name",
                labels={hidden[0]: "this name"},
                help=f"remove the name, or let it begin with `{link}`",
            )


def lost(block: GazeboBlock) -> Iterator[tuple[list[Element], list[Value]]]:
    """The settings for a link's shapes, and the names that hide some: those that do not begin with the link's."""
    link = block.link
    if link is None:
        return
    for kind, handed_on in HANDED_ON.items():
        settings = [child for child in block.children() if child.name in handed_on]
        names = [shape.attribute("name") for shape in link.children(kind)] if settings else []
        hidden = [n for n in names if n is not None and n.text.strip() and not n.text.startswith(link.name)]
        if hidden:
            yield settings, hidden

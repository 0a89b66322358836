from collections.abc import Iterator

from sdfcheck import IN_ROBOT, IN_VISUAL, Bad, Diagnostic, GazeboBlock, Good, Material, Rule, Severity, Value

PREFIX = "Gazebo/"
COLORS = frozenset(
    """
    Black BlackTransparent Blue BlueGlow BlueLaser BlueTransparent BlueTransparentOverlay Bricks
    CeilingTiled Chrome CloudySky CoM DarkGrey DarkMagentaTransparent DarkOrangeTransparent
    DarkOrangeTransparentOverlay DarkYellow DepthMap FlatBlack Footway Gold Green GreenGlow
    GreenTransparent GreenTransparentOverlay Grey GreyGradientSky GreyTransparent Indigo JointAnchor
    LightBlueLaser LightOff LightOn Motorway Orange OrangeTransparent OrangeTransparentOverlay
    PaintedWall Pedestrian Pioneer2Body PioneerBody Primary Purple PurpleGlow Red RedBright RedGlow
    RedTransparent RedTransparentOverlay Residential Road Runway RustyBarrel RustySteel Secondary
    SkyBlue Steps Tertiary Trunk Turquoise TurquoiseGlow TurquoiseGlowOutline White WhiteGlow
    WindowFrame Wood WoodFloor WoodPallet Yellow YellowGlow YellowTransparent ZincYellow
    """.split()
)
"""The names in gazebo.material of Gazebo Classic; recent releases of Gazebo know most of the plain colors."""
SCRIPT = (
    "<geometry><sphere><radius>1</radius></sphere></geometry><material><script>"
    "<uri>file://media/materials/scripts/gazebo.material</uri><name>{}</name></script>"
    "<diffuse>1 0 0 1</diffuse></material>"
)


class UnknownPaletteColor(Rule):
    """The name of a material is nearly, but not quite, one of the palette of Gazebo.

    Case counts, and it is `Grey`, not `Gray`. Gazebo shows the default color in its place.
    """

    code = "GAZ010"
    name = "unknown-palette-color"
    severity = Severity.WARNING
    remedy = """Write the name as the palette spells it, such as `Gazebo/Grey` or `Gazebo/DarkGrey`.

    A color that every release shows is written out: `<ambient>` and `<diffuse>` in SDFormat, the
    `<color rgba="…"/>` of a `<material>` in URDF.
    """
    looks_at = (GazeboBlock, Material)
    needs = ("<script", "<gazebo")
    scaffold = IN_ROBOT

    bad = (
        Bad(
            '<gazebo reference="base"><material>«Gazebo/grey»</material></gazebo>',
            fixed='<gazebo reference="base"><material>Gazebo/Grey</material></gazebo>',
            unsafe=True,
            says="no material of Gazebo is called `Gazebo/grey`; `Gazebo/Grey` differs in case only",
        ),
        Bad(
            '<gazebo reference="base"><material>«gazebo/Grey»</material></gazebo>',
            fixed='<gazebo reference="base"><material>Gazebo/Grey</material></gazebo>',
            unsafe=True,
        ),
        Bad(
            SCRIPT.format("«Gazebo/Gray»"),
            scaffold=IN_VISUAL,
            fixed=SCRIPT.format("Gazebo/Grey"),
            unsafe=True,
        ),
    )
    good = (
        Good('<gazebo reference="base"><material>Gazebo/Grey</material></gazebo>'),
        Good(
            '<gazebo reference="base"><material>Gazebo/MyOwnPaint</material></gazebo>',
            why="like none of them",
        ),
        Good(
            SCRIPT.format("Gazebo/Gray").replace(
                "file://media/materials/scripts/gazebo.material", "model://m/own"
            ),
            scaffold=IN_VISUAL,
            why="a script of one's own",
        ),
    )

    @staticmethod
    def applies(part: GazeboBlock | Material) -> bool:
        return any(strange(part))

    def check(self, part: GazeboBlock | Material) -> Iterator[Diagnostic]:
        for value in strange(part):
            name = value.text.strip()
            meant = part.nearest(name[len(PREFIX) :], COLORS)
            if meant is not None:
                message = f"no material of Gazebo is called `{name}`"
                yield self.diagnostic(value, message, meant=PREFIX + meant)


def strange(part: GazeboBlock | Material) -> Iterator[Value]:
    """The names that begin as those of the palette do, and are not in it."""
    for value in written(part):
        name = value.text.strip()
        if name[: len(PREFIX)].lower() == PREFIX.lower() and "$" not in name:
            color = name[len(PREFIX) :]
            is_near = color not in COLORS and part.nearest(color, COLORS) is not None
            if is_near or (color in COLORS and not name.startswith(PREFIX)):
                yield value


def written(part: GazeboBlock | Material) -> Iterator[Value]:
    """The names of materials that it writes."""
    if isinstance(part, GazeboBlock):
        yield from part.settings("material")
        return
    script = part.script
    name = None if script is None else script.find("name")
    uri = None if script is None else script.find("uri")
    if name is not None and (uri is None or uri.content.endswith("gazebo.material")):
        yield name.own_value

from collections.abc import Iterator

from sdfcheck import (
    IN_ROBOT,
    IN_VISUAL,
    Bad,
    Diagnostic,
    GazeboBlock,
    Good,
    Material,
    Root,
    Rule,
    Severity,
    Value,
    used,
    write_instead,
)

PREFIX = "Gazebo/"
COLORS = frozenset(
    """
    Black BlackTransparent Blue BlueGlow BlueLaser BlueTransparent BlueTransparentOverlay Bricks
    BuildingFrame CameraDistortionMap CameraLensFlare CeilingTiled Chrome CloudySky CoM DarkGray
    DarkGrey DarkMagentaTransparent DarkOrangeTransparent DarkOrangeTransparentOverlay DarkYellow
    DepthMap Editor EditorPlane FlatBlack Footway GaussianCameraNoise Gold Grass Gray Green
    GreenGlow GreenTransparent GreenTransparentOverlay Grey GreyGradientSky GreyTransparent Indigo
    JointAnchor Lane_1 Lanes_2 Lanes_4 Lanes_6 LaserScan1st LaserScan2nd LightBlueLaser LightOff
    LightOn Motorway Orange OrangeTransparent OrangeTransparentOverlay PaintedWall Pedestrian
    Pioneer2Body PioneerBody PointCloud PointHandle Primary Purple PurpleGlow Red RedBright RedGlow
    RedTransparent RedTransparentOverlay Reflectance Residential Road Runway RustyBarrel RustySteel
    Secondary SkyBlue Steps Tertiary Trunk Turquoise TurquoiseGlow TurquoiseGlowOutline White
    WhiteGlow WideLensMap WindowFrame Wood WoodFloor WoodPallet XYZNormals XYZPoints Yellow
    YellowGlow YellowTransparent ZincYellow
    """.split()
)
"""The names in gazebo.material of Gazebo Classic, and of the `MaterialParser` of gz-sim, which knows most of them."""
SCRIPT = (
    "<geometry><sphere><radius>1</radius></sphere></geometry><material><script>"
    "<uri>file://media/materials/scripts/gazebo.material</uri><name>{}</name></script>"
    "<diffuse>1 0 0 1</diffuse></material>"
)


class UnknownPaletteColor(Rule):
    """The name of a material is not one of the palette of Gazebo.

    Case counts. Gazebo shows the default color in its place. Names that begin otherwise than `Gazebo/`, or are of
    another script, are somebody's own.
    """

    code = "GAZ010"
    name = "unknown-palette-color"
    severity = Severity.WARNING
    remedy = """Write the name as the palette spells it, such as `Gazebo/Grey` or `Gazebo/DarkGrey`.

    A color that every release shows is written out: `<ambient>` and `<diffuse>` in SDFormat, the
    `<color rgba="…"/>` of a `<material>` in URDF.
    """
    looks_at = (Root,)
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
            '<gazebo reference="base"><material>«Gazebo/Silver»</material></gazebo>'
            '<gazebo reference="tip"><material>Gazebo/Silver</material></gazebo>',
            scaffold='<robot name="r"><link name="base"/><link name="tip"/><joint name="j" type="fixed">'
            '<parent link="base"/><child link="tip"/></joint>{}</robot>',
            says="no material of Gazebo is called `Gazebo/Silver` (used 2 times): it shows its default color",
        ),
        Bad(
            SCRIPT.format("«Gazebo/Gras»"),
            scaffold=IN_VISUAL,
            fixed=SCRIPT.format("Gazebo/Grass"),
            unsafe=True,
        ),
    )
    good = (
        Good('<gazebo reference="base"><material>Gazebo/Grey</material></gazebo>'),
        Good('<gazebo reference="base"><material>My/OwnPaint</material></gazebo>'),
        Good(
            SCRIPT.format("Gazebo/Gray"),
            scaffold=IN_VISUAL,
            why="another spelling of `Gazebo/Grey`, since Gazebo 8",
        ),
        Good(
            SCRIPT.format("Gazebo/Pebbles").replace(
                "file://media/materials/scripts/gazebo.material", "model://m/own"
            ),
            scaffold=IN_VISUAL,
            why="a script of one's own",
        ),
    )

    @staticmethod
    def applies(root: Root) -> bool:
        return any(True for _ in strange(root))

    def check(self, root: Root) -> Iterator[Diagnostic]:
        by_name: dict[str, list[Value]] = {}
        for value in strange(root):
            by_name.setdefault(value.text.strip(), []).append(value)
        for name, values in by_name.items():
            near = root.nearest(name[len(PREFIX) :], COLORS)
            meant = None if near is None else PREFIX + near
            rest = "" if meant else ": it shows its default color"
            message = f"no material of Gazebo is called `{name}`{used(len(values))}{rest}"
            yield self.diagnostic(values[0], message, meant=meant, fix=write_instead(meant, *values))


def strange(root: Root) -> Iterator[Value]:
    """The names that begin as those of the palette do, and are not in it."""
    parts: list[GazeboBlock | Material] = [*root.each(GazeboBlock), *root.each(Material)]
    for part in parts:
        for value in written(part):
            name = value.text.strip()
            is_known = name.startswith(PREFIX) and name[len(PREFIX) :] in COLORS
            if name[: len(PREFIX)].lower() == PREFIX.lower() and "$" not in name and not is_known:
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

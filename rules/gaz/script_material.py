from collections.abc import Iterator

from sdfcheck import (
    IN_VISUAL,
    Bad,
    Diagnostic,
    GazeboBlock,
    Good,
    Material,
    Root,
    Rule,
    Severity,
    Target,
    used,
)

COLORS = ("ambient", "diffuse", "emissive", "pbr")
PALETTE = "Gazebo/"
"""How the names begin that recent releases know."""

UNSET = "__default__"
"""The name that Gazebo Classic saves for a material without a script; unset-script-uri owns it."""

BOX = '<geometry><box size="1 1 1"/></geometry>'
SHAPE = "<geometry><box><size>1 1 1</size></box></geometry>"
LINK = f'<robot name="r"><link name="base"><visual>{BOX}</visual></link>{{}}</robot>'
RED = '<material name="red"><color rgba="1 0 0 1"/></material>'


class ScriptMaterial(Rule):
    """A visual gets its looks from a material script, which new Gazebo does not load.

    Scripts belong to the renderer of Gazebo Classic; its successor shows the default color. Only the
    colors of the `Gazebo/…` palette are known to recent releases by their names, so these are for information.
    Colors beside the script (`ambient`, `diffuse`, `pbr`) are seen everywhere.
    """

    code = "GAZ006"
    name = "script-material"
    severity = Severity.WARNING
    remedy = """Give the material `<ambient>` and `<diffuse>` colors, or a `<pbr>` with textures.

    Colors are four numbers from 0 to 1: red, green, blue, opacity. For a texture write
    `<pbr><metal><albedo_map>` with the path of the image. The script can stay for Gazebo Classic beside
    them.
    """
    looks_at = (Root,)
    scaffold = IN_VISUAL

    bad = (
        Bad(
            f"{SHAPE}<material><script><uri>model://m/materials/scripts</uri>"
            "<name>«Bark»</name></script></material>",
            says="new Gazebo does not read material script `Bark`, and no color is beside it",
        ),
        Bad(
            '<gazebo reference="base"><material>«Gazebo/Red»</material></gazebo>'
            '<gazebo reference="base"><material>Gazebo/Red</material></gazebo>',
            scaffold=LINK,
            says="`Gazebo/Red` (used 2 times)",
        ),
    )
    good = (
        Good(
            f"{SHAPE}<material><script><uri>file://media/materials/scripts/gazebo.material</uri>"
            "<name>Gazebo/Red</name></script><diffuse>1 0 0 1</diffuse></material>",
            why="the color is there for those who read no scripts",
        ),
        Good(
            f"{SHAPE}<material><script><uri>m.material</uri><name>__default__</name></script></material>",
            files={"m.material": ""},
            why="Gazebo Classic shows its default color, too",
        ),
        Good(
            f"{SHAPE}<material><script><uri>m.material</uri></script></material>",
            files={"m.material": ""},
            why="missing-element owns a script without a name",
        ),
        Good(
            '<gazebo reference="base"><material>Gazebo/Red</material></gazebo>',
            why="the color of the visual is seen",
            scaffold=LINK.replace("</visual>", f"{RED}</visual>"),
        ),
    )

    @staticmethod
    def applies(root: Root) -> bool:
        return any(scripts(root))

    def check(self, root: Root) -> Iterator[Diagnostic]:
        found: dict[str, list[Target]] = {}
        for target, name in scripts(root):
            found.setdefault(name, []).append(target)
        for name, targets in found.items():
            script = f"material script `{name}`" if name else "a material script"
            yield self.diagnostic(
                targets[0],
                f"new Gazebo does not read {script}{used(len(targets))}, and no color is beside it",
                severity=Severity.INFO if name.startswith(PALETTE) else None,
            )


def scripts(root: Root) -> Iterator[tuple[Target, str]]:
    """The scripts that alone say what something looks like, and their names."""
    text = root.document.source.text
    if root.is_urdf and "<gazebo" in text:
        for block in root.each("GazeboBlock"):
            yield from _of_block(block)
    elif not root.is_urdf and "<script" in text:
        for visual in root.each("Visual"):
            yield from _of_material(visual.material)


def _of_block(block: GazeboBlock) -> Iterator[tuple[Target, str]]:
    """`Gazebo/Red` for a link that has a visual without material of its own."""
    link = block.link if block.has("material") else None
    if link is not None and not all(visual.has("material") for visual in link.visuals):
        for value in block.settings("material"):
            if value.text.strip():
                yield value, value.text.strip()


def _of_material(material: Material) -> Iterator[tuple[Target, str]]:
    script = material.script
    if script is not None and any(script.children()) and not any(map(material.has, COLORS)):
        name = script.find("name")
        if name is not None and name.content != UNSET:
            yield (name.own_value, name.content) if name.content else (script, "")

from collections.abc import Iterator

from sdfcheck import IN_VISUAL, Bad, Diagnostic, Good, Material, Rule, Severity

UNSET = frozenset({"", "__default__"})
"""The texts that the consumer does not take for a URI: an empty one, and the word for it."""
SHAPE = "<geometry><box><size>1 1 1</size></box></geometry>"
SCRIPT = f"{SHAPE}<material><script>{{}}<name>Gazebo/Red</name></script><diffuse>1 0 0 1</diffuse></material>"


class UnsetScriptUri(Rule):
    """The URI of a material script is empty or `__default__`.

    libsdformat takes both for a URI that is missing and refuses the file, and so do Gazebo
    and Drake.
    """

    code = "GAZ008"
    name = "unset-script-uri"
    severity = Severity.ERROR
    remedy = """Name the script's file in `<uri>`, or remove `<script>` and give the material colors.

    `file://media/materials/scripts/gazebo.material` is the palette of Gazebo Classic. New Gazebo loads no
    scripts: for it `<ambient>` and `<diffuse>` are what counts.
    """
    looks_at = (Material,)
    needs = ("<script",)
    scaffold = IN_VISUAL

    bad = (
        Bad(
            SCRIPT.format("<uri>«__default__»</uri>"),
            says="`__default__` is not the URI of a material script",
        ),
        Bad(SCRIPT.format("<«uri»></uri>"), says="the URI of the material script is empty"),
    )
    good = (
        Good(SCRIPT.format("<uri>file://media/materials/scripts/gazebo.material</uri>")),
        Good(
            SCRIPT.format("<uri>file://media/materials/scripts/gazebo.material</uri><uri>__default__</uri>"),
            why="the first one counts",
        ),
    )

    @staticmethod
    def applies(material: Material) -> bool:
        if material.is_urdf:
            return False
        script = material.script
        uri = None if script is None else script.find("uri")
        return uri is not None and uri.content.strip() in UNSET

    def check(self, material: Material) -> Iterator[Diagnostic]:
        script = material.script
        uri = None if script is None else script.find("uri")
        if uri is None:
            return
        text = uri.content.strip()
        message = (
            f"`{text}` is not the URI of a material script"
            if text
            else "the URI of the material script is empty"
        )
        yield self.diagnostic(uri.own_value if text else uri, f"{message}: simulators refuse the file")

from collections.abc import Iterator

from sdfcheck import IN_ROBOT, IN_URDF_LINK, Bad, Diagnostic, Element, Good, Rule, Severity, Value, replace

VISUAL = '<visual><geometry><sphere radius="1"/></geometry><material name="m"><color rgba="{}"/></material></visual>'

MEANT = ("clear", "hidden", "invisible", "none", "transparent")
"""Words in the names of materials that are not to be seen."""


class InvisibleMaterial(Rule):
    """A color has an alpha of 0, so that nothing is seen of what has it.

    The fourth number is how opaque the color is: 1 is solid, 0 is glass that nobody sees. Programs that write three
    numbers and add a 0 leave the robot invisible in RViz and Gazebo.
    """

    code = "URD031"
    name = "invisible-material"
    severity = Severity.WARNING
    remedy = """Write 1 as the fourth number.

    A part that nobody is to see needs no visual at all.
    """
    looks_at = (Element,)
    selects = ("urdf:material/color",)
    scaffold = IN_URDF_LINK

    bad = (
        Bad(
            VISUAL.format("1 0 0 «0»"),
            fixed=VISUAL.format("1 0 0 1"),
            unsafe=True,
            says="the color has an alpha of 0, so that nothing is seen",
        ),
    )
    good = (
        Good(VISUAL.format("1 0 0 1")),
        Good(VISUAL.format("1 0 0 0.2"), why="glass"),
        Good(
            '<material name="transparent"><color rgba="0 0 0 0"/></material>',
            scaffold=IN_ROBOT,
            why="as it says",
        ),
    )

    @staticmethod
    def applies(color: Element) -> bool:
        words = color.attributes.get("rgba", "").split()
        name = color.parent.attributes.get("name", "").lower() if color.parent is not None else ""
        if any(word in name for word in MEANT):
            return False
        return len(words) == 4 and not words[3].strip("0.") and any(each.isdigit() for each in words[3])

    def check(self, color: Element) -> Iterator[Diagnostic]:
        value = color.attribute("rgba")
        assert isinstance(value, Value)
        fix = replace(value, " ".join([*value.text.split()[:3], "1"]), "write 1", unsafe=True)
        yield self.diagnostic(value.part(3), "the color has an alpha of 0, so that nothing is seen", fix=fix)

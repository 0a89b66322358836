from collections.abc import Iterator

from sdfcheck import IN_LINK, IN_URDF_LINK, Bad, Diagnostic, Good, Rule, Severity, Visual

BOX = "<geometry><box><size>1 1 1</size></box></geometry>"


class VisualForCollision(Rule):
    """A visual is named as a collision, and its link has none.

    It is drawn, and nothing ever touches it: the link falls through the ground. The usual cause is a copied visual of
    which only the name was changed.
    """

    code = "GEO018"
    name = "visual-for-collision"
    severity = Severity.WARNING
    remedy = """Make it a `<collision>`, with the end tag; its material goes.

    If it is to be drawn only, give it another name.
    """
    looks_at = (Visual,)
    needs = ("ollision", "OLLISION")
    scaffold = IN_LINK

    bad = (
        Bad(
            f'<visual name="«collision»">{BOX}</visual><visual name="visual">{BOX}</visual>',
            says="visual `collision` is named as a collision, and link `base` has no collision",
        ),
        Bad(
            '<visual name="«base_collision»"><geometry><sphere radius="1"/></geometry></visual>',
            scaffold=IN_URDF_LINK,
        ),
    )
    good = (
        Good(
            f'<visual name="collision_box">{BOX}</visual><collision name="c">{BOX}</collision>',
            why="it shows the collision that is there",
        ),
        Good(f'<visual name="collision_visual">{BOX}</visual>', why="the name says that it is a visual"),
        Good(
            '<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro"><xacro:macro name="arm" params="*shape">'
            '<link name="arm"><visual name="collision"><geometry><sphere radius="1"/></geometry></visual>'
            '<xacro:insert_block name="shape"/></link></xacro:macro></robot>',
            why="the block may be a collision",
            file="arm.xacro",
            scaffold="",
        ),
    )

    @staticmethod
    def applies(visual: Visual) -> bool:
        name = visual.name.lower()
        link = visual.link
        if "collision" not in name or "vis" in name or link.element.name != "link" or link.collisions:
            return False
        return not any(child.name.startswith("xacro:") for child in link.element.children())

    def check(self, visual: Visual) -> Iterator[Diagnostic]:
        link = visual.link
        message = f"visual `{visual.name}` is named as a collision, and {link.title} has no collision"
        yield self.diagnostic(visual.attribute("name") or visual, message, labels={link: "the link"})

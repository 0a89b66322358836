from collections.abc import Iterator

from sdfcheck import IN_URDF_LINK, Bad, Diagnostic, Element, Good, Rule, Severity

SPHERE = '<geometry><sphere radius="1"/></geometry>'


class MaterialInCollision(Rule):
    """A `material` is in a collision, which is never seen.

    Colors belong to visuals. Nobody reads one in a collision; if it was meant for the visual, that has none.
    """

    code = "URD025"
    name = "material-in-collision"
    severity = Severity.INFO
    remedy = """Move the material to the visual of the link, or remove it.

    A collision is never drawn. Friction is set by a `<gazebo>` block for the link.
    """
    looks_at = (Element,)
    selects = ("urdf:collision/material",)
    scaffold = IN_URDF_LINK

    bad = (
        Bad(
            f'<collision>{SPHERE}<«material» name="red"><color rgba="1 0 0 1"/></material></collision>',
            says="a `material` in `collision` is not read",
        ),
    )
    good = (Good(f'<visual>{SPHERE}<material name="red"><color rgba="1 0 0 1"/></material></visual>'),)

    def check(self, material: Element) -> Iterator[Diagnostic]:
        yield self.diagnostic(material, "a `material` in `collision` is not read; it belongs in `visual`")

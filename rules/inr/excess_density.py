from collections.abc import Iterator
from math import inf, prod

from sdfcheck import IN_LINK, Bad, Diagnostic, Good, Inertial, Rule, Severity
from sdfcheck_rules.inr.moments import is_doubtful, is_out_of_scale

HEAVIEST = 25_000.0
"""kg/m³: above osmium, the heaviest material."""
BEYOND = 100_000.0
"""kg/m³: what is only a part of the shapes cannot explain that."""
LEAST = 0.2
"""kg: what is lighter is often a mark with a tiny box."""
SHEET = 0.005
"""Of the length of a shape: one that is thinner is a picture of something, such as a marker on a wall."""
HEAVIER = 20.0
"""Times the other links of a robot."""
MASS = "<inertial><mass>{}</mass><inertia><ixx>0.1</ixx><iyy>0.1</iyy><izz>0.1</izz></inertia></inertial>"
BOX = '<collision name="c"><geometry><box><size>0.1 0.1 0.1</size></box></geometry></collision>'


class ExcessDensity(Rule):
    """A link is heavier than any material of the size of its shapes.

    Osmium, the heaviest one, has 22,600 kg/m³; robots have 200 to 3,000 within the box around them. A thousand
    times too much is a mass in grams; shapes a tenth of their size have the same effect.
    """

    code = "INR016"
    name = "excess-density"
    severity = Severity.WARNING
    remedy = """Write the mass in kg, or correct the size of the shapes.

    Grams are divided by 1000. Where the mass is right, the shapes lack a scale: compare them with the
    distances between the joints (`sdfcheck graph poses FILE`). The moments of inertia most likely have the
    same mistake.
    """
    looks_at = (Inertial,)
    scaffold = IN_LINK

    bad = (
        Bad(
            MASS.format("«500»") + BOX,
            says="a mass of 500 kg in 0.1 × 0.1 × 0.1 m is 500000 kg/m³, and osmium has 22600: are these grams?",
        ),
    )
    good = (
        Good(MASS.format("8") + BOX, why="steel"),
        Good(
            MASS.format("0.1")
            + '<collision name="c"><geometry><box><size>0.001 0.001 0.001</size></box></geometry></collision>',
            why="a mark of a light part",
        ),
        Good(MASS.format("0.5") + BOX.replace("0.1<", "0.0001<"), why="a marker of paper"),
        Good(
            MASS.format("500")
            + BOX
            + '<visual name="v"><geometry><mesh><uri>missing.stl</uri></mesh></geometry></visual>',
            why="the visual, whose size is not known, may be larger",
        ),
    )

    @staticmethod
    def applies(inertial: Inertial) -> bool:
        return is_too_dense(inertial)

    def check(self, inertial: Inertial) -> Iterator[Diagnostic]:
        box, mass = inertial.link.extent, inertial.mass
        assert box is not None, "it was compared"
        lengths = " × ".join(f"{length:.3g}" for length in box.size)
        yield self.diagnostic(
            mass,
            f"a mass of {mass.text} kg in {lengths} m is {density(inertial):.0f} kg/m³,"
            " and osmium has 22600: are these grams?",
            labels={inertial.link.shapes[0]: "the first of its shapes"},
        )


def density(inertial: Inertial) -> float:
    """kg/m³ within the box around the link's shapes; 0 where that is not known."""
    box = inertial.link.extent if is_doubtful(inertial) else None
    is_solid = box is not None and min(box.size) > SHEET * max(box.size)
    volume = prod(box.size) if box is not None and is_solid else 0.0
    return inertial.mass.number / volume if volume > 0 else 0.0


def is_too_dense(inertial: Inertial) -> bool:
    """Is it denser than any material, and more than a mark of a place?"""
    if not inertial.mass.is_given or (inertial.is_light and not inertial.link.has_mesh):
        return False
    link = inertial.link
    if link.visuals and link.visual_box is None:
        return False
    if (
        link.holder is not None
        and link.holder.kind == "model"
        and link.model.joints
        and not link.parent_joints
    ):
        return False  # the box of a root is often a mark
    mass, found = inertial.mass.number, density(inertial)
    if (
        not found > HEAVIEST
        or not LEAST <= mass < inf
        or any(joint.is_fixed for joint in inertial.link.parent_joints)
    ):
        return False
    if is_out_of_scale(inertial):
        return False
    if found > BEYOND:
        return True
    from statistics import median

    others = [link.inertial.mass.number for link in inertial.link.model.links if link is not inertial.link]
    known = [other for other in others if other > 0]
    return len(known) > 1 and mass > HEAVIER * median(known)

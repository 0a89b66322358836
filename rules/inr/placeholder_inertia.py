from collections.abc import Iterator

from sdfcheck import IN_LINK, Bad, Diagnostic, Good, Inertial, Rule, Severity
from sdfcheck_rules.inr.moments import is_far_off, is_first, is_too_large, is_unit, most, others, ratio
from sdfcheck_rules.inr.ratios import times

ARM = (
    '<link name="arm"><inertial><mass>1</mass></inertial></link><joint name="j" type="ball">'
    "<parent>arm</parent><child>base</child></joint>"
)
UNIT = (
    '<inertial><mass value="0.1"/><inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/></inertial>'
    '<collision><geometry><sphere radius="0.1"/></geometry></collision>'
)


class PlaceholderInertia(Rule):
    """A link has the unit inertia, or that of a cube of one meter, which cannot be that of its body.

    Moments of 1 kg·m² are what exporters write and consumers take when nobody gave any. For a
    link of this mass and size they are off by more than a hundredfold, or larger than those of any body
    within its shapes: it will hardly turn. A sixth of the mass about each axis is a cube of one meter, with which the
    editor of Gazebo Classic begins: for a link of half that length it is four times too much, and more.
    """

    code = "INR005"
    name = "placeholder-inertia"
    severity = Severity.WARNING
    remedy = """Replace the moments by those of the real body: mass × (size in m)² / 6 is near for a cube.

    `sdfcheck rule missing-inertial` lists the ways to compute them. As a check, the radius of gyration
    √(I/m) of a body is a third to a half of its size: for 0.1 kg within 10 cm the moments are about 1e-4
    kg·m², not 1.
    """
    looks_at = (Inertial,)
    scaffold = IN_LINK

    bad = (
        Bad(
            "<inertial><mass>0.1</mass><«inertia»><ixx>1</ixx><iyy>1</iyy><izz>1</izz></inertia></inertial>"
            '<collision name="c"><geometry><box><size>0.1 0.1 0.1</size></box></geometry></collision>',
            says="6000 times",
        ),
        Bad(
            "<«inertial»><mass>0.1</mass></inertial>"
            '<collision name="c"><geometry><box><size>0.1 0.1 0.1</size></box></geometry></collision>',
            says="left out",
        ),
        Bad(
            "<inertial><mass>14</mass><«inertia»><ixx>1</ixx><iyy>1</iyy><izz>1</izz></inertia></inertial>"
            '<collision name="c"><geometry><box><size>0.5 0.4 0.2</size></box></geometry></collision>',
            says="too large: 14 kg within this link's shapes have 0.7 kg·m² about x at most",
        ),
        Bad(
            f'<robot name="r"><link name="a">{UNIT.replace("inertia ", "«inertia» ")}</link>'
            f'<link name="b">{UNIT}</link>'
            '<joint name="j" type="continuous"><parent link="a"/><child link="b"/></joint></robot>',
            scaffold="",
            says="; the same holds for 1 more link with these moments",
        ),
        Bad(
            "<inertial><mass>1.5</mass><«inertia»><ixx>0.25</ixx><iyy>0.25</iyy><izz>0.25</izz></inertia></inertial>"
            '<collision name="c"><geometry><box><size>0.3 0.3 0.1</size></box></geometry></collision>',
            scaffold=IN_LINK.replace("</link>", f"</link>{ARM}"),
            says="the moments are those of a cube of 1 m, 20 times what 1.5 kg in this link's shapes have",
        ),
    )
    good = (
        Good(
            "<inertial><mass>6</mass><inertia><ixx>1</ixx><iyy>1</iyy><izz>1</izz></inertia></inertial>"
            '<collision name="c"><geometry><box><size>1 1 1</size></box></geometry></collision>',
            why="right for this box",
        ),
        Good(
            "<inertial><mass>6</mass><inertia><ixx>1.01</ixx><iyy>1</iyy><izz>1</izz></inertia></inertial>"
            '<collision name="c"><geometry><box><size>0.3 0.3 0.1</size></box></geometry></collision>',
            why="only near it",
        ),
    )

    @staticmethod
    def applies(inertial: Inertial) -> bool:
        return is_first(inertial, is_placeholder)

    def check(self, inertial: Inertial) -> Iterator[Diagnostic]:
        is_written, mass = inertial.inertia is not None, inertial.mass.number
        how = "unit inertia" if is_written else "an inertia that is left out, so 1 kg·m² about each axis,"
        message = f"{how} is {times(ratio(inertial))} what {mass:.6g} kg in this link's shapes have"
        if not is_far_off(inertial):
            least, axis = min(zip(most(inertial), "xyz", strict=True))
            shapes = f"{mass:.6g} kg within this link's shapes"
            message = f"{how} is too large: {shapes} have {least:.2g} kg·m² about {axis} at most"
        if is_cube(inertial):
            shapes = f"{times(ratio(inertial))} what {mass:.6g} kg in this link's shapes have"
            message = f"the moments are those of a cube of 1 m, {shapes}"
        more, labels = others(inertial, is_placeholder)
        place, cause = inertial.moments_element, inertial.misnamed("inertia")
        yield self.diagnostic(
            place, message + more, labels={inertial.link: "this link", **labels}, cause=cause
        )


CUBE = 4.0
"""Times: a cube of half a meter has a quarter of the moments."""


def is_cube(inertial: Inertial) -> bool:
    """Are the moments those of a cube of one meter, and the shapes of this link of a robot far smaller?"""
    if inertial.link.holder is None or inertial.link.holder.kind != "model" or not inertial.link.model.joints:
        return False
    sixth = inertial.mass.number / 6
    xx, yy, zz, *products = inertial.tensor
    if not sixth > 0 or any(products) or not xx == yy == zz or abs(xx - sixth) > 5e-5 * sixth:
        return False
    return ratio(inertial) >= CUBE and not is_far_off(inertial)


def is_placeholder(inertial: Inertial) -> bool:
    if is_cube(inertial):
        return True
    if is_far_off(inertial):
        return is_unit(inertial)
    return inertial.mass.number != 1 and is_unit(inertial) and is_too_large(inertial)

from collections.abc import Iterator
from math import inf, isclose, log10

from sdfcheck import Bad, Diagnostic, Good, Inertial, Rule, Severity
from sdfcheck_rules.inr.moments import (
    MARK,
    is_doubtful,
    is_far_off,
    is_out_of_scale,
    is_too_large,
    is_weighed,
)

UNEQUAL = 3.0
"""The largest moment of a box to its smallest one: that of 2.2 × 1 × 1 m, and of any plate, is less."""
SDF = (
    '<sdf version="1.12"><model name="m"><link name="base"/><link name="rod">{}</link><joint name="j" type="revolute">'
    "<parent>base</parent><child>rod</child><axis><xyz>0 1 0</xyz></axis></joint></model></sdf>"
)
URDF = (
    '<robot name="r"><link name="base"/><link name="rod">{}</link><joint name="j" type="continuous">'
    '<parent link="base"/><child link="rod"/><axis xyz="0 1 0"/></joint></robot>'
)
ROUND = "<inertial><mass>2</mass><«inertia»><ixx>{0}</ixx><iyy>{0}</iyy><izz>{0}</izz></inertia></inertial>"
ROD = '<collision name="c"><geometry><box><size>0.4 0.05 0.05</size></box></geometry></collision>'

URDF_ROD = '<visual><geometry><cylinder radius="0.05" length="0.6"/></geometry></visual>'


class EqualRoundMoments(Rule):
    """The moments of inertia of a long link on a joint are the same round number about each axis.

    They are those of a ball or a cube. A rod turns a hundred times as easily about its own axis as across it; with
    equal moments a controller is tuned to another arm than the real one. Such numbers (0.01, 0.1, 1) are placeholders.
    """

    code = "INR018"
    name = "equal-round-moments"
    severity = Severity.INFO
    remedy = """Write the moments of the link's shapes: `sdfcheck inertia FILE` prints those of what can be filled.

    A box of mass m and edges x, y, z has m (y² + z²) / 12 about x, and so on; `sdfcheck rule missing-inertial` has the
    other shapes. In SDFormat 1.11 and later, `<inertial auto="true">` computes them from the collisions.
    """
    looks_at = (Inertial,)
    scaffold = SDF

    bad = (
        Bad(
            ROUND.format("0.01") + ROD,
            says="each moment is 0.01 kg·m², and a solid of 2 kg in 0.4 × 0.05 × 0.05 m has 0.00083, 0.027 and 0.027",
        ),
        Bad(
            '<inertial><mass value="10"/><«inertia» ixx="1e-1" ixy="0" ixz="0" iyy=".1" iyz="0" izz="0.10"/></inertial>'
            + URDF_ROD,
            scaffold=URDF,
            also=("URD013",),
        ),
    )
    good = (
        Good(
            ROUND.format("0.01").replace("«inertia»", "inertia") + ROD.replace("0.4", "0.08"),
            why="nearly a cube",
        ),
        Good(
            ROUND.format("0.0123").replace("«inertia»", "inertia") + ROD,
            why="a number that somebody measured",
        ),
        Good(
            ROUND.format("1").replace("«inertia»", "inertia").replace("<mass>2<", "<mass>0.1<") + ROD,
            why="placeholder-inertia owns this one",
        ),
    )

    @staticmethod
    def applies(inertial: Inertial) -> bool:
        if not inertial.link.parent_joints or not is_doubtful(inertial) or inertial.inertia is None:
            return False
        if not has_one_round_moment(inertial):
            return False
        if not inertial.mass.number > MARK or not is_weighed(inertial) or is_out_of_scale(inertial):
            return False
        filled = of_box(inertial)
        if not filled or not max(filled) > UNEQUAL * min(filled):
            return False
        return not is_far_off(inertial) and not (inertial.tensor.ixx == 1 and is_too_large(inertial))

    def check(self, inertial: Inertial) -> Iterator[Diagnostic]:
        box = inertial.link.extent
        assert box is not None, "it was compared"
        lengths = " × ".join(f"{length:.3g}" for length in box.size)
        x, y, z = (f"{moment:.2g}" for moment in of_box(inertial))
        yield self.diagnostic(
            inertial.moments_element,
            f"each moment is {inertial.tensor.ixx:g} kg·m², and a solid of {inertial.mass.number:g} kg in {lengths} m"
            f" has {x}, {y} and {z}",
            labels={inertial.link.shapes[0]: "the first of its shapes"},
        )


def has_one_round_moment(inertial: Inertial) -> bool:
    """Are the moments a power of ten about each axis, and the products 0?"""
    moment = inertial.tensor.ixx
    if not 0 < moment < inf or inertial.tensor != (moment,) * 3 + (0.0,) * 3:
        return False
    return isclose(log10(moment), round(log10(moment)), abs_tol=1e-9)


def of_box(inertial: Inertial) -> tuple[float, ...]:
    """The moments (kg·m²) of its mass in the box around the link's shapes; none of an unknown or flat box."""
    box = inertial.link.extent
    if box is None or not min(box.size) > 0:
        return ()
    x, y, z = (length * length for length in box.size)
    return tuple(inertial.mass.number / 12 * square for square in (y + z, x + z, x + y))

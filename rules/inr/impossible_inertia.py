from collections.abc import Iterator, Sequence

from sdfcheck import IN_LINK, IN_URDF_LINK, Bad, Diagnostic, Good, Inertial, Rule, Severity
from sdfcheck_rules.inr.moments import (
    at_edge,
    has_moments,
    in_drake,
    is_impossible,
    is_indefinite,
    once_merged,
)

INERTIA = (
    '<inertial><mass value="1"/><inertia ixx="{0}" ixy="0" ixz="0" iyy="{0}" iyz="0" izz="{1}"/></inertial>'
)
MERGED = (
    f'<robot name="r"><link name="a">{INERTIA.format(8, 8)}</link><link name="b">{INERTIA.format(1, "«9»")}</link>'
    '<joint name="j" type="fixed"><parent link="a"/><child link="b"/></joint></robot>'
)
ROUNDED = "by rounding alone: add a millionth of the largest moment to `ixx`, `iyy` and `izz`"
_BY_ROUNDING = 5e-7
"""The part of the largest moment by which numbers of usual length break the rule though the body does not."""


class ImpossibleInertia(Rule):
    """Principal moments break the triangle inequality, which no distribution of mass can.

    However a mass is spread, each principal moment of inertia is at most the sum of the
    other two. libsdformat refuses the model, also a static one, MuJoCo unless configured
    otherwise; Drake takes a solid sphere in place of the inertia. In URDF libsdformat merges
    links that fixed joints tie together first, and judges the sum.
    """

    code = "INR003"
    name = "impossible-inertia"
    severity = Severity.ERROR
    remedy = """Compute the moments again for one body: each at most the sum of the other two.

    For a box of x × y × z meters `ixx = m/12 · (y² + z²)`, and so on around the axes; for a cylinder along
    z `izz = m r²/2` and `ixx = iyy = m/12 · (3 r² + h²)`; for a sphere `2/5 · m r²`. A thin plate or rod is
    at the edge, and numbers that were rounded fall over it: write at least six digits, or add a millionth of the
    largest moment to all three.
    Moments that were typed in the wrong order or unit break the rule as well.
    """
    looks_at = (Inertial,)
    scaffold = IN_LINK

    bad = (
        Bad(
            "<inertial><mass>1</mass><inertia><ixx>0.001</ixx><iyy>0.001</iyy><izz>«0.1»</izz></inertia></inertial>",
            says="0.1 > 0.001 + 0.001",
        ),
        Bad(
            "<inertial><mass>1</mass><inertia><ixx>8.53333333333e-07</ixx><iyy>«1.70666666667e-06»</iyy>"
            "<izz>8.53333333333e-07</izz></inertia></inertial>",
            says="1.70666666667e-06 > 8.53333333333e-07 + 8.53333333333e-07",
        ),
        Bad(
            '<inertial><origin xyz="0 0.005 0.001"/><mass value="0.0128"/><inertia ixx="6.53141172142094E-07"'
            ' ixy="-1.1293745176837E-07" ixz="-2.06371785964382E-08" iyy="2.25074855995339E-07"'
            ' iyz="-1.15620016000655E-07" izz="«8.3591152010311E-07»"/></inertial>',
            scaffold=IN_URDF_LINK,
            says="8.57063774120273e-07 > 1.7628183242156e-07 + 6.8078194169871",
        ),
        Bad(
            "<inertial><mass>1</mass><inertia><ixx>«0.001»</ixx><iyy>0.001</iyy><izz>0.001</izz>"
            "<ixy>0.001</ixy><ixz>0.001</ixz><iyz>0.001</iyz></inertia></inertial>",
            says="0.003 > 0 + 0",
        ),
        Bad(
            '<sdf version="1.12"><model name="m"><static>true</static><link name="a">'
            "<inertial><inertia><ixx>1</ixx><iyy>1</iyy><izz>«3»</izz></inertia></inertial></link></model></sdf>",
            scaffold="",
        ),
        Bad(MERGED, scaffold="", says="9 > 1 + 1"),
        Bad(
            "<inertial><«inertia»><ixx>0.01</ixx><iyy>0.01</iyy></inertia></inertial>",
            says="1 > 0.01 + 0.01 (`izz` is not written, and 1 by default)",
            also=("SCH004",),
        ),
        Bad(
            '<inertial><mass value="1"/>'
            '<inertia ixx="«0.1»" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/></inertial>',
            scaffold=IN_URDF_LINK,
            says="0.1 > 0.01 + 0.01",
        ),
        Bad(
            '<sdf version="1.9"><world name="w"><model name="m"><link name="l"><inertial><mass>1</mass>'
            "<inertia><ixx>«1»</ixx><iyy>0.1</iyy><izz>0.1</izz></inertia></inertial></link></model></world></sdf>",
            scaffold="",
            says="1 > 0.1 + 0.1",
        ),
    )
    good = (
        Good(
            "<inertial><mass>1</mass><inertia><ixx>0.05</ixx><iyy>0.05</iyy><izz>0.1</izz></inertia></inertial>",
            why="a thin disc: just on the border",
        ),
        Good(
            '<inertial><mass value="1"/>'
            '<inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/></inertial>',
            scaffold=IN_URDF_LINK,
        ),
    )

    @staticmethod
    def applies(inertial: Inertial) -> bool:
        return has_moments(inertial) and is_impossible(inertial) and not is_indefinite(inertial)

    def check(self, inertial: Inertial) -> Iterator[Diagnostic]:
        principal = _broken(inertial)
        low, middle, high = _distinct(principal)
        message = f"no body has these principal moments: {high} > {low} + {middle}"
        largest = max("ixx", "iyy", "izz", key=inertial.moments.__getitem__)
        if not inertial.moments[largest].is_given:
            message += f" (`{largest}` is not written, and {inertial.moments[largest]:g} by default)"
        labels = {inertial.link: "the inertia of this link"}
        yield self.diagnostic(
            inertial.moments[largest],
            message,
            labels=labels,
            help=ROUNDED
            if principal[2] - principal[1] - principal[0] < _BY_ROUNDING * principal[2]
            else None,
            affects=once_merged(inertial) | at_edge(inertial) | in_drake(inertial),
        )


def _broken(inertial: Inertial) -> Sequence[float]:
    """The principal moments, at the edge with the errors of libsdformat, which refuses them for these."""
    low, middle, high = inertial.principal
    return inertial.principal if low + middle < high * (1 - 1e-9) else inertial.tensor.computed_by_gazebo()


def _distinct(principal: Sequence[float]) -> list[str]:
    """The moments, smallest first, in as many digits as show by how much the largest is too large."""
    # Small rounding errors of a computed 0 count as 0.
    principal = [moment if abs(moment) > principal[2] * 1e-14 else 0.0 for moment in principal]
    excess = principal[2] - principal[1] - principal[0]
    for digits in range(6, 18):
        shown = [f"{moment:.{digits}g}" for moment in principal]
        low, middle, high = map(float, shown)
        if abs(high - middle - low - excess) <= excess / 2:
            break
    return shown

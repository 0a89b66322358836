from collections.abc import Iterator

from sdfcheck import IN_ROBOT, Bad, Diagnostic, Good, Inertial, Rule, Severity
from sdfcheck_rules.muj.mass import is_massless

LEAST = 1e-14
"""The least principal moment (kg·m²), unless all are 0."""
MASS = '<link name="arm"><inertial><mass value="1"/>{}</inertial></link>'
INERTIA = '<inertia ixx="{}" iyy="{}" izz="{}" ixy="0" ixz="0" iyz="0"/>'
FIXED = '<joint name="j" type="fixed"><parent link="base"/><child link="arm"/></joint>'
PUT = MASS.format("{}") + FIXED


class SingularInertia(Rule):
    """A principal moment of a link is 0 and others are not.

    MuJoCo refuses the robot, wherever the link is, the root included; it takes a principal moment
    below 1e-14 kg·m² for 0. Moments that are all exactly 0 make a point mass, which may be fixed to something.
    """

    code = "MUJ004"
    name = "singular-inertia"
    severity = Severity.ERROR
    remedy = """Write three positive principal moments: none of a body with volume is 0.

    A thin rod along x has an `ixx` of m r² / 2, small but not 0. If all the link is for is to carry other
    links, leave its `<inertial>` out and fix it to one with mass.
    """
    default = False
    looks_at = (Inertial,)
    scaffold = IN_ROBOT

    bad = (
        Bad(
            PUT.format(INERTIA.format("1", "1", "«0»")),
            says="the smallest principal moment of link `arm` is 0",
        ),
        Bad(PUT.format(INERTIA.format("«1e-15»", "1e-15", "1e-15")), says="is 1e-15"),
    )
    good = (
        Good(PUT.format(INERTIA.format("0", "0", "0")), why="a point mass"),
        Good(PUT.format(INERTIA.format("1", "1", "1e-14")), why="just enough"),
    )

    @staticmethod
    def applies(inertial: Inertial) -> bool:
        if not inertial.is_urdf or inertial.inertia is None or not inertial.is_legible:
            return False
        low, _, high = inertial.principal
        if low >= LEAST or high <= 0 or inertial.tensor.is_indefinite or inertial.tensor.is_impossible:
            return False
        return not is_massless(inertial.link)

    def check(self, inertial: Inertial) -> Iterator[Diagnostic]:
        least = min("ixx", "iyy", "izz", key=lambda name: float(inertial.moments[name]))
        low = max(inertial.principal[0], 0.0)
        yield self.diagnostic(
            inertial.moments[least],
            f"the smallest principal moment of {inertial.link.title} is {low:.3g}: MuJoCo refuses the file",
        )

from collections.abc import Iterator
from math import sqrt

from sdfcheck import IN_LINK, IN_URDF_LINK, Bad, Diagnostic, Good, Inertial, Number, Rule, Severity
from sdfcheck_rules.inr.moments import has_moments, in_drake, is_indefinite, once_merged


class IndefiniteInertia(Rule):
    """An inertia tensor is not positive definite, so the body would gain energy from turning.

    libsdformat and MuJoCo refuse the model; Drake takes a solid sphere in place of the inertia. Common
    causes are a sign lost on the way from a CAD program, and products of inertia that are larger than
    the moments. In URDF libsdformat merges links that fixed joints tie together first, and judges the sum.
    """

    code = "INR002"
    name = "indefinite-inertia"
    severity = Severity.ERROR
    remedy = """Write the six numbers of a real body: positive moments, and products smaller than them.

    Compute them anew for the mass and the shape (`sdfcheck rule missing-inertial` says how), or export them
    again. CAD programs differ in the sign of the products: SDFormat and URDF want `ixy = -∫ x y dm`, which
    some programs print with the opposite sign. Make sure that the numbers are about the center of mass, and
    that none lost its exponent.
    """
    looks_at = (Inertial,)
    scaffold = IN_LINK

    bad = (
        Bad(
            "<inertial><mass>1</mass><inertia><ixx>«-0.1»</ixx><iyy>0.1</iyy><izz>0.1</izz></inertia></inertial>",
            says="ixx -0.1 is negative",
        ),
        Bad(
            "<inertial><mass>1</mass><inertia><ixx>0.1</ixx><iyy>0.1</iyy><izz>0.1</izz><ixy>«0.5»</ixy>"
            "</inertia></inertial>",
            says="ixy 0.5 is too large beside ixx and iyy",
        ),
        Bad(
            "<inertial><mass>1</mass><«inertia»><ixx>0.1</ixx><iyy>0.1</iyy><izz>0.1</izz><ixy>0.09</ixy>"
            "<ixz>0.09</ixz><iyz>-0.09</iyz></inertia></inertial>",
            says="smallest principal moment is -0.08",
        ),
        Bad(
            '<inertial><mass value="1"/>'
            '<inertia ixx="«-0.1»" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/></inertial>',
            scaffold=IN_URDF_LINK,
            says="ixx -0.1 is negative",
        ),
        Bad(
            '<sdf version="1.9"><world name="w"><model name="m"><link name="l"><inertial><mass>1</mass>'
            "<inertia><ixx>«-1»</ixx><iyy>0.1</iyy><izz>0.1</izz></inertia></inertial></link></model></world></sdf>",
            scaffold="",
            says="ixx -1 is negative",
        ),
    )
    good = (
        Good(
            "<inertial><mass>1</mass><inertia><ixx>0.1</ixx><iyy>0.1</iyy><izz>0.1</izz><ixy>-0.01</ixy>"
            "</inertia></inertial>",
            why="products may be negative",
        ),
        Good(
            '<inertial><mass value="1"/>'
            '<inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/></inertial>',
            scaffold=IN_URDF_LINK,
        ),
    )

    @staticmethod
    def applies(inertial: Inertial) -> bool:
        return has_moments(inertial) and is_indefinite(inertial)

    def check(self, inertial: Inertial) -> Iterator[Diagnostic]:
        labels, affects = (
            {inertial.link: "the inertia of this link"},
            once_merged(inertial) | in_drake(inertial),
        )
        name = _culprit(inertial.moments)
        if name is not None:
            moment = inertial.moments[name]
            reason = "negative" if name in _DIAGONAL else _too_large(name)
            message = f"{name} {moment.text} is {reason}: the inertia is not positive definite"
            yield self.diagnostic(moment, message, labels=labels, affects=affects)
            return
        smallest = inertial.principal[0]
        message = f"the inertia is not positive definite: its smallest principal moment is {smallest:.6g}"
        yield self.diagnostic(inertial.moments_element, message, labels=labels, affects=affects)


_DIAGONAL = ("ixx", "iyy", "izz")


def _culprit(moments: dict[str, Number]) -> str | None:
    """The one component that makes a tensor indefinite: a negative moment, or too large a product."""
    negative = next((name for name in _DIAGONAL if moments[name] < 0), None)
    if negative is not None:
        return negative
    too_large = [
        name
        for name, moment in moments.items()
        if name not in _DIAGONAL and abs(moment) > sqrt(moments[_first(name)]) * sqrt(moments[_second(name)])
    ]
    return too_large[0] if len(too_large) == 1 else None


def _first(product: str) -> str:
    return f"i{product[1]}{product[1]}"


def _second(product: str) -> str:
    return f"i{product[2]}{product[2]}"


def _too_large(product: str) -> str:
    return f"too large beside {_first(product)} and {_second(product)}"

from collections.abc import Iterator

from sdfcheck import (
    IN_LINK,
    Bad,
    Collision,
    Consumer,
    Diagnostic,
    Good,
    Inertial,
    Number,
    Rule,
    Severity,
    warns,
)

_NO_SOLID = frozenset({"", "plane", "heightmap", "polyline", "image", "empty"})


class UnusableAutomaticInertia(Rule):
    """An inertia is to be computed from collisions that do not give one.

    `<inertial auto="true">` (from 1.11) takes mass and moments from the link's collisions:
    there must be one, each with a volume and a positive density. libsdformat refuses the
    model otherwise.
    """

    code = "INR008"
    name = "unusable-automatic-inertia"
    severity = Severity.ERROR
    remedy = """Give the link a collision with a volume and a positive `<density>`, or write the numbers.

    Box, capsule, cone, cylinder, ellipsoid, sphere and closed meshes have a volume; planes, heightmaps and
    `<empty/>` have none. The density is in kg/m³ (water 1000, aluminum 2700) and can be in each collision
    or in the `<inertial auto="true">`. A link without collision needs a written `<inertial>`.
    """
    looks_at = (Inertial,)
    scaffold = IN_LINK

    bad = (
        Bad('<«inertial» auto="true"/>', says="no collision"),
        Bad(
            '<inertial auto="true"/><«collision» name="c"><density>1</density><geometry><plane><normal>0 0 1</normal>'
            "<size>1 1</size></plane></geometry></collision>",
            says="a plane has no volume",
        ),
        Bad(
            '<inertial auto="true"/><collision name="c"><«density»>-1</density><geometry><box><size>1 1 1</size></box>'
            "</geometry></collision>",
            says="density -1",
        ),
    )
    good = (
        Good(
            '<inertial auto="true"/><collision name="c"><density>800</density><geometry><box><size>1 1 1</size></box>'
            "</geometry></collision>"
        ),
    )

    @staticmethod
    def applies(inertial: Inertial) -> bool:
        if inertial.is_unremarkable or not inertial.is_automatic or inertial.link.may_be_static:
            return False
        collisions = inertial.link.collisions
        return not collisions or any(
            _has_no_mass(_density(inertial, collision)) or collision.geometry.shape in _NO_SOLID
            for collision in collisions
        )

    def check(self, inertial: Inertial) -> Iterator[Diagnostic]:
        message = f"the inertia of link `{inertial.link.name}` cannot be computed"
        if not inertial.link.collisions:
            yield self.diagnostic(inertial, f"{message}: the link has no collision")
        for collision in inertial.link.collisions:
            density, shape = _density(inertial, collision), collision.geometry.shape
            if _has_no_mass(density) and density.value is not None:
                affects = {Consumer.DRAKE: warns("takes a solid sphere in its place")}
                reason = f"density {density.text} is not positive"
                yield self.diagnostic(density.value.element, f"{message}: {reason}", affects=affects)
            elif shape in _NO_SOLID:
                named = "an empty geometry" if shape == "empty" else f"a {shape}"
                what = named if shape else "a collision without shape"
                yield self.diagnostic(collision, f"{message}: {what} has no volume")


def _density(inertial: Inertial, collision: Collision) -> Number:
    return collision.density if collision.density.is_given else inertial.density


def _has_no_mass(density: Number) -> bool:
    return density.number <= 0

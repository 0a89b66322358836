"""The friction of a collision as Drake takes it: from its own elements, else from the settings of ODE."""

from sdfcheck import Collision, Element

OWN = ("drake:mu_dynamic", "drake:mu_static")
NOT_MADE = frozenset(("cone", "empty", "heightmap", "image", "polyline"))
"""The shapes of which Drake makes no geometry; it does not look at the friction of these."""


def friction(collision: Collision) -> Element | None:
    """The standard friction of a collision, if Drake looks at it."""
    return None if collision.geometry.shape in NOT_MADE else collision.surface.find("friction")


def own_friction(collision: Collision) -> Element | None:
    """The first friction in Drake's own elements."""
    properties = collision.find("drake:proximity_properties")
    found = (properties.find(name) for name in OWN) if properties is not None else ()
    return next((element for element in found if element is not None), None)

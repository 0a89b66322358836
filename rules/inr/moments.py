"""Shared checks of the moments of inertia in this family.

The hard conditions are those of libsdformat, which has them for what is static, too. The soft
ones compare with homogeneous solids of the link's own primitive shapes, of what moves; only traces
are compared, which no rotation changes.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator

from sdfcheck import Consumer, Element, Inertial, Joint, Link, Reaction, accepts, refuses

_LITTLE, _EXACTLY = 2.0, 0.05
"""Of 1,920 solids in public robots none was twice its moments and, about the origin, within 5 % of them."""
MARK = 1e-3
"""kg: links that are not heavier mark places; their place and their moments, unless large, make no difference."""
_SHOWN = 3
"""Of other places, so many are marked."""
_FACTOR = 100.0
"""More than this off a solid of the same mass and shape is not a modeling choice any more."""


def is_remarkable(inertial: Inertial) -> bool:
    """Are the numbers of a body written, and not beyond doubt?"""
    return not (inertial.is_unremarkable or inertial.is_automatic)


def has_moments(inertial: Inertial) -> bool:
    """The same of moments that can be read, with a mass that libsdformat takes: above 0, in SDFormat also 0."""
    return is_remarkable(inertial) and is_weighed(inertial)


def is_weighed(inertial: Inertial) -> bool:
    """Can the moments be read, and is there such a mass?"""
    if not inertial.is_legible:
        return False
    mass = inertial.mass
    if mass.number == 0 and mass.is_given:
        return not inertial.is_urdf
    return not mass.is_given or mass.number > 0 or "$" in mass.text  # which xacro has yet to fill in


def has_moments_only(inertial: Inertial) -> bool:
    """In URDF: has a link moments and a mass of 0, and do links with mass hold it?

    Of one that moves, and of a root, other rules report that it has no mass.
    """
    if not inertial.is_legible or not any(inertial.tensor):
        return False
    built = inertial.link.model.as_built_by(Consumer.GAZEBO)
    return built.base(inertial.link) in built.with_mass


def is_indefinite(inertial: Inertial) -> bool:
    """Is a principal moment negative?"""
    return inertial.tensor.is_indefinite


def is_impossible(inertial: Inertial) -> bool:
    """Is a principal moment larger than the sum of the other two?"""
    return inertial.tensor.is_impossible


def once_merged(inertial: Inertial) -> dict[Consumer, Reaction]:
    """The reaction of libsdformat to a link's impossible moments where it does not judge the link by itself.

    In URDF it merges links that fixed joints tie together, and judges the sum of their moments.
    """
    if not inertial.is_urdf:
        return {}
    built, link = inertial.link.model.as_built_by(Consumer.GAZEBO), inertial.link
    if link.name == "world" or built.is_dropped(link):
        return {Consumer.GAZEBO: accepts("makes no link of it")}
    base = built.base(link)
    moments = built.moments(base)
    if not math.isfinite(moments.trace) or moments.is_indefinite or moments.is_impossible:
        return {}
    return {Consumer.GAZEBO: accepts("takes the moments of the link that it builds")}


def in_drake(inertial: Inertial) -> dict[Consumer, Reaction]:
    """The reaction of Drake to a body that cannot be, in a world: with libsdformat it refuses a world for any error."""
    if any(each.name == "world" for each in inertial.element.around):
        return {Consumer.DRAKE: refuses("loads no world with such a body")}
    return {}


def at_edge(inertial: Inertial) -> dict[Consumer, Reaction]:
    """The reactions of those that work out the moments otherwise, where only libsdformat's errors break the rule."""
    low, middle, high = inertial.principal
    if low + middle < high:
        return {}
    return dict.fromkeys((Consumer.DRAKE, Consumer.MUJOCO), accepts("takes it"))


def is_doubtful(inertial: Inertial) -> bool:
    """Is it worth comparing the mass and the axes with the link's shapes?"""
    return (not inertial.fits_shapes or inertial.link.has_mesh) and is_written(inertial)


def is_written(inertial: Inertial) -> bool:
    """Are there numbers of a body that moves?"""
    return inertial.is_given and not inertial.is_automatic and not inertial.link.may_be_static


def ratio(inertial: Inertial) -> float:
    """The moments to those of a solid of this mass in the link's shapes; nan where that says nothing.

    Nor does it where the shapes are a hundred times too large or too small: those are reported.
    """
    if inertial.is_near and not inertial.link.has_mesh:
        return math.nan
    if not is_written(inertial) or not is_weighed(inertial):
        return math.nan
    if is_indefinite(inertial) or is_impossible(inertial):
        return math.nan
    expected, trace = inertial.solid_trace, inertial.tensor.trace
    found = trace / expected if 0 < expected < math.inf and 0 < trace < math.inf else math.nan
    return math.nan if (found > _FACTOR or found < 1 / _FACTOR) and is_out_of_scale(inertial) else found


def is_out_of_scale(inertial: Inertial) -> bool:
    """Are the shapes of the link, or of the whole robot, far too large or too small? Other rules report that."""
    link = inertial.link
    if link.size_to_reach > _FACTOR or link.size_to_reach < 1 / _FACTOR:
        return True
    return link.holder is not None and link.holder.kind == "model" and link.model.is_out_of_scale


def is_far_off(inertial: Inertial) -> bool:
    """Is it off by more than any choice of modeling explains?"""
    if inertial.is_unremarkable and not inertial.link.has_mesh:
        return False
    found = ratio(inertial)
    return (found < 1 / _FACTOR or found > _FACTOR) and not is_about_origin(inertial)


def copies(inertial: Inertial, applies: Callable[[Inertial], bool]) -> Iterator[Inertial]:
    """The inertials of its robot with its moments of which the same is to say, in the order of the file."""
    link = inertial.link
    is_in_robot = link.holder is not None and link.holder.kind == "model"
    alike = link.model.alike_inertials.get(link.element, [inertial]) if is_in_robot else [inertial]
    return (each for each in alike if each.document is inertial.document and applies(each))


def is_first(inertial: Inertial, applies: Callable[[Inertial], bool]) -> bool:
    """Does something hold of it, and of none before it with the same moments? One number is written in many links."""
    return applies(inertial) and next(copies(inertial, applies), inertial) is inertial


def others(inertial: Inertial, applies: Callable[[Inertial], bool]) -> tuple[str, dict[Element, str]]:
    """The other links with its moments of which the same is to say: words for a message, and labels at some of them."""
    _, *found = copies(inertial, applies)
    if not found:
        return "", {}
    words = f"; the same holds for {len(found)} more link{'s' * (len(found) > 1)} with these moments"
    return words, {each.moments_element: "the same" for each in found[:_SHOWN]}


def is_about_origin(inertial: Inertial) -> bool:
    """Do moments that are too large fit once they are shifted from the link's origin to the center of mass?

    Roughly where they are far too large, exactly where they are not: a rod about its end has four times its moments.
    """
    if inertial.is_near and not inertial.link.has_mesh:
        return False
    if not any(inertial.center or ()) or inertial.inertia is None or inertial.center is None:
        return False
    found = ratio(inertial)
    if not found > _LITTLE:
        return False
    offset = math.hypot(*inertial.center)
    shifted = (inertial.tensor.trace - 2 * inertial.mass.number * offset * offset) / inertial.solid_trace
    if not offset > 0:
        return False
    if found > 10:
        return 1 / 3 < shifted < 3
    return bool(inertial.link.solids) and abs(shifted - 1) < _EXACTLY and not is_round(inertial)


def is_round(inertial: Inertial) -> bool:
    """Are the moments equal? About a point off the center of mass they are not: there is one axis through both."""
    return len(set(inertial.tensor[:3])) == 1


def is_unit(inertial: Inertial) -> bool:
    """Are the moments 1 kg·m² about each axis?"""
    return inertial.tensor == (1, 1, 1, 0, 0, 0)


def is_too_large(inertial: Inertial) -> bool:
    """Is a moment larger than that of any body of this mass within the box around the link's shapes?

    A mass of 1 kg was not thought about either: test worlds are full of such bodies.
    """
    if not is_written(inertial) or not 0 < inertial.mass.number != 1 or is_out_of_scale(inertial):
        return False
    return any(moment > bound for moment, bound in zip(inertial.tensor[:3], most(inertial), strict=False))


def most(inertial: Inertial) -> tuple[float, ...]:
    """The moments (kg·m²) of its mass spread over the edges of the box around the shapes; none of an unknown box."""
    box = inertial.link.extent
    if box is None:
        return ()
    x, y, z = (length * length for length in box.size)
    return tuple(inertial.mass.number / 4 * square for square in (y + z, x + z, x + y))


def joints_to_world(link: Link) -> tuple[Joint, ...]:
    """The joints of SDFormat by which the world holds it."""
    if link.is_urdf or link.holder is None or link.holder.kind != "model":
        return ()
    return tuple(
        joint for joint in link.model.joints if joint.parent_name == "world" and joint.child_link is link
    )

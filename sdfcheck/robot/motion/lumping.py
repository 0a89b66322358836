"""The links of a URDF robot in libsdformat: it merges those that fixed joints tie together.

It begins at the root, or at the links that hang on a root called ``world``, and leaves out
a link without mass with all that hangs on it. Source: libsdformat 17's parser_urdf.cc, and what
libsdformat 12.3 builds.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import TYPE_CHECKING

from sdfcheck.robot.values import lazy

if TYPE_CHECKING:
    from sdfcheck.robot.model import Model
    from sdfcheck.robot.parts.link import Link
    from sdfcheck.robot.parts.solids import Moments

WORLD = "world"
LEAST = 1e-6
"""kg: a mass that is not above it counts as none."""


class Lumping:
    """The links of a URDF robot, merged by its fixed joints."""

    def __init__(self, model: Model) -> None:
        self.model = model
        tree = model.tree
        self.tops: list[Link] = []
        """The links with which libsdformat begins: the root, or what hangs on a root called ``world``."""
        for root in tree.main_roots:
            if root.name != WORLD:
                self.tops.append(root)
                continue
            below = (joint.child_link for joint in root.child_joints)
            self.tops += [link for link in below if link is not None]

    @lazy
    def masses(self) -> dict[Link, float]:
        """The masses (kg) of links and of the links that are merged into them; infinite where one is not known."""
        masses = {link: _mass(link) for link in self.model.tree.links.values()}
        below = self.model.tree.below(*dict.fromkeys(self.tops))
        for link in reversed(list(below)):
            for joint in link.parent_joints:
                parent = joint.parent_link
                if joint.is_lumped and parent is not None:
                    masses[parent] += masses[link]
        return masses

    @lazy
    def with_mass(self) -> set[Link]:
        """The links that have mass, their own or that of links that are merged into them."""
        return {link for link, mass in self.masses.items() if abs(mass) > LEAST}

    def is_dropped(self, link: Link) -> bool:
        """Is it left out: without mass once links are merged, or on such a link?"""
        seen: set[Link] = set()
        while link not in seen:
            seen.add(link)
            base = self.base(link)
            if base not in self.with_mass:
                return True
            above = base.parent_joints[0].parent_link if base.parent_joints else None
            if above is None or above.name == WORLD:
                return False
            link = above
        return False

    def base(self, link: Link) -> Link:
        """The link into which a link is merged; the link itself where it is merged into none."""
        seen = {link}
        while link.parent_joints and link.parent_joints[0].is_lumped:
            parent = link.parent_joints[0].parent_link
            if parent is None or parent in seen:
                break
            seen.add(parent)
            link = parent
        return link

    def members(self, base: Link) -> Iterator[Link]:
        """A link and all links that are merged into it."""
        return (link for link in base.below() if self.base(link) is base)

    def moments(self, base: Link) -> Moments:
        """The moments (kg·m²) of a link and of all that is merged into it, about their center of mass.

        They are nan where that cannot be worked out.
        """
        from sdfcheck.robot.motion.merging import merged_moments

        return merged_moments(self.members(base))


def _mass(link: Link) -> float:
    """The mass of a link, infinite where it cannot be read."""
    if not link.has_mass:
        return 0.0
    mass = link.inertial.mass.number
    return math.inf if math.isnan(mass) else mass

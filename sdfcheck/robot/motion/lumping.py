"""What libsdformat makes of the links of a URDF robot: it merges those that fixed joints tie together.

It begins at the root, or at the links that hang on a root called ``world``, and leaves out
a link without mass with all that hangs on it. Source: libsdformat 17's parser_urdf.cc.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from sdfcheck.robot.model import Model
    from sdfcheck.robot.parts.link import Link

WORLD = "world"


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
        self.with_mass: set[Link] = {link for link in tree.links.values() if link.has_mass}
        """The links that have mass, their own or that of a link that is merged into them."""
        waiting = list(self.with_mass)
        while waiting:
            for joint in waiting.pop().parent_joints:
                parent = joint.parent_link
                if joint.is_lumped and parent is not None and parent not in self.with_mass:
                    self.with_mass.add(parent)
                    waiting.append(parent)

"""The names by which the joints of a URDF robot call its links, and those that the links have."""

from __future__ import annotations

from collections import Counter
from typing import TYPE_CHECKING

from sdfcheck.formats.urdf.table import is_expression
from sdfcheck.robot.values import lazy

if TYPE_CHECKING:
    from sdfcheck.robot.model import Model
    from sdfcheck.robot.parts.link import Link
    from sdfcheck.source.element import Value


class LinkNames:
    """Which mistake explains a name that joints use and no link has: that in the joint, or that in the link."""

    def __init__(self, model: Model) -> None:
        self.model = model
        self.links: dict[str, Link] = model.tree.links
        self.unknown: dict[str, list[Value]] = {}
        """The names that joints use and no link has, with the places; unexpanded expressions are left out."""
        for joint in model.joints:
            for value in (joint.parent_value, joint.child_value):
                if value is not None and value.text not in self.links and not is_expression(value.text):
                    self.unknown.setdefault(value.text, []).append(value)

    @property
    def explained(self) -> set[str]:
        """The unknown names for which links are at fault, so that they are reported there."""
        return {*self.lost, *self.misspelled} if self.unknown else set()

    @lazy
    def lost(self) -> frozenset[str]:
        """The unknown names that belong to links without a name, or with that of another link."""
        if not self.unknown:
            return frozenset()
        nameless = self._nameless
        if len(self.unknown) <= nameless:
            return frozenset(self.unknown)
        doubled = len(self.model.links) - len(self.links) - self._unnamed
        if not doubled:
            return frozenset()
        from sdfcheck.formats.suggest import suggest_in

        # A name like that of a link may be misspelled, while a link with the name of another has lost any name.
        document = self.model.document
        unlike = frozenset(name for name in self.unknown if suggest_in(document, name, self.links) is None)
        return unlike if len(unlike) <= nameless + doubled else frozenset()

    @lazy
    def misspelled(self) -> dict[str, Link]:
        """Unknown names on which several joint ends agree → the link, used by no joint, that they mean."""
        agreed = [name for name, values in self.unknown.items() if len(values) > 1]
        if not agreed:
            return {}
        from sdfcheck.formats.suggest import suggest_in

        used = {name for joint in self.model.joints for name in (joint.parent_name, joint.child_name)}
        free = [name for name in self.links if name not in used]
        document = self.model.document
        found = {name: meant for name in agreed if (meant := suggest_in(document, name, free)) is not None}
        times = Counter(found.values())
        return {name: self.links[meant] for name, meant in found.items() if times[meant] == 1}

    @property
    def _unnamed(self) -> int:
        return sum(not link.name or is_expression(link.name) for link in self.model.links)

    @property
    def _nameless(self) -> int:
        """How many links have no name, one that is yet to be expanded, or are not even called ``link``."""
        from sdfcheck.formats.suggest import suggest
        from sdfcheck.formats.urdf.table import urdf

        known = urdf().children
        others = (child.name for child in self.model.children() if child.name not in known)
        return self._unnamed + sum(suggest(name, ("joint", "link")) == "link" for name in others)

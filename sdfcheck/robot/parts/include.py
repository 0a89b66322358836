"""Includes: other files that become part of a model or world."""

from __future__ import annotations

from typing import TYPE_CHECKING

from sdfcheck.robot.parts.resource import FileUse
from sdfcheck.robot.values import is_true, lazy

if TYPE_CHECKING:
    from sdfcheck.robot.includes.included import Included, Obstacle
    from sdfcheck.robot.model import Model
    from sdfcheck.robot.node import Node
    from sdfcheck.source.element import Element, Value


class Include(FileUse):
    """An ``include``."""

    __slots__ = ()
    kind = "include"

    @property
    def name(self) -> str:
        """The name that it gives to what it brings; empty where it gives none."""
        name = self.find("name")
        return name.content if name is not None else ""

    @lazy
    def uri_value(self) -> Value | None:
        """The uri with its place; None where there is none."""
        uri = self.find("uri")
        return uri.own_value if uri is not None and uri.content else None

    @lazy
    def found(self) -> Included:
        """Its target: file, document, model, or why there is not one."""
        from sdfcheck.robot.includes.included import included

        return included(self.document, self.element)

    # Where it leads

    @property
    def obstacle(self) -> Obstacle | None:
        """Why it brings nothing; None where it brings something, and for a text without other files around it."""
        return self.found.obstacle if self.document.library is not None else None

    @property
    def leads_nowhere(self) -> bool:
        """Is nothing where the uri leads, or nothing that is looked up?"""
        if self.obstacle is None or self._misspelling is not None:
            return False
        from sdfcheck.robot.includes.included import Obstacle

        return self.obstacle is Obstacle.NOT_FOUND

    @property
    def needs_config(self) -> bool:
        """Does it lead to a folder that has no ``model.config``?"""
        if self.obstacle is None or self._misspelling is not None:
            return False
        from sdfcheck.robot.includes.included import Obstacle

        return self.obstacle is Obstacle.NO_CONFIG

    @property
    def is_read_in_vain(self) -> bool:
        """Does it lead to a file that cannot be included? A file that is not XML is reported in that file."""
        if self.obstacle is None or self.found.file is None or self._misspelling is not None:
            return False
        from sdfcheck.robot.includes.included import Obstacle

        return self.obstacle not in {Obstacle.BROKEN, Obstacle.OUTSIDE}

    @property
    def is_searched_for(self) -> bool:
        """Does it name a model or package that is looked for on search paths? Nothing near by has been found, then.

        To libsdformat a bare word is the name of a model, too.
        """
        if self.location is None:
            return False
        is_word = not self.location.scheme and not {*self.uri} & {"/", "\\", "."}
        return is_word or (self.location.is_searched_for and self.location.owner is None)

    @property
    def is_misconfigured(self) -> bool:
        """Does it lead to a model folder that has a ``manifest.xml`` of old instead of a ``model.config``?"""
        config = self.found.config
        return config is not None and config.path.name == "manifest.xml"

    @lazy
    def ring(self) -> tuple[Value, ...]:
        """The uris that lead from it back to its file, outside in; empty if they do not."""
        if self.document.library is None or self.found.document is None:
            return ()
        from sdfcheck.robot.includes.included import ring

        return ring(self.document, self.element)

    # Content

    @property
    def placement_frame_value(self) -> Value | None:
        """The name of the frame of the model that its pose places, with its place; None if there is none."""
        placement = self.find("placement_frame")
        return placement.own_value if placement is not None and placement.content else None

    @lazy
    def node(self) -> Node | None:
        """The model that it brings whole, or the frame of one that it merges; None if neither."""
        from sdfcheck.robot.scope import Scope

        if not isinstance(self.holder, Scope):
            return None
        return next((node for node in self.holder.nodes.values() if node.place is self.element), None)

    @property
    def model(self) -> Model | None:
        """The model that it brings whole; None if it brings none, or merges it."""
        from sdfcheck.robot.model import Model

        return self.node if isinstance(self.node, Model) else None

    @property
    def content(self) -> Model | None:
        """The model that it brings, whole or merged."""
        from sdfcheck.robot.frame import MergedFrame

        return self.node.model if isinstance(self.node, MergedFrame) else self.model

    @property
    def brought(self) -> Element | None:
        """The model, actor or light of the file that it leads to; None if there is none."""
        return self.found.model

    @property
    def is_merged(self) -> bool:
        """Do the parts of the model become parts of the one that includes it?"""
        return is_true(self._text("merge") or "")

    @property
    def merged_parts(self) -> tuple[tuple[str, str], ...]:
        """Kind and name of what moves from the model into the one that includes it, where it is merged."""
        if not self.is_merged or self.brought is None:
            return ()
        from sdfcheck.robot.includes.merges import moved

        return tuple((kind, name) for kind, name, _ in moved(self.found))

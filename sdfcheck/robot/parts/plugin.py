"""Plugins."""

from __future__ import annotations

from typing import TYPE_CHECKING

from sdfcheck.robot.part import Part

if TYPE_CHECKING:
    from sdfcheck.source.element import Value


class Plugin(Part):
    """A plugin, of a world, model, sensor, visual or ``<gazebo>`` block; its parameters are its own."""

    __slots__ = ()
    kind = "plugin"

    @property
    def filename(self) -> str:
        """The library as written, without blanks around it."""
        return (self._text("filename") or "").strip()

    @property
    def filename_value(self) -> Value | None:
        """The library with its place."""
        return self.attribute("filename")

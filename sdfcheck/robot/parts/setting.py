"""Settings: elements that have a meaning of their own in no other class."""

from __future__ import annotations

from sdfcheck.robot.part import Part


class Setting(Part):
    """An element of the format that is read by its name: ``camera``, ``ode``, ``noise`` …"""

    __slots__ = ()
    kind = "setting"

    @property
    def settings(self) -> tuple[Part, ...]:
        """The parts that its child elements make."""
        return tuple(self.part(child) for child in self.children())

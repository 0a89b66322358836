"""Materials: colors and textures."""

from __future__ import annotations

from typing import TYPE_CHECKING

from sdfcheck.robot.part import Part
from sdfcheck.robot.values import Vector

if TYPE_CHECKING:
    from sdfcheck.source.element import Element

_WITHOUT_ALPHA = 3


class Material(Part):
    """The material of a visual, or one that a URDF robot defines for all its links."""

    __slots__ = ()
    kind = "material"

    @property
    def color(self) -> Vector | None:
        """Red, green, blue, alpha: in SDFormat the diffuse color; None where there is none."""
        if self.is_urdf:
            color = self.find("color")
            return Vector.of(color.attribute("rgba"), color, ()) if color is not None else None
        return self.light("diffuse")

    def light(self, name: str) -> Vector | None:
        """The color of ``ambient``, ``diffuse``, ``specular`` or ``emissive`` light; None where it is not given.

        An alpha that SDFormat leaves out is 1.
        """
        child = self.find(name)
        if child is None:
            return None
        color = Vector.of(child.own_value, child, ())
        if len(color) != _WITHOUT_ALPHA:
            return color
        whole = Vector((*color, 1.0))
        whole.value, whole.element = color.value, color.element
        return whole

    @property
    def texture(self) -> str:
        """The file of the texture of URDF; empty if there is none."""
        texture = self.find("texture") if self.is_urdf else None
        return texture.attributes.get("filename", "") if texture is not None else ""

    @property
    def script(self) -> Element | None:
        """The script of Gazebo Classic."""
        return None if self.is_urdf else self.find("script")

    @property
    def has_look(self) -> bool:
        """Does it say what it looks like, instead of naming another?"""
        return self.has("color") or self.has("texture") if self.is_urdf else self.is_given

    @property
    def look(self) -> tuple[object, object]:
        """In URDF: color and texture, to be compared; None for one that it does not have."""
        color = self.color
        return (
            None if color is None else tuple(color) or color.text,
            self.texture if self.has("texture") else None,
        )

    @property
    def defined(self) -> Material:
        """In URDF: itself, or the robot's material of this name where only the name is given."""
        from sdfcheck.robot.model import Model

        model = self.within(Model)
        if self.has_look or model is None:
            return self
        return model.materials_by_name.get(self.name, self)

"""Materials: colours as they are, textures as albedo maps."""

from __future__ import annotations

from collections.abc import Callable

from sdfcheck.convert.loss import LossKind
from sdfcheck.convert.urdf_to_sdf.context import Context
from sdfcheck.convert.writer import Node, spaced
from sdfcheck.lint.diagnostic import Severity
from sdfcheck.source.element import Element


class Materials:
    """The materials of a robot, by name; the first definition of a name counts, as with urdfdom."""

    def __init__(self, root: Element, context: Context) -> None:
        self.context = context
        self.uri: Callable[[Element, str], str] = lambda element, text: text
        self.named: dict[str, Element] = {}
        inline = (
            material
            for link in root.children("link")
            for visual in link.children("visual")
            for material in visual.children("material")
        )
        for material in (*root.children("material"), *inline):
            if _says_something(material):
                self.named.setdefault(material.attributes.get("name", ""), material)

    def write(self, used: Element, visual: Node) -> None:
        """The material of a visual."""
        name = used.attributes.get("name", "")
        found = self.named.get(name, used) if name else used
        if not _says_something(found):
            text = f"material `{name}` is not defined; the visual gets no colour"
            self.context.lose(used, LossKind.CHANGED_MATERIAL, text)
            return
        node = visual.add("material")
        color, texture = found.find("color"), found.find("texture")
        rgba = spaced(color.attributes.get("rgba", "")) if color is not None else ""
        if rgba:
            node.add("ambient", rgba)
            node.add("diffuse", rgba)
        if texture is not None:
            self._texture(texture, node)
        if not node.children:
            visual.children.remove(node)

    def _texture(self, texture: Element, node: Node) -> None:
        file = texture.attributes.get("filename", "").strip()
        if not file:
            return
        context = self.context
        if not context.allows("link/visual/material/pbr"):
            text = f"SDFormat {context.options.version} has no place for texture `{file}`"
            context.lose(texture, LossKind.CHANGED_MATERIAL, text)
            return
        node.reach("pbr", "metal").add("albedo_map", self.uri(texture, file))
        if node.find("diffuse") is None:
            # Without a colour of its own the map would be multiplied by black.
            node.add("diffuse", "1 1 1 1")
        if context.once(f"texture {file}"):
            text = f"texture `{file}` becomes an albedo map, which classic Gazebo does not show"
            context.lose(texture, LossKind.CHANGED_MATERIAL, text, Severity.INFO)


def _says_something(material: Element) -> bool:
    return material.has("color") or material.has("texture")

"""Materials: colors as they are, textures as albedo maps."""

from __future__ import annotations

from collections.abc import Callable

from sdfcheck.convert.loss import LossKind
from sdfcheck.convert.urdf_to_sdf.context import Context
from sdfcheck.convert.writer import Node, numbers, spaced
from sdfcheck.formats.sdf.values import floats
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
        self.defined = list(root.children("material"))
        for material in (*self.defined, *inline):
            if _says_something(material):
                self.named.setdefault(material.attributes.get("name", ""), material)

    def write(self, used: Element, visual: Node) -> None:
        """The material of a visual."""
        name = used.attributes.get("name", "")
        found = self.named.get(name, used) if name else used
        if not _says_something(found):
            text = f"material `{name}` is not defined; the visual gets no color"
            self.context.lose(used, LossKind.CHANGED_MATERIAL, text)
            return
        if found is not used and _says_something(used):
            self._report_other(used, found)
        node = visual.add("material")
        color, texture = found.find("color"), found.find("texture")
        rgba = self._bounded(color) if color is not None else ""
        if rgba:
            node.add("ambient", rgba)
            self.context.carry(color, node.add("diffuse", rgba))
        elif color is not None:
            self.context.ledger.take(color)
        if texture is not None:
            self._texture(texture, node)
        for part in dict.fromkeys((used, found)):
            self.context.carry(part, node)
        if not node.children and not node.attributes:
            visual.children.remove(node)

    def _bounded(self, color: Element) -> str:
        """The numbers of a color; those out of range, which libsdformat refuses, are the nearest in it."""
        text = spaced(color.attributes.get("rgba", ""))
        values = floats(text)
        if values is None or all(0 <= value <= 1 for value in values):
            return text
        inside = numbers(min(max(value, 0.0), 1.0) for value in values)
        message = f"color {text} becomes {inside}: SDFormat has numbers from 0 to 1 only"
        self.context.note(color, LossKind.CHANGED_MATERIAL, message)
        return inside

    def _report_other(self, used: Element, found: Element) -> None:
        """A material that is defined once more."""
        for name, attribute in (("color", "rgba"), ("texture", "filename")):
            part, first = used.find(name), found.find(name)
            texts = [spaced(p.attributes.get(attribute, "")) if p is not None else "" for p in (part, first)]
            if part is not None and texts[0] == texts[1]:
                self.context.ledger.take(part)
            elif part is not None:
                text = (
                    f"<{name}> of {used.title} is left out: its first definition says otherwise, and counts"
                )
                self.context.lose(part, LossKind.CHANGED_MATERIAL, text, Severity.INFO)

    def close(self) -> None:
        """Report the definitions that no visual uses."""
        for material in self.defined:
            if not self.context.ledger.is_entered(material):
                text = f"{material.title} is left out: no visual uses it"
                self.context.lose(material, LossKind.DROPPED_ELEMENT, text, Severity.INFO)

    def _texture(self, texture: Element, node: Node) -> None:
        file = texture.attributes.get("filename", "").strip()
        context = self.context
        if not file:
            context.ledger.take(texture)
            return
        if not context.allows("link/visual/material/pbr"):
            text = f"SDFormat {context.options.version} has no place for texture `{file}`"
            context.lose(texture, LossKind.CHANGED_MATERIAL, text)
            return
        context.carry(texture, node.reach("pbr", "metal").add("albedo_map", self.uri(texture, file)))
        if node.find("diffuse") is None:
            # Without a color of its own the map would be multiplied by black.
            node.add("diffuse", "1 1 1 1")
        if context.once(f"texture {file}"):
            text = f"texture `{file}` becomes an albedo map, which classic Gazebo does not show"
            context.note(texture, LossKind.CHANGED_MATERIAL, text, Severity.INFO)


def _says_something(material: Element) -> bool:
    return material.has("color") or material.has("texture")

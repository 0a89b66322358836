"""Colors: the one part of a material that URDF has."""

from __future__ import annotations

from sdfcheck.convert.ledger import TEXT
from sdfcheck.convert.loss import LossKind
from sdfcheck.convert.sdf_to_urdf.context import Context
from sdfcheck.convert.sdf_to_urdf.custom import carry_custom, has_custom
from sdfcheck.convert.writer import Node, numbers
from sdfcheck.formats.sdf.values import floats
from sdfcheck.lint.diagnostic import Severity
from sdfcheck.source.element import Element

_TEXTURE = "drake:diffuse_map"


def add_color(context: Context, node: Node, visual: Element, scope: str) -> None:
    """Let a visual have the material of its diffuse color, or else of its ambient one."""
    material = visual.find("material")
    if material is None:
        return
    is_kept = context.ledger.is_entered(material)
    context.ledger.take(material)
    diffuse, ambient = material.find("diffuse"), material.find("ambient")
    chosen = diffuse if diffuse is not None else ambient
    color = _rgba(chosen)
    texture = material.find(_TEXTURE)
    if chosen is None or color is None:
        if texture is not None:
            carry_custom(context, node.add("material", name=_own_name(context)), material, scope)
        return
    context.ledger.take(chosen, TEXT)
    if ambient is not None and ambient is not chosen and not context.ledger.is_entered(ambient):
        if _rgba(ambient) == color:
            context.ledger.take(ambient, TEXT)
        else:
            message = f"the ambient color {ambient.content} of {visual.title} is left out: URDF has one color"
            context.ledger.lose(LossKind.CHANGED_COLOR, ambient, message, Severity.INFO)
    if texture is None:
        written = node.add("material", name=context.colors[color])
    else:
        written = node.add("material", name=_own_name(context))
        written.add("color", rgba=color)
    if is_kept and texture is None:
        return
    carry_custom(context, written, material, scope)
    if has_custom(chosen):
        # A color of its own, where the definition is shared.
        carry_custom(context, written.add("color", rgba=color), chosen, scope)


def _own_name(context: Context) -> str:
    """A name that no other material has: there may be several of a color with different textures."""
    number = len(context.colors) + 1
    context.colors[f"texture {number}"] = name = f"color_{number}"
    return name


def define_colors(context: Context) -> None:
    """Write the materials of all visuals; the same color is one material."""
    for link in context.robot.links.values():
        for geometry in link.geometries:
            material = geometry.element.find("material") if geometry.role == "visual" else None
            if material is None:
                continue
            diffuse = material.find("diffuse")
            color = _rgba(diffuse if diffuse is not None else material.find("ambient"))
            if color is not None and color not in context.colors:
                context.colors[color] = f"color_{len(context.colors) + 1}"
                context.root.add("material", name=context.colors[color]).add("color", rgba=color)


def _rgba(element: Element | None) -> str | None:
    values = floats(element.content) if element is not None else None
    if values is None or len(values) not in {3, 4}:
        return None
    return numbers((*values, 1.0)[:4])

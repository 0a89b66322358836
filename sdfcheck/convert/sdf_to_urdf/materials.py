"""Colours: the one part of a material that URDF has."""

from __future__ import annotations

from sdfcheck.convert.loss import LossKind
from sdfcheck.convert.sdf_to_urdf.context import Context
from sdfcheck.convert.writer import Node, numbers
from sdfcheck.formats.sdf.values import floats
from sdfcheck.lint.diagnostic import Severity
from sdfcheck.source.element import Element


def add_color(context: Context, node: Node, visual: Element) -> None:
    """Let a visual have the material of its diffuse colour, or else of its ambient one."""
    material = visual.find("material")
    if material is None:
        return
    context.ledger.take(material)
    diffuse, ambient = material.find("diffuse"), material.find("ambient")
    chosen = diffuse if diffuse is not None else ambient
    color = _rgba(chosen)
    if chosen is None or color is None:
        return
    context.ledger.take(chosen)
    if ambient is not None and ambient is not chosen and not context.ledger.is_done(ambient):
        if _rgba(ambient) == color:
            context.ledger.take(ambient)
        else:
            message = (
                f"the ambient colour {ambient.content} of {visual.title} is left out: URDF has one colour"
            )
            context.ledger.lose(LossKind.CHANGED_COLOR, ambient, message, Severity.INFO)
    node.add("material", name=context.colors[color])


def define_colors(context: Context) -> None:
    """Write the materials of all visuals; the same colour is one material."""
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

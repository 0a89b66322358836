"""The end of a conversion: what is around the model, and what nobody entered."""

from __future__ import annotations

from sdfcheck.convert.loss import LossKind
from sdfcheck.convert.sdf_to_urdf.comments import carry_around
from sdfcheck.convert.sdf_to_urdf.context import Context
from sdfcheck.convert.sdf_to_urdf.custom import carry_custom
from sdfcheck.convert.sdf_to_urdf.plan.choose import others
from sdfcheck.source.element import Element


def close(context: Context, models: list[Element]) -> None:
    """Enter what is around the model, and report what nobody entered."""
    at = context.scope.place.parent
    while at is not None:
        context.ledger.take(at)
        carry_custom(context, context.root, at, "")
        carry_around(context, context.root, at)
        at = at.parent
    for other in others(context.scope.place.document, context.scope):
        message = f"{other.title} is not a part of model `{context.scope.name}`"
        context.ledger.lose(LossKind.DROPPED_ELEMENT, other, message)
    for model in models:
        around = model.parent
        while around is not None and not context.ledger.is_entered(around):
            _leave_custom(context, around)
            around = around.parent
    for element in (context.scope.place.document.root, *models):
        if element is not None:
            context.ledger.close(element)


def _leave_custom(context: Context, around: Element) -> None:
    """Custom data of an included file that is not in its model stays there."""
    context.ledger.take(around)
    for name in around.attributes:
        if ":" in name:
            text = f"attribute `{name}` of `{around.name}` in the included file is left out"
            context.ledger.lose_attribute(around, name, text)
    for child in around.children():
        if child.is_custom and not context.ledger.is_entered(child):
            text = f"`{child.name}` in `{around.name}` of the included file is left out"
            context.ledger.lose(LossKind.DROPPED_ELEMENT, child, text)

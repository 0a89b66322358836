"""The books of a conversion: what of the source is in the result, and what is lost.

Every element of the model is entered once: taken (it is said in the result), or lost with
a reason. What nobody entered is reported at the end, so nothing disappears in silence.
"""

from __future__ import annotations

from lxml import etree

from sdfcheck.convert.loss import Loss, LossKind, loss_at
from sdfcheck.lint.diagnostic import Severity
from sdfcheck.source.element import Element
from sdfcheck.source.text import Span

_KINDS = {
    "fluid_added_mass": LossKind.CHANGED_INERTIA,
    "mimic": LossKind.DROPPED_MIMIC,
    "plugin": LossKind.DROPPED_PLUGIN,
    "sensor": LossKind.DROPPED_SENSOR,
    "material": LossKind.CHANGED_MATERIAL,
    "frame": LossKind.DROPPED_FRAME,
}


class Ledger:
    def __init__(self) -> None:
        self.losses: list[Loss] = []
        self._done: set[etree._Element] = set()
        self._reported: set[tuple[LossKind, Span, str]] = set()

    def take(self, *elements: Element | None) -> None:
        """These elements, without what is in them, are said in the result."""
        self._done.update(element for element in elements if element is not None)

    def take_parts(self, element: Element | None, *names: str) -> None:
        """An element and its children of these names, with all that is in those."""
        if element is not None:
            self.take(element)
            for child in element.children():
                if child.name in names:
                    self.take_whole(child)

    def take_whole(self, element: Element) -> None:
        """An element and all elements in it are said in the result."""
        self._done.add(element)
        for child in element.children():
            self.take_whole(child)

    def take_comment(self, comment: etree._Element) -> bool:
        """A comment is in the result; False if it was before."""
        is_new = comment not in self._done
        self._done.add(comment)
        return is_new

    def cover(self, element: Element) -> None:
        """An element is copied as it is, or lost, with everything in it."""
        self.take_whole(element)
        self._done.update(element.iter(etree.Comment))

    def lose(
        self, kind: LossKind, element: Element, message: str, severity: Severity = Severity.WARNING
    ) -> None:
        """An element, with what is in it, is not in the result as it is in the source."""
        self.cover(element)
        self.note(kind, element, message, severity)

    def note(
        self, kind: LossKind, element: Element, message: str, severity: Severity = Severity.WARNING
    ) -> None:
        """Something about an element is not in the result; what is in the element is entered apart."""
        self._done.add(element)
        loss = loss_at(element, kind, message, severity)
        key = (kind, loss.span, message)
        if key not in self._reported:  # an included model may come several times
            self._reported.add(key)
            self.losses.append(loss)

    def is_done(self, element: Element) -> bool:
        return element in self._done

    def close(self, model: Element) -> None:
        """Report what nobody entered."""
        waiting = [model]
        while waiting:
            element = waiting.pop()
            if element not in self._done:
                kind = _KINDS.get(element.name, LossKind.DROPPED_ELEMENT)
                self.lose(kind, element, f"URDF has no {element.title}{_value(element)} {_where(element)}")
            else:
                waiting.extend(element.children())
        for comment in model.iter(etree.Comment):
            holder = comment.getparent()
            if comment not in self._done and isinstance(holder, Element):
                words = " ".join((comment.text or "").split())
                shown = words if len(words) <= 30 else f"{words[:30]}…"
                message = f"a comment in {holder.title} is left out: `{shown}`"
                self.note(LossKind.DROPPED_COMMENT, holder, message, Severity.INFO)


def _value(element: Element) -> str:
    text = element.content
    return f" ({text})" if text and len(text) <= 30 and next(element.children(), None) is None else ""


def _where(element: Element) -> str:
    parent = element.parent
    return f"in {parent.title}" if parent is not None else "here"

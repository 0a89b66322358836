"""Parts that a conversion could not carry over as they were."""

from __future__ import annotations

from sdfcheck.convert.loss_kind import FAMILY, LossKind
from sdfcheck.lint.diagnostic import Diagnostic, Label, Origin, Severity
from sdfcheck.source.element import Element
from sdfcheck.source.record import Record
from sdfcheck.source.text import Span

__all__ = ("FAMILY", "Loss", "LossKind", "NotConvertible", "loss_at", "refusal", "to_diagnostic")


class Loss(Record):
    """One thing that is not in the result as it is in the source; ``span`` is its place there.

    ``labels`` are other places that take part; ``origins`` lead from a place in a macro
    or an included file to the file that was converted.
    """

    kind: LossKind
    span: Span
    message: str
    severity: Severity = Severity.WARNING
    labels: tuple[tuple[Span, str], ...] = ()
    origins: tuple[tuple[Span, str], ...] = ()

    def at(self, span: Span) -> Loss:
        """The same at another place."""
        return Loss(self.kind, span, self.message, self.severity, self.labels, self.origins)


class NotConvertible(Exception):
    """The source cannot be converted at all; ``loss`` says what is in the way, and where."""

    def __init__(self, loss: Loss) -> None:
        super().__init__(loss.message)
        self.loss = loss


def loss_at(element: Element, kind: LossKind, message: str, severity: Severity = Severity.WARNING) -> Loss:
    """A loss at an element of the source, with the macro calls that led to it."""
    steps = tuple((step.span, step.text) for step in element.document.origins(element))
    return Loss(kind, element.span, message, severity, (), steps)


def refusal(element: Element, message: str) -> NotConvertible:
    """The exception for an element that is in the way of the whole conversion."""
    return NotConvertible(loss_at(element, LossKind.NOT_CONVERTIBLE, message, Severity.ERROR))


def to_diagnostic(loss: Loss) -> Diagnostic:
    """The loss as reports show it."""
    return Diagnostic(
        loss.kind.code,
        loss.kind.title,
        loss.severity,
        loss.message,
        loss.span,
        tuple(Label(span, text) for span, text in loss.labels),
        None,
        None,
        tuple(Origin(span, text) for span, text in loss.origins),
    )

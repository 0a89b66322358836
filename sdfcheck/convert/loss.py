"""What a conversion could not carry over as it was."""

from __future__ import annotations

from enum import Enum

from sdfcheck.lint.diagnostic import Diagnostic, Label, Origin, Severity
from sdfcheck.source.element import Element
from sdfcheck.source.record import Record
from sdfcheck.source.text import Span


class LossKind(Enum):
    """The kinds of loss: code and name. Neither is ever reused."""

    NOT_CONVERTIBLE = ("CNV001", "not-convertible")
    NOT_VERIFIED = ("CNV002", "not-verified")
    DROPPED_ELEMENT = ("CNV003", "dropped-element")
    APPROXIMATED_JOINT = ("CNV004", "approximated-joint")
    CLOSED_LOOP = ("CNV005", "closed-loop")
    MERGED_MODEL = ("CNV006", "merged-model")
    SHIFTED_LINK_FRAME = ("CNV007", "shifted-link-frame")
    UNSUPPORTED_GEOMETRY = ("CNV008", "unsupported-geometry")
    DROPPED_SENSOR = ("CNV009", "dropped-sensor")
    DROPPED_PLUGIN = ("CNV010", "dropped-plugin")
    RENAMED = ("CNV011", "renamed")
    CHANGED_DEFAULT = ("CNV012", "changed-default")
    DROPPED_COMMENT = ("CNV013", "dropped-comment")
    MASSLESS_LINK = ("CNV014", "massless-link")
    CHANGED_COLOR = ("CNV015", "changed-color")
    EXTENSION_NOT_CARRIED = ("CNV016", "extension-not-carried")
    KEPT_AS_EXTENSION = ("CNV017", "kept-as-extension")
    MERGED_LINK = ("CNV018", "merged-link")
    DROPPED_FRAME = ("CNV019", "dropped-frame")
    DROPPED_MIMIC = ("CNV020", "dropped-mimic")
    CHANGED_MATERIAL = ("CNV021", "changed-material")
    CHANGED_URI = ("CNV022", "changed-uri")
    UNKNOWN_REFERENCE = ("CNV023", "unknown-reference")
    CHANGED_LIMIT = ("CNV024", "changed-limit")
    REVERSED_JOINT = ("CNV025", "reversed-joint")
    CHANGED_INERTIA = ("CNV026", "changed-inertia")
    EXPANDED_INCLUDE = ("CNV027", "expanded-include")
    REORDERED = ("CNV028", "reordered")

    @property
    def code(self) -> str:
        return self.value[0]

    @property
    def title(self) -> str:
        """The kebab-case name."""
        return self.value[1]


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
    """The exception for an element that stands in the way of the whole conversion."""
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

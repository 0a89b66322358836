"""Parts that a conversion could not carry over as they were, and the kinds of such losses."""

from __future__ import annotations

from sdfcheck.lint.diagnostic import Diagnostic, Label, Origin, Severity
from sdfcheck.lint.kinds import FindingKind
from sdfcheck.source.document import Element
from sdfcheck.source.record import Record
from sdfcheck.source.text import Span

# The kinds of loss: what conversions report.


class LossKind(FindingKind):
    """The kinds of loss: name, code, what is lost and why. Neither name nor code is ever reused."""

    NOT_CONVERTIBLE = (
        "CNV001 The target has no way to say what is here, or the source leaves open what is meant; "
        "nothing is written."
    )
    NOT_VERIFIED = (
        "CNV002 The result, read again, is not the same robot as its source; nothing is written. This is "
        "a bug of the converter, please report it."
    )
    DROPPED_ELEMENT = (
        "CNV003 An element or attribute is left out, since the target has no place for it and it does not "
        "matter to how the robot moves."
    )
    APPROXIMATED_JOINT = (
        "CNV004 The target has no such kind of joint; the nearest that it has is written, or none, which "
        "leaves the child free to float."
    )
    CLOSED_LOOP = (
        "CNV005 A joint closes a loop, and the links of a URDF robot make a tree; the joint is kept where "
        "only libsdformat looks."
    )
    MERGED_MODEL = (
        "CNV006 A nested or included model becomes part of the one around it, since the target does not "
        "nest; names get its name in front."
    )
    SHIFTED_LINK_FRAME = (
        "CNV007 The frame of a link moves to its joint, where URDF has it; all that is in the link stays "
        "in place, but poses that others measure in the link's frame change."
    )
    UNSUPPORTED_GEOMETRY = (
        "CNV008 A shape is left out, or another takes its place, since the target does not have it; the "
        "link is seen or touched differently."
    )
    DROPPED_SENSOR = "CNV009 A sensor is left out: the target has no sensors."
    DROPPED_PLUGIN = "CNV010 A plugin is left out: the target has no plugins there."
    RENAMED = (
        "CNV011 Something gets another name, since the target does not allow the one that it has or "
        "something else has it there; what lies in other files and uses the name must follow."
    )
    CHANGED_DEFAULT = (
        "CNV012 A default of the source is another one in the target, so it is written out; the robot "
        "stays the same, unless it is a warning: then consumers ignored in the source what they read now."
    )
    DROPPED_COMMENT = "CNV013 A comment is left out, since what it is in has no counterpart."
    MASSLESS_LINK = (
        "CNV014 A link has no mass, which simulators drop or refuse; a very small mass is written, or the "
        "simulator has to compute one."
    )
    CHANGED_COLOR = "CNV015 A color is left out: the target knows fewer of them for a surface."
    EXTENSION_NOT_CARRIED = (
        "CNV016 A setting of a `<gazebo>` block is left out, since it has no effect where it is or what "
        "it is about is gone."
    )
    KEPT_AS_EXTENSION = (
        "CNV017 An element means nothing in the target; it is kept under a prefix or in a `<gazebo>` "
        "block for those who know it, and comes back when converted back."
    )
    MERGED_LINK = (
        "CNV018 A link becomes part of the one that it is fixed to; its mass, shapes and joints go with "
        "it, and a frame keeps its name where the target has frames."
    )
    DROPPED_FRAME = (
        "CNV019 A frame is left out, since the target has no frames; poses that were relative to it are "
        "written relative to what it was attached to."
    )
    DROPPED_MIMIC = (
        "CNV020 A joint does not follow its leader any more: the target does not know mimic joints of "
        "that kind."
    )
    CHANGED_MATERIAL = (
        "CNV021 A surface looks different: its texture, script or color cannot be said in the target as "
        "it was."
    )
    CHANGED_URI = (
        "CNV022 The address of a file is written in the way in which consumers of the target look for it; "
        "they must know where that is."
    )
    UNKNOWN_REFERENCE = "CNV023 Something refers to what does not exist, and is left out or left as it is."
    CHANGED_LIMIT = (
        "CNV024 A limit is written as another number, or left out, because the target understands the one "
        "that was there otherwise."
    )
    REVERSED_JOINT = (
        "CNV025 A joint's parent and child change places, and its axis turns round: in a tree each link "
        "has one parent."
    )
    CHANGED_INERTIA = (
        "CNV026 The mass properties of a link are computed, or a part of them is left out, because the "
        "target cannot leave them to the simulator."
    )
    EXPANDED_INCLUDE = (
        "CNV027 The included model is written out, since the target does not have such includes; later "
        "changes of the included file have no effect."
    )
    REORDERED = (
        "CNV028 Elements change places because the order says something in the target, such as which link "
        "a model moves with."
    )
    INCLUDED_FILE_KEPT = (
        "CNV029 An include brings a file in a version that is newer than the target. Each file has a "
        "version of its own, and only the one that is named is converted: convert the other one as well."
    )
    UNACCOUNTED_ITEM = (
        "CNV030 The conversion has no record of what became of an item of the source; it is taken as "
        "lost. This is a bug of the converter, please report it."
    )
    UNSOUND_RESULT = (
        "CNV031 The result has an error that its source does not have, so that its consumers refuse it or "
        "read another robot; nothing is written."
    )

    @property
    def is_grave(self) -> bool:
        return self in _GRAVE


_FATAL = frozenset({LossKind.NOT_CONVERTIBLE, LossKind.NOT_VERIFIED, LossKind.UNSOUND_RESULT})
"""For these nothing is written."""
_GRAVE = _FATAL | {
    LossKind.APPROXIMATED_JOINT,
    LossKind.CHANGED_INERTIA,
    LossKind.CLOSED_LOOP,
    LossKind.DROPPED_ELEMENT,
    LossKind.DROPPED_MIMIC,
    LossKind.UNKNOWN_REFERENCE,
    LossKind.UNSUPPORTED_GEOMETRY,
}
"""These can be errors."""
VARYING = frozenset(kind.code for kind in set(LossKind) - _FATAL)
"""The codes of kinds whose severity belongs to the case."""

__all__ = ("Loss", "LossKind", "NotConvertible", "loss_at", "refusal", "to_diagnostic")


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

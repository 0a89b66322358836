"""What moves with what: references followed to the link that carries a frame.

A frame moves with what it is attached to, a joint with its child, a model with its
canonical link. A static model moves with nothing, and is a place of its own. Source:
libsdformat 17's FrameSemantics.cc and parser.cc, checked against what they do.
"""

from __future__ import annotations

from sdfcheck.robot.scopes import MODEL_FRAME, NEVER_A_REFERENCE, Frame, Scope
from sdfcheck.source.element import Element


def look_up(frame: Frame, reference: str) -> Frame | None:
    """What a reference written in ``frame`` names; None if it names nothing that is known."""
    if reference == NEVER_A_REFERENCE:
        return None
    if reference == MODEL_FRAME and (stand_in := own_model(frame)) is not None:
        return stand_in
    return frame.scope.find(reference)


def own_model(frame: Frame) -> Frame | None:
    """What the frame is a part of: the scope's own frame, or what stands for it after a merge.

    None for the scope's own frame itself.
    """
    scope = frame.scope
    if frame is scope.own:
        return None
    holder = frame.element.parent
    if holder is None or holder is scope.element:
        return scope.own
    for other in scope.frames.values():
        if is_merged_model(other) and other is not frame and merged_model(other) is holder:
            return other
    return scope.own


def is_merged_model(frame: Frame) -> bool:
    """Does it stand for the frame of a model that was merged in?"""
    return frame.kind == "frame" and frame.element.tag == "include"


def merged_model(frame: Frame) -> Element | None:
    """The element of the model that such a frame stands for."""
    from sdfcheck.robot.includes.included import included

    return included(frame.element.document, frame.element).model


def carrier(frame: Frame) -> Frame | None:
    """What a frame moves with: a link, the world, or the own frame of a static model.

    None if that cannot be told.
    """
    seen = set()
    at: Frame | None = frame
    while at is not None and at not in seen:
        seen.add(at)
        if at.kind in {"link", "world"}:
            return at
        if at.kind == "model" and at.inner is not None and stands_still(at.inner):
            return at.inner.own
        at = attachment(at)
    return None


def attachment(frame: Frame) -> Frame | None:
    """The next frame on the way to the link that carries a frame; None if there is none."""
    if frame.kind == "model":
        return canonical_link(frame.inner) if frame.inner is not None else None
    if frame.kind == "joint":
        return look_up(frame, child_of(frame))
    if frame.kind != "frame":
        return None
    if is_merged_model(frame):
        return _merged_canonical_link(frame)
    reference = frame.element.attributes.get("attached_to", "").strip()
    return look_up(frame, reference) if reference else own_model(frame)


def child_of(joint: Frame) -> str:
    """The name of a joint's child: the element's text, or in URDF its ``link``."""
    child = joint.element.find("child")
    if child is None:
        return ""
    return child.content or child.attributes.get("link", "").strip()


def canonical_link(scope: Scope) -> Frame | None:
    """What a model moves with: what it names, or its first link, or that of its first nested model."""
    if not scope.complete:
        return None
    named = scope.element.attributes.get("canonical_link", "").strip()
    if named:
        return scope.find(named)
    first = next(scope.links(), None)
    if first is not None:
        return first
    return next((frame for frame in scope.frames.values() if frame.kind == "model"), None)


def stands_still(scope: Scope) -> bool:
    """Is the model itself static? One in a static model need not be."""
    if scope.kind != "model":
        return False
    if scope.placed is not None and (given := scope.placed.find("static")) is not None:
        return _is_true(given.content)
    static = scope.element.find("static")
    return static is not None and _is_true(static.content)


def _merged_canonical_link(frame: Frame) -> Frame | None:
    model = merged_model(frame)
    links = (other for other in frame.scope.links() if other.element.parent is model)
    named = model.attributes.get("canonical_link", "").strip() if model is not None else ""
    return frame.scope.find(named) if named else next(links, None)


def _is_true(text: str) -> bool:
    return text.strip().lower() in {"true", "1"}

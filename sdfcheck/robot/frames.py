"""Frames: does every reference name one, and do attachments and poses lead somewhere?

Two graphs lie over the names of a scope. *Attachment* says what a frame moves with: a
frame with what it is attached to, a joint with its child, a model with its canonical
link. *Pose* says where a frame is: relative to what. In both each frame has one way
on, so a fault is a reference to nothing or a ring. Source: libsdformat 17's
FrameSemantics.cc and parser.cc, checked against what they report.
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

from sdfcheck.formats.sdf.survey import survey
from sdfcheck.formats.sdf.version import Version
from sdfcheck.robot.scopes import NEVER_A_REFERENCE, Frame, Scope, Scopes, scopes
from sdfcheck.source.document import Document
from sdfcheck.source.element import Element, Value
from sdfcheck.source.record import Record

_POSE_FRAMES = frozenset({"link", "joint", "frame", "model", "include"})
"""Elements whose own pose places a frame of the enclosing scope."""

_SEVEN = Version(1, 7)


class UnknownFrame(Record):
    """A reference that names no frame in its scope.

    ``role`` is the attribute. ``suggestion`` is a near miss, or the scoped name by which
    a frame of that name in a nested model can be reached. ``outside``: an enclosing
    scope has the name, which cannot be reached from here.
    """

    value: Value
    role: str
    scope: Element
    suggestion: str | None
    outside: Element | None


class TopLevelPose(Record):
    """The pose of a model at the top of the file is relative to a frame, and there is none."""

    value: Value


class FrameCycle(Record):
    """Frames that are attached to, or placed relative to, each other in a ring.

    ``members`` are the references that make the ring, ``names`` the frames that hold
    them; both begin with the first in document order.
    """

    role: str
    members: tuple[Value, ...]
    names: tuple[str, ...]


class UnknownCanonicalLink(Record):
    """``canonical_link`` names nothing, or (``found``) something that is not a link."""

    value: Value
    found: str | None
    suggestion: str | None


class UnknownPlacementFrame(Record):
    """``placement_frame``, of a model or of the include that brings it, names nothing in the model."""

    value: Value
    suggestion: str | None


class ModelWithoutLink(Record):
    """A model that is not static and holds neither link nor nested model."""

    element: Element


Problem = (
    UnknownFrame | TopLevelPose | FrameCycle | UnknownCanonicalLink | UnknownPlacementFrame | ModelWithoutLink
)


def problems(document: Document) -> list[Problem]:
    """Everything about frames that is wrong in an SDF document, in no particular order."""
    return _Analysis(document).run()


class _Analysis:
    def __init__(self, document: Document) -> None:
        self.document = document
        self.survey = survey(document)
        self.scopes: Scopes = scopes(document)
        self.found: list[Problem] = []
        self.relative_to: dict[Element, Value] = {}
        """Element → the reference of its own pose, where the pose makes a frame."""

    def run(self) -> list[Problem]:
        index = self.survey.index
        for pose in index.get("pose", ()):
            if items := pose.items():
                self.look_at_pose(pose, items)
        for axis in index.get("xyz", ()):
            self.look_at_reference(axis, "expressed_in")
        for frame in index.get("frame", ()):
            self.look_at_reference(frame, "attached_to")
        for scope in self.scopes.all():
            if scope.kind == "model":
                self.look_at_model(scope)
        for placement in index.get("placement_frame", ()):
            self.look_at_placement(placement)
        if index.get("frame") or self.relative_to:
            from sdfcheck.robot.frame_cycles import frame_cycles

            self.found += frame_cycles(self.scopes, self.relative_to)
        return self.found

    # References

    def look_at_pose(self, pose: Element, items: Iterable[tuple[Any, Any]]) -> None:
        for name, text in items:
            if name not in {"relative_to", "frame"} or not text.strip():
                continue
            owner = pose.parent
            assert owner is not None
            if owner.tag == "inertial" or (name == "frame" and self.survey.version >= _SEVEN):
                continue  # nobody reads it
            value = Value(pose, name, text)
            scope = self.scopes.of(owner)
            if scope is None:
                if owner.tag in {"model", "include"}:
                    self.found.append(TopLevelPose(value))
                continue
            if owner.tag in _POSE_FRAMES:
                self.relative_to[owner] = value
            if self.find(scope, value) is None:
                self.unknown(scope, value, "relative_to")

    def look_at_reference(self, element: Element, role: str) -> None:
        value = element.attribute(role)
        if value is None or not value.text.strip():
            return
        scope = self.scopes.of(element)
        if scope is not None and self.find(scope, value) is None:
            self.unknown(scope, value, role)

    def find(self, scope: Scope, value: Value) -> Frame | None:
        text = value.text.strip()
        return None if text == NEVER_A_REFERENCE else scope.find(text)

    def unknown(self, scope: Scope, value: Value, role: str) -> None:
        name = value.text.strip()
        if "" in name.split("::") or scope.may_hold(name):
            return
        from sdfcheck.robot.near_names import near_names

        owner = value.element.parent if value.element.tag == "pose" else value.element
        own = owner.attributes.get("name", "") if owner is not None else ""
        meant, outside = near_names(self.document).guess(scope, name, but=(own,))
        self.found.append(UnknownFrame(value, role, scope.element, meant, outside))

    # Models

    def look_at_model(self, scope: Scope) -> None:
        if not any(frame.kind in {"link", "model"} for frame in scope.frames.values()):
            self.look_at_bare_model(scope)
        link = scope.element.attribute("canonical_link")
        if link is not None and link.text.strip():
            self.look_at_canonical_link(scope, link)
        placement = scope.element.attribute("placement_frame")
        if placement is not None and placement.text.strip():
            self.look_at_placement_in(scope, placement)

    def look_at_bare_model(self, scope: Scope) -> None:
        from sdfcheck.robot.carriers import stands_still
        from sdfcheck.robot.includes import is_made_static

        element = scope.element
        # Those without a name are no frames, which is said of them.
        if (
            scope.complete
            and not stands_still(scope)
            and not element.has("link")
            and not element.has("model")
            and not {(element, "link"), (element, "model")} & survey(self.document).misspelled
            and not (scope.parent is None and is_made_static(self.document))
        ):
            self.found.append(ModelWithoutLink(element))

    def look_at_canonical_link(self, scope: Scope, value: Value) -> None:
        from sdfcheck.robot.near_names import near_names

        found = self.find(scope, value)
        name = value.text.strip()
        if found is not None and found.kind == "link":
            return
        if "" in name.split("::") or (found is None and scope.may_hold(name)):
            return
        meant, _ = near_names(self.document).guess(scope, name, kind="link")
        self.found.append(UnknownCanonicalLink(value, found.kind if found else None, meant))

    def look_at_placement(self, placement: Element) -> None:
        """The placement frame of an include: a frame of the model that it brings."""
        include, value = placement.parent, placement.own_value
        if include is None or include.tag != "include" or not value.text:
            return
        from sdfcheck.robot.includes import included

        brought = included(self.document, include)
        if brought.kind == "model" and brought.model is not None:
            scope = self.scopes.of_included(brought, self.scopes.of(include))
            if scope is not None and value.text != NEVER_A_REFERENCE:
                self.look_at_placement_in(scope, value)

    def look_at_placement_in(self, scope: Scope, value: Value) -> None:
        name = value.text.strip()
        if self.find(scope, value) is not None or "" in name.split("::") or scope.may_hold(name):
            return
        from sdfcheck.robot.near_names import near_names

        meant, _ = near_names(self.document).guess(scope, name)
        self.found.append(UnknownPlacementFrame(value, meant))

"""Frames: does every reference name one, and do attachments and poses lead somewhere?

Two graphs lie over the names of a scope. *Attachment* says what a frame moves with: a
frame with what it is attached to, a joint with its child, a model with its canonical
link. *Pose* says where a frame is: relative to what. In both each frame has one way
on, so a fault is a reference to nothing or a ring. Source: libsdformat 17's
FrameSemantics.cc and parser.cc, checked against what they report.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator

from sdfcheck.formats.survey import survey
from sdfcheck.formats.version import Version
from sdfcheck.model.scopes import NEVER_A_REFERENCE, Frame, Scope, Scopes, scopes
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
    """The pose of a model at the top of the file is relative to a frame, and there is none to be relative to."""

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
    value: Value
    suggestion: str | None


class ModelWithoutLink(Record):
    """A model that is not static and holds no link, not even in a nested model."""

    element: Element


Problem = (
    UnknownFrame | TopLevelPose | FrameCycle | UnknownCanonicalLink | UnknownPlacementFrame | ModelWithoutLink
)


def problems(document: Document) -> list[Problem]:
    """Everything about frames that is wrong in an SDF document, in no particular order."""
    return _Analysis(document).run()


class _Analysis:
    def __init__(self, document: Document) -> None:
        self.survey = survey(document)
        self.scopes: Scopes = scopes(document)
        self.relative = "frame" if self.survey.version < _SEVEN else "relative_to"
        self.found: list[Problem] = []
        self.relative_to: dict[Element, Value] = {}
        """Element → the reference of its own pose."""

    def run(self) -> list[Problem]:
        for pose in self.survey.index.get("pose", ()):
            self.look_at_pose(pose)
        for axis in self.survey.index.get("xyz", ()):
            self.look_at_reference(axis, "expressed_in")
        for frame in self.survey.index.get("frame", ()):
            self.look_at_reference(frame, "attached_to")
        for scope in self.scopes.all():
            if scope.kind == "model":
                self.look_at_model(scope)
        if self.survey.index.get("frame") or self.survey.index.get("joint") or self.relative_to:
            for role, step in (("attached_to", self.attachment), ("relative_to", self.placement)):
                self.look_for_cycles(role, step)
        return self.found

    # References

    def look_at_pose(self, pose: Element) -> None:
        for name, text in pose.items():
            if name not in {"relative_to", "frame"} or not text.strip():
                continue
            if name == "frame" and self.survey.version >= _SEVEN:
                continue
            owner = pose.parent
            assert owner is not None
            value = Value(pose, name, text)
            if owner.tag in _POSE_FRAMES:
                self.relative_to[owner] = value
            scope = self.scopes.of(owner)
            if scope is None:
                if owner.tag in {"model", "include"}:
                    self.found.append(TopLevelPose(value))
                continue
            if self.find(scope, value) is None:
                self.unknown(scope, value, "relative_to")

    def look_at_reference(self, element: Element, role: str) -> None:
        value = element.attribute(role)
        scope = self.scopes.of(element)
        if value is None or not value.text.strip() or scope is None:
            return
        if self.find(scope, value) is None:
            self.unknown(scope, value, role)

    def find(self, scope: Scope, value: Value) -> Frame | None:
        text = value.text.strip()
        return None if text == NEVER_A_REFERENCE else scope.find(text)

    def unknown(self, scope: Scope, value: Value, role: str) -> None:
        if "" not in value.text.strip().split("::") and not scope.may_hold(value.text.strip()):
            suggestion, outside = guess(scope, value.text.strip())
            self.found.append(UnknownFrame(value, role, scope.element, suggestion, outside))

    # Models

    def look_at_model(self, scope: Scope) -> None:
        if not scope.is_static and not _has_link(scope):
            self.found.append(ModelWithoutLink(scope.element))
        value = scope.element.attribute("canonical_link")
        if value is not None and value.text.strip():
            self.look_at_canonical_link(scope, value)
        value = scope.element.attribute("placement_frame")
        if value is not None and value.text.strip() and self.find(scope, value) is None:
            name = value.text.strip()
            if not scope.may_hold(name):
                self.found.append(UnknownPlacementFrame(value, guess(scope, name)[0]))

    def look_at_canonical_link(self, scope: Scope, value: Value) -> None:
        found = self.find(scope, value)
        name = value.text.strip()
        if found is not None and found.kind == "link":
            return
        if found is None and scope.may_hold(name):
            return
        links = [n for n in scope.names() if (frame := scope.find(n)) is not None and frame.kind == "link"]
        from sdfcheck.formats.suggest import suggest

        self.found.append(
            UnknownCanonicalLink(value, found.kind if found else None, suggest(name, links))
        )

    # Rings

    def attachment(self, frame: Frame) -> tuple[Value | None, Frame | None]:
        """What a frame moves with, and the reference that says so (None where it is implied)."""
        if frame.kind == "frame":
            value = frame.element.attribute("attached_to")
            return self.follow(frame, value) if value else (None, None)
        if frame.kind == "joint" and (child := frame.element.find("child")) is not None:
            return self.follow(frame, child.own_value)
        return None, None

    def placement(self, frame: Frame) -> tuple[Value | None, Frame | None]:
        """What a frame is placed relative to, and the reference that says so."""
        value = self.relative_to.get(frame.element)
        if value is not None:
            return self.follow(frame, value)
        return self.attachment(frame)

    def follow(self, frame: Frame, value: Value) -> tuple[Value | None, Frame | None]:
        return value, self.find(frame.scope, value)

    def look_for_cycles(
        self, role: str, step: Callable[[Frame], tuple[Value | None, Frame | None]]
    ) -> None:
        done: set[Frame] = set()
        for scope in self.scopes.all():
            for start in scope.frames.values():
                path: dict[Frame, Value | None] = {}
                at: Frame | None = start
                while at is not None and at not in done and at not in path:
                    path[at], at = step(at)
                if at is not None and at in path:
                    self.report_cycle(role, path, at)
                done.update(path)

    def report_cycle(self, role: str, path: dict[Frame, Value | None], first: Frame) -> None:
        frames = list(path)
        ring = frames[frames.index(first) :]
        if role == "relative_to" and not any(frame.element in self.relative_to for frame in ring):
            return  # the ring of attachments, told already
        members = [(value, frame) for frame in ring if (value := path[frame]) is not None]
        start = min(range(len(members)), key=lambda i: members[i][0].span.start)
        members = members[start:] + members[:start]
        values = tuple(value for value, _ in members)
        if all(frame.kind == "joint" for frame in ring):
            return  # a joint that names itself is said of the joint
        self.found.append(FrameCycle(role, values, tuple(frame.name for _, frame in members)))


def guess(scope: Scope, name: str) -> tuple[str | None, Element | None]:
    """The name that was probably meant, and the element of an outer scope that has the name as written."""
    names = list(scope.names())
    deeper = [candidate for candidate in names if candidate.endswith(f"::{name}")]
    outside = _outside(scope, name)
    if len(deeper) == 1:
        return deeper[0], None
    if outside is not None:
        return None, outside
    from sdfcheck.formats.suggest import suggest

    return suggest(name, names), None


def _outside(scope: Scope, name: str) -> Element | None:
    at = scope.parent
    while at is not None:
        found = at.find(name)
        if found is not None:
            return found.element
        at = at.parent
    return None


def _has_link(scope: Scope) -> bool:
    if not scope.complete or any(f.kind == "link" for f in scope.frames.values()):
        return True
    return any(
        frame.kind == "model" and (frame.inner is None or frame.inner.is_static or _has_link(frame.inner))
        for frame in scope.frames.values()
    )


def frames_of(document: Document) -> Iterator[Frame]:
    """Every frame that this document's own elements define, in document order."""
    for scope in scopes(document).all():
        yield from scope.frames.values()

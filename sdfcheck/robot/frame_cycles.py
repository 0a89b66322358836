"""Rings among frames: what is attached to, or placed relative to, itself by way of others."""

from __future__ import annotations

from collections.abc import Callable, Mapping

from sdfcheck.robot.carriers import child_of
from sdfcheck.robot.frames import FrameCycle
from sdfcheck.robot.scopes import Frame, Scope, Scopes
from sdfcheck.source.element import Element, Value

Step = tuple[Value | None, Frame | None]
"""The reference that leads on from a frame (None where it is implied), and where to."""


def frame_cycles(scopes: Scopes, relative_to: Mapping[Element, Value]) -> list[FrameCycle]:
    """The rings of this document's frames; ``relative_to`` are the references of their poses."""
    return _Search(scopes, relative_to).run()


class _Search:
    def __init__(self, scopes: Scopes, relative_to: Mapping[Element, Value]) -> None:
        self.scopes = scopes
        self.relative_to = relative_to
        self.found: list[FrameCycle] = []
        self.models: dict[Scope, Frame] = {}
        """Scope → the frame that its model makes in the scope around it."""
        for scope in scopes.all():
            for frame in scope.frames.values():
                if frame.kind == "model" and (inner := scopes.by_element.get(frame.element)) is not None:
                    self.models[inner] = frame

    def run(self) -> list[FrameCycle]:
        self.search("attached_to", self.attachment)
        self.search("relative_to", self.placement)
        return self.found

    def attachment(self, frame: Frame) -> Step:
        """What a frame moves with."""
        if frame.kind == "frame":
            value = frame.element.attribute("attached_to")
            return self.follow(frame, value) if value else (None, None)
        if frame.kind == "joint" and (child := frame.element.find("child")) is not None:
            value = Value(child, None, child_of(frame))
            return self.follow(frame, value)
        return None, None

    def placement(self, frame: Frame) -> Step:
        """What a frame is placed relative to: at the end, the model around it."""
        value = self.relative_to.get(frame.element)
        reference, on = (None, None)
        if frame is not frame.scope.own:
            reference, on = self.follow(frame, value) if value is not None else self.attachment(frame)
        if reference is not None:
            return reference, on
        return None, self.models.get(frame.scope)

    def follow(self, frame: Frame, value: Value) -> Step:
        return value, frame.scope.find(value.text.strip())

    def search(self, role: str, step: Callable[[Frame], Step]) -> None:
        done: set[Frame] = set()
        for scope in self.scopes.all():
            for start in scope.frames.values():
                path: dict[Frame, Value | None] = {}
                at: Frame | None = start
                while at is not None and at not in done and at not in path:
                    path[at], at = step(at)
                if at is not None and at in path:
                    self.report(role, path, at)
                done.update(path)

    def report(self, role: str, path: Mapping[Frame, Value | None], first: Frame) -> None:
        frames = list(path)
        ring = frames[frames.index(first) :]
        if all(frame.kind == "joint" for frame in ring):
            return  # a joint that names itself is said of the joint
        if role == "relative_to" and not any(frame.element in self.relative_to for frame in ring):
            return  # the ring of attachments, told already
        members = [(value, frame.name) for frame in ring if (value := path[frame]) is not None]
        start = min(range(len(members)), key=lambda i: members[i][0].span.start)
        members = members[start:] + members[:start]
        self.found.append(
            FrameCycle(role, tuple(value for value, _ in members), tuple(name for _, name in members))
        )
